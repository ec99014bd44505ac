// SPDX-License-Identifier: GPL-3.0-or-later
// A front that focuses: towards the concave side its vertices crowd, and the mesh there is fans along the front.
// Nothing may hold the vertices back before the front's own focal point.
#include <algorithm>

#include "dsc2d/deform/deformer.h"
#include "dsc2d/generate/insert_polygon.h"
#include "dsc2d/generate/structured.h"
#include "tests/dsc2d/support.h"

using namespace dsc::dsc2d;
using dsc::tests::circle;
using dsc::tests::require_valid;
using std::numbers::pi;

namespace {

constexpr double spacing = 0.04;
constexpr double half_length = 1.0, half_width = 0.6;                     // of an ellipse
constexpr double focal_distance = half_width * half_width / half_length;  // of its vertices

/// The curve at distance t inside the ellipse.
Point2 inner_parallel(double angle, double t) {
    const Point2 place(half_length * std::cos(angle), half_width * std::sin(angle));
    return place - t * Point2(half_width * std::cos(angle), half_length * std::sin(angle)).normalized();
}

Parameters preserved(double edge_length) {
    Parameters parameters;
    parameters.edge_length = edge_length;
    parameters.topology = dsc::motion::TopologyPolicy::preserved;
    return parameters;
}

struct FocusResult {
    double longest_lag = 0;  // in spacings
    std::size_t contacts = 0;
};

/// Runs a front of steps of half a spacing inward, from the ellipse to `end`.
FocusResult run_inward(const Parameters& parameters, double end) {
    Complex complex = structured_complex(Domain::box({-1.5, -1.5}, {1.5, 1.5}), 12, 12);
    constexpr int count = 128;
    std::vector<Point2> ellipse;
    for (int i = 0; i < count; ++i) ellipse.push_back(inner_parallel(2 * pi * i / count, 0.0));
    const std::vector<VertexId> front = insert_polygon(complex, ellipse, 1);
    Deformer deformer(complex, parameters);
    FocusResult result;
    for (double t = 0.5 * spacing; t <= end; t += 0.5 * spacing) {
        std::vector<std::optional<Point2>> targets(complex.vertex_capacity());
        for (int i = 0; i < count; ++i)
            targets[front[static_cast<std::size_t>(i)].index()] = inner_parallel(2 * pi * i / count, t);
        const StepReport report = deformer.step(targets);
        require_valid(complex);
        for (const auto& motion : report.unfinished)
            result.longest_lag = std::max(result.longest_lag, motion.remaining.norm() / spacing);
        result.contacts += report.contacts.size();
    }
    return result;
}

}  // namespace

TEST_CASE("a focusing front keeps up with its targets until a step before the focal point") {
    const FocusResult result = run_inward(preserved(spacing), focal_distance - spacing);
    CHECK(result.longest_lag == 0.0);
    CHECK(result.contacts == 0);
}

TEST_CASE("a vertex makes its way through the mesh in one substep") {
    for (const bool may_flip : {false, true}) {
        Complex complex = structured_complex(Domain::box({-1, -1}, {1, 1}), 24, 24);
        const std::vector<VertexId> front = insert_polygon(complex, circle({0.011, 0.007}, 0.5, 40), 1);
        Parameters parameters = preserved(0.08);
        parameters.max_substeps = 1;
        if (!may_flip) parameters.flips_on_the_way = 0;
        Deformer deformer(complex, parameters);
        std::vector<std::optional<Point2>> targets(complex.vertex_capacity());
        const Point2 target = complex.domain().snapped(complex.position(front[0]) + Point2(0.08, 0.01));
        targets[front[0].index()] = target;
        const StepReport report = deformer.step(targets);
        require_valid(complex);
        CHECK(report.is_complete == may_flip);
        CHECK((complex.position(front[0]) == target) == may_flip);
        CHECK(report.contacts.empty());
        CHECK(dsc::tests::euler_characteristic(complex, 1) == 1);
    }
}

TEST_CASE("merging an interface edge keeps one curve, and a locked vertex") {
    Complex complex = structured_complex(Domain::box({-1, -1}, {1, 1}), 8, 8);
    const std::vector<VertexId> front = insert_polygon(complex, circle({0.011, 0.007}, 0.5, 40), 1);
    Deformer deformer(complex, preserved(0.08));
    const auto edge_from = [&](VertexId v, VertexId to) {
        for (const HalfedgeId h : complex.outgoing(v))
            if (complex.to(h) == to) return h;
        return HalfedgeId();
    };
    REQUIRE(deformer.merge_interface_edge(edge_from(front[3], front[4])));
    CHECK(complex.is_deleted(front[3]));
    CHECK(complex.is_interface(edge_from(front[2], front[4])));
    complex.lock(front[7]);
    CHECK_FALSE(deformer.merge_interface_edge(edge_from(front[7], front[8])));
    CHECK(deformer.merge_interface_edge(edge_from(front[8], front[7])));
    require_valid(complex);
    CHECK(dsc::tests::component_count(complex, 1) == 1);
    CHECK(dsc::tests::euler_characteristic(complex, 1) == 1);
}
