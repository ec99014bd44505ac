// SPDX-License-Identifier: GPL-3.0-or-later
// Flows with known results: rotation, merging and splitting, preserved topology under random motion.
#include <Eigen/Geometry>

#include "core/random.h"
#include "dsc2d/deform/deformer.h"
#include "dsc2d/generate/insert_polygon.h"
#include "dsc2d/generate/structured.h"
#include "tests/dsc2d/support.h"
#include "tests/support/seed.h"

using namespace dsc::dsc2d;
using dsc::motion::TopologyPolicy;
using dsc::tests::circle;
using dsc::tests::component_count;
using dsc::tests::require_valid;
using std::numbers::pi;

namespace {

std::vector<VertexId> interface_vertices(const Complex& complex) {
    std::vector<VertexId> vertices;
    for (std::uint32_t i = 0; i < complex.vertex_capacity(); ++i) {
        const VertexId v(i);
        if (!complex.is_deleted(v) && complex.is_interface(v) && !complex.is_boundary(v)) vertices.push_back(v);
    }
    return vertices;
}

bool touches(const Complex& complex, VertexId v, int label) {
    for (const HalfedgeId h : complex.outgoing(v))
        if (!complex.is_boundary(h) && complex.label(complex.face(h)) == label) return true;
    return false;
}

template <class Velocity>
StepReport advance(Complex& complex, Deformer& deformer, Velocity velocity) {
    std::vector<std::optional<Point2>> targets(complex.vertex_capacity());
    for (const VertexId v : interface_vertices(complex))
        if (!complex.is_locked(v)) targets[v.index()] = complex.position(v) + velocity(v);
    return deformer.step(targets);
}

Parameters with(double edge_length, TopologyPolicy topology) {
    Parameters parameters;
    parameters.edge_length = edge_length;
    parameters.topology = topology;
    return parameters;
}

}  // namespace

TEST_CASE("a rotated curve keeps its area to 1e-12 per step") {
    Complex complex = structured_complex(Domain::box({-2, -2}, {2, 2}), 20, 20);
    std::vector<Point2> star;
    for (int i = 0; i < 90; ++i) {
        const double angle = 2 * pi * i / 90;
        star.push_back((1.0 + 0.35 * std::cos(5 * angle)) * Point2(std::cos(angle), std::sin(angle)));
    }
    const auto front = insert_polygon(complex, star, 1);
    Deformer deformer(complex, with(0.12, TopologyPolicy::adaptive));
    constexpr int steps = 200;
    const Eigen::Rotation2D<double> turn(2 * pi / steps);
    double area = labelled_area(complex, 1);
    for (int step = 0; step < steps; ++step) {
        const StepReport report = advance(
            complex, deformer, [&](VertexId v) { return Point2(turn * complex.position(v) - complex.position(v)); });
        REQUIRE(report.is_complete);
        REQUIRE(report.counts.topology_changes == 0);
        require_valid(complex);
        const double now = labelled_area(complex, 1);
        REQUIRE(std::abs(now - area) <= 1e-12);
        area = now;
        REQUIRE(std::abs(total_area(complex) - complex.domain().area()) <= 1e-12 * complex.domain().area());
    }
    for (std::size_t i = 0; i < front.size(); ++i) CHECK((complex.position(front[i]) - star[i]).norm() < 1e-10);
}

TEST_CASE("two growing discs merge, and a squeezed one splits") {
    Complex complex = structured_complex(Domain::box({-3, -2}, {3, 2}), 30, 20);
    insert_polygon(complex, circle({-0.85, 0.013}, 0.7, 60), 1);
    insert_polygon(complex, circle({0.85, 0}, 0.7, 60), 1);
    CHECK(component_count(complex, 1) == 2);
    Parameters parameters = with(0.08, TopologyPolicy::adaptive);
    parameters.interface_max_edge = 1.5;
    parameters.interface_min_edge = 0.4;
    Deformer deformer(complex, parameters);
    const auto normal = [&](VertexId v) {
        Point2 sum = Point2::Zero();
        for (const HalfedgeId h : complex.outgoing(v)) {
            if (!complex.is_interface(h)) continue;
            const Point2 u = complex.vector(h).normalized();
            const bool inside_left = complex.label(complex.face(h)) == 1;
            sum += inside_left ? Point2(u.y(), -u.x()) : Point2(-u.y(), u.x());
        }
        return sum.norm() > 1e-9 ? Point2(sum.normalized()) : Point2(Point2::Zero());
    };
    std::size_t changes = 0;
    for (int step = 0; step < 20; ++step) {
        changes +=
            advance(complex, deformer, [&](VertexId v) { return Point2(0.02 * normal(v)); }).counts.topology_changes;
        require_valid(complex);
    }
    CHECK(changes > 0);
    CHECK(component_count(complex, 1) == 1);
    CHECK(dsc::tests::euler_characteristic(complex, 1) == 1);

    for (int step = 0; step < 200 && component_count(complex, 1) < 2; ++step) {
        advance(complex, deformer, [&](VertexId v) {
            const Point2 p = complex.position(v);
            return Point2(0.0, -0.03 * std::exp(-12 * p.x() * p.x()) * (p.y() > 0 ? 1.0 : -1.0));
        });
        require_valid(complex);
    }
    CHECK(component_count(complex, 1) == 2);
    CHECK(std::abs(total_area(complex) - complex.domain().area()) <= 1e-12 * complex.domain().area());
}

TEST_CASE("merge_only and split_only stop the other change") {
    for (const TopologyPolicy policy : {TopologyPolicy::merge_only, TopologyPolicy::split_only}) {
        Complex complex = structured_complex(Domain::box({-3, -2}, {3, 2}), 30, 20);
        insert_polygon(complex, circle({-0.85, 0.013}, 0.7, 60), 1);
        insert_polygon(complex, circle({0.85, 0}, 0.7, 60), 1);
        Deformer deformer(complex, with(0.08, policy));
        std::size_t contacts = 0;
        for (int step = 0; step < 20; ++step) {
            contacts += advance(complex, deformer, [&](VertexId v) {
                            return Point2(complex.position(v).x() > 0 ? -0.02 : 0.02, 0.0);
                        }).contacts.size();
            require_valid(complex);
        }
        CHECK(component_count(complex, 1) == (policy == TopologyPolicy::merge_only ? 1 : 2));
        CHECK((contacts > 0) == (policy == TopologyPolicy::split_only));
    }
}

TEST_CASE("preserved topology keeps components and genus under 1000 random steps") {
    Complex complex = structured_complex(Domain::torus(Eigen::Matrix2d::Identity()), 8, 8);
    insert_polygon(complex, circle({0.3, 0.3}, 0.2, 24), 1);
    insert_polygon(complex, circle({0.75, 0.7}, 0.2, 24), 2);
    insert_polygon(complex, circle({0.75, 0.7}, 0.08, 12), 0);
    Parameters parameters = with(0.05, TopologyPolicy::preserved);
    parameters.interface_min_edge = 0.4;
    Deformer deformer(complex, parameters);
    dsc::core::Random random(dsc::tests::seed(17));
    const int components[3] = {component_count(complex, 0), component_count(complex, 1), component_count(complex, 2)};
    const int genus[3] = {dsc::tests::euler_characteristic(complex, 0), dsc::tests::euler_characteristic(complex, 1),
                          dsc::tests::euler_characteristic(complex, 2)};
    std::size_t contacts = 0;
    for (int step = 0; step < 1000; ++step) {
        const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), phase = random.uniform(0, 2 * pi);
        const StepReport report = advance(complex, deformer, [&](VertexId v) {
            const Point2 p = complex.position(v);
            const double wave = std::sin(2 * pi * (p.x() + p.y()) + phase);
            // Disc 1 is pushed against ring 2; the waves and the jitter reverse often enough not to fold the curves.
            const double push = touches(complex, v, 1) ? 0.0005 : 0.0;
            return Point2(0.002 * Point2(x * wave, y * std::cos(2 * pi * (p.x() - p.y()) - phase)) +
                          0.0005 * Point2(random.uniform(-1, 1), random.uniform(-1, 1)) + Point2(push, push));
        });
        contacts += report.contacts.size();
        // Held vertices are let go again, so that the motion goes on for all of the thousand steps.
        for (const VertexId v : interface_vertices(complex)) complex.unlock(v);
        require_valid(complex);
        for (int label = 0; label < 3; ++label) {
            REQUIRE(component_count(complex, label) == components[label]);
            REQUIRE(dsc::tests::euler_characteristic(complex, label) == genus[label]);
        }
        REQUIRE(std::abs(total_area(complex) - 1.0) <= 1e-12);
        REQUIRE(complex.vertex_count() < 2000);
        if (complex.garbage_fraction() > 0.5) complex.compact();
    }
    CHECK(contacts > 0);
}

TEST_CASE("a disc that is carried along pushes the mesh out of its way") {
    Complex complex = structured_complex(Domain::cylinder({4, 0}, {0, 1}), 40, 10);
    insert_polygon(complex, circle({0.5, 0.5}, 0.3, 40), 1);
    Parameters parameters = with(0.05, TopologyPolicy::preserved);
    parameters.needle_angle = 0.05;
    Deformer deformer(complex, parameters);
    const double area = labelled_area(complex, 1);
    for (int step = 0; step < 400; ++step) {
        const StepReport report = advance(complex, deformer, [](VertexId) { return Point2(0.03, 0.0); });
        REQUIRE(report.is_complete);
        REQUIRE(report.contacts.empty());
        require_valid(complex);
    }
    CHECK(std::abs(labelled_area(complex, 1) - area) < 1e-10);
}
