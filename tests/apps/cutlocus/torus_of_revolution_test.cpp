// SPDX-License-Identifier: GPL-3.0-or-later
// Cut loci on tori of revolution of which points, lines or symmetries are known.
#include "tests/apps/cutlocus/support.h"

using namespace dsc;
using namespace dsc::cutlocus;
using namespace dsc::geodesic;
using namespace dsc::tests;

namespace {

/// Largest distance in the chart from a sample of `a`, after `transform`, to the nearest sample of `b`.
template <class Transform>
double largest_distance(const Metric& metric, const CutGraph& a, const CutGraph& b, const Transform& transform) {
    double largest = 0;
    for (const CutArc& arc : a.arcs)
        for (const CutSample& sample : arc.samples) {
            const Point2 x = transform(sample.x);
            double nearest = 1e300;
            for (const CutArc& other : b.arcs)
                for (const CutSample& candidate : other.samples)
                    nearest = std::min(nearest, chart_distance(metric, x, candidate.x));
            largest = std::max(largest, nearest);
        }
    return largest;
}

template <class Transform>
void check_transformed(const Metric& metric, const CutLocus& a, const CutLocus& b, const Transform& transform) {
    check_certificate(a);
    check_certificate(b);
    REQUIRE(a.graph.vertices.size() == b.graph.vertices.size());
    REQUIRE(a.graph.arcs.size() == b.graph.arcs.size());
    for (const CutVertex& vertex : a.graph.vertices)
        CHECK(distance_to_nearest(metric, vertices_of_degree(b.graph, vertex.degree), transform(vertex.x)) < 1e-8);
    const auto lengths = sorted_lengths(a.graph), others = sorted_lengths(b.graph);
    for (std::size_t i = 0; i < lengths.size(); ++i) CHECK(std::abs(lengths[i] - others[i]) < 1e-8);
    CHECK(largest_distance(metric, a.graph, b.graph, transform) < 1e-8);
}

}  // namespace

TEST_CASE("lambda 2, p on the outer equator: ends and branch points are where they are known to be", "[slow]") {
    const TorusOfRevolution torus(2, 2);
    const CutLocus locus = locus_of(torus, {0, 0});
    check_certificate(locus);
    const auto ends = vertices_of_degree(locus.graph, 1), branches = vertices_of_degree(locus.graph, 3);
    CHECK(ends.size() == 4);
    for (const double u : {-2.155482140, 2.155482140})
        for (const double v : {-0.874816571, 0.874816571}) CHECK(distance_to_nearest(torus, ends, {u, v}) < 1e-8);
    for (const CutVertex& end : ends) CHECK(end.kind == VertexKind::end);
    for (const double u : {-3.013682421, 3.013682421}) CHECK(distance_to_nearest(torus, branches, {u, 0}) < 1e-8);
    CHECK(locus.graph.vertices.size() == 8);
    CHECK(locus.graph.arcs.size() == 9);
}

TEST_CASE("lambda 1, p on the outer equator: equators and meridian, with ends at pi / sqrt 3", "[slow]") {
    const TorusOfRevolution torus(2, 1);
    const CutLocus locus = locus_of(torus, {0, 0});
    check_certificate(locus);
    const double end_u = pi / std::sqrt(3.0);
    const auto ends = vertices_of_degree(locus.graph, 1);
    CHECK(ends.size() == 2);
    CHECK(distance_to_nearest(torus, ends, {end_u, 0}) < 1e-8);
    CHECK(distance_to_nearest(torus, ends, {-end_u, 0}) < 1e-8);
    double worst = 0, shortest_u = pi;
    for (const CutArc& arc : locus.graph.arcs)
        for (const CutSample& sample : arc.samples) {
            const Point2 x = torus_periods.wrapped(sample.x).cwiseAbs();
            worst = std::max(worst, std::min({std::abs(x.x() - pi), std::abs(x.y() - pi), x.y()}));
            if (x.y() < 1e-6) shortest_u = std::min(shortest_u, x.x());
        }
    CHECK(worst < 1e-9);
    CHECK(std::abs(shortest_u - end_u) < 1e-8);
    // Meridian, both equators but for |u| < pi / sqrt 3 of the outer one.
    CHECK(std::abs(locus.graph.length - (2 * pi + 2 * pi + 3 * 2 * (pi - end_u))) < 1e-8);
}

TEST_CASE("mirroring p in the equator's plane mirrors the cut locus", "[slow]") {
    const TorusOfRevolution torus(2, 2);
    check_transformed(torus, locus_of(torus, {0, 0.4}), locus_of(torus, {0, -0.4}),
                      [](const Point2& x) { return Point2(x.x(), -x.y()); });
}

TEST_CASE("turning p about the axis turns the cut locus", "[slow]") {
    const TorusOfRevolution torus(2, 1);
    check_transformed(torus, locus_of(torus, {0, 0.7}), locus_of(torus, {1.234, 0.7}),
                      [](const Point2& x) { return Point2(x.x() + 1.234, x.y()); });
}

TEST_CASE("scaling the surface scales lengths and leaves directions and graph as they are", "[slow]") {
    const ExpressionMetric unit("E=(2+cos(v))^2;F=0;G=1", torus_periods);
    const ExpressionMetric large("E=1e6*(2+cos(v))^2;F=0;G=1e6", torus_periods);
    CutLocusParameters parameters;
    const CutLocus a = locus_of(unit, {0, 0.6}, parameters);
    parameters.spacing *= 1e3;
    parameters.tolerance *= 1e3;
    const CutLocus b = locus_of(large, {0, 0.6}, parameters);
    check_certificate(a);
    check_certificate(b);
    REQUIRE(a.graph.arcs.size() == b.graph.arcs.size());
    CHECK(std::abs(a.graph.length - b.graph.length / 1e3) < 1e-8);
    for (const CutVertex& vertex : a.graph.vertices)
        CHECK(distance_to_nearest(unit, vertices_of_degree(b.graph, vertex.degree), vertex.x) < 1e-8);
}

TEST_CASE("samples are evenly spaced, not farther apart than asked for, and end in the arc's vertices", "[slow]") {
    const TorusOfRevolution torus(2, 2);
    CutLocusParameters parameters;
    parameters.spacing = GENERATE(0.05, 0.01);
    const CutLocus locus = locus_of(torus, {0, 0.15 * pi}, parameters);
    check_certificate(locus);
    for (const CutArc& arc : locus.graph.arcs) {
        REQUIRE(arc.samples.size() >= 2);
        CHECK(arc.length / static_cast<double>(arc.samples.size() - 1) <= parameters.spacing * (1 + 1e-12));
        const auto& start = locus.graph.vertices[static_cast<std::size_t>(arc.start)];
        const auto& end = locus.graph.vertices[static_cast<std::size_t>(arc.end)];
        CHECK(chart_distance(torus, arc.samples.front().x, start.x) < 1e-9);
        CHECK(chart_distance(torus, arc.samples.back().x, end.x) < 1e-9);
        double shortest = 1e300, longest = 0;
        for (std::size_t i = 1; i < arc.samples.size(); ++i) {
            const Point2 &a = arc.samples[i - 1].x, &b = arc.samples[i].x;
            const double chord = torus.tensor((a + b) / 2).norm(b - a);
            shortest = std::min(shortest, chord);
            longest = std::max(longest, chord);
        }
        CHECK(longest <= shortest * (1 + 10 * parameters.spacing));
    }
}
