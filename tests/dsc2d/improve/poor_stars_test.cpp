// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/improve/poor_stars.h"

#include "core/random.h"
#include "dsc2d/generate/insert_polygon.h"
#include "dsc2d/generate/structured.h"
#include "dsc2d/improve/delaunay.h"
#include "dsc2d/improve/detail_control.h"
#include "dsc2d/interface.h"
#include "geometry/triangle.h"
#include "tests/dsc2d/support.h"
#include "tests/support/seed.h"

using namespace dsc::dsc2d;
using dsc::tests::circle;
using dsc::tests::min_angle;
using dsc::tests::require_valid;
using std::numbers::pi;

namespace {

// One pass over all vertices.
template <class Pass>
StepReport run(Complex& complex, const Parameters& parameters, Pass pass) {
    ActiveSet active(complex);
    for (std::uint32_t i = 0; i < complex.vertex_capacity(); ++i)
        if (!complex.is_deleted(VertexId(i))) active.add(VertexId(i));
    Listener listener;
    StepReport report;
    PassContext context{complex, parameters, active, listener, report};
    pass(context);
    return report;
}

}  // namespace

TEST_CASE("poor stars get better, none gets worse, and the interface stays") {
    Complex complex = structured_complex(Domain::box({-1, -1}, {1, 1}), 20, 20);
    const auto front = insert_polygon(complex, circle({0, 0}, 0.5, 40), 1);
    std::vector<Point2> places;
    for (const VertexId v : front) places.push_back(complex.position(v));
    Parameters parameters{.edge_length = 0.1};
    const double first = min_angle(complex);
    run(complex, parameters, mend_poor_stars);
    CHECK(min_angle(complex) == first);  // without a poor angle nothing is done

    parameters.poor_angle = 25 * pi / 180;
    for (int sweep = 0; sweep < 6; ++sweep) {
        const double before = min_angle(complex);
        run(complex, parameters, mend_poor_stars);
        REQUIRE(min_angle(complex) >= before);
        require_valid(complex);
        DelaunayPass(complex).run_everywhere(complex);
    }
    CHECK(min_angle(complex) > 20 * pi / 180);
    for (std::size_t i = 0; i < front.size(); ++i) CHECK(complex.position(front[i]) == places[i]);
    CHECK(Interface(complex).segments.size() == 40);
}

TEST_CASE("the smallest angle of a star, and a sign for one that would turn over") {
    const Complex complex = structured_complex(Domain::box({0, 0}, {2, 2}), 2, 2);
    for (std::uint32_t i = 0; i < complex.vertex_capacity(); ++i) {
        if (complex.is_boundary(VertexId(i))) continue;
        CHECK(min_angle_of_star(complex, VertexId(i)) == Approx(pi / 4));
        CHECK(min_angle_of_star(complex, VertexId(i), {0.5, 0}) < pi / 4);
        CHECK(min_angle_of_star(complex, VertexId(i), {1, 0}) < 0);
    }
}

TEST_CASE("long needles are halved, at an edge off the interface, short ones are left") {
    const std::vector<Point2> points = {{0, 0}, {4, 0}, {4, 0.5}, {0, 0.5}};
    const LatticeVector zero = LatticeVector::Zero();
    for (const int label : {0, 1})
        for (const double length : {1.0, 10.0}) {
            const std::vector<TriangleInput> triangles = {{{0, 1, 2}, {zero, zero, zero}, 0},
                                                          {{0, 2, 3}, {zero, zero, zero}, label}};
            Complex complex(Domain::box({0, 0}, {4, 0.5}), points, triangles);
            Parameters parameters{.edge_length = length};
            parameters.needle_angle = 20 * pi / 180;
            parameters.needle_min_length = 2;
            const StepReport report = run(complex, parameters, split_needles);
            require_valid(complex);
            CHECK((report.counts.edge_splits > 0) == (length == 1.0));
            // The diagonal is the longest edge of both.
            CHECK(Interface(complex).segments.size() == static_cast<std::size_t>(label));
        }
}
