// SPDX-License-Identifier: GPL-3.0-or-later
// On a flat torus the cut locus is the boundary of the Voronoi cell of the lattice, known exactly.
#include <Eigen/LU>
#include <array>

#include "tests/apps/cutlocus/support.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::cutlocus;
using namespace dsc::geodesic;
using namespace dsc::tests;

namespace {

struct FlatTorus {
    const char* text;
    MetricTensor tensor;
};

/// Lengths of the sides of the Voronoi cell of a lattice whose triangle 0, a, b is acute: each is the dual of a side of
/// the triangle, times the cotangent of the opposite angle.
std::vector<double> voronoi_lengths(const MetricTensor& g) {
    const std::array<Vector2, 3> sides{Vector2{2 * pi, 0}, Vector2{-2 * pi, 2 * pi}, Vector2{0, -2 * pi}};
    std::vector<double> lengths;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector2 b = sides[(i + 1) % 3], c = -sides[(i + 2) % 3];
        const double cosine = g.inner(b, c) / (g.norm(b) * g.norm(c));
        lengths.push_back(g.norm(sides[i]) * cosine / std::sqrt(1 - cosine * cosine));
    }
    std::sort(lengths.begin(), lengths.end());
    return lengths;
}

/// Distances of `x` to the points of the lattice, ascending.
std::vector<double> lattice_distances(const MetricTensor& g, const Vector2& x) {
    std::vector<double> distances;
    for (int i = -3; i <= 3; ++i)
        for (int k = -3; k <= 3; ++k) distances.push_back(g.norm(x - 2 * pi * Vector2(i, k)));
    std::sort(distances.begin(), distances.end());
    return distances;
}

}  // namespace

TEST_CASE("the cut locus on a flat square torus is the square's boundary", "[slow]") {
    const ExpressionMetric metric("E=1;F=0;G=1", torus_periods);
    core::Random random(seed(1));
    for (int round = 0; round < 3; ++round) {
        const Point2 p = round == 0 ? Point2{0, 0} : Point2{random.uniform(-pi, pi), random.uniform(-pi, pi)};
        INFO("p = " << p.transpose());
        const CutLocus locus = locus_of(metric, p);
        check_certificate(locus);
        REQUIRE(locus.graph.vertices.size() == 1);
        CHECK(locus.graph.vertices[0].degree == 4);
        CHECK(locus.graph.vertices[0].thetas.size() == 4);
        CHECK(chart_distance(metric, locus.graph.vertices[0].x, p + Vector2(pi, pi)) < 1e-9);
        CHECK(locus.graph.arcs.size() == 2);
        CHECK(std::abs(locus.graph.length - 4 * pi) < 1e-9);
        CHECK(std::abs(locus.graph.nearest.distance - pi) < 1e-9);
        CHECK(std::abs(locus.graph.farthest.distance - std::sqrt(2.0) * pi) < 1e-9);
        double worst = 0;
        for (const CutArc& arc : locus.graph.arcs)
            for (const CutSample& sample : arc.samples) {
                const Vector2 x = torus_periods.wrapped(sample.x - p).cwiseAbs();
                worst = std::max(worst, std::min(std::abs(x.x() - pi), std::abs(x.y() - pi)));
            }
        CHECK(worst < 1e-9);
    }
}

TEST_CASE("the cut locus on a flat torus with any lattice is the hexagon of its Voronoi cell", "[slow]") {
    const FlatTorus torus = GENERATE(FlatTorus{"E=1;F=0.5;G=1", {1, 0.5, 1}},
                                     FlatTorus{"E=1;F=0.3;G=1.4", {1, 0.3, 1.4}});
    INFO(torus.text);
    const ExpressionMetric metric(torus.text, torus_periods);
    const Point2 p{0.4, -1.1};
    const MetricTensor& g = torus.tensor;
    const CutLocus locus = locus_of(metric, p);
    check_certificate(locus);

    // Circumcentre of 0, a, b: inner(x, a) = |a|²/2, inner(x, b) = |b|²/2 with a, b = 2π times the unit vectors.
    Eigen::Matrix2d gram;
    gram << g.E, g.F, g.F, g.G;
    const Vector2 centre = gram.inverse() * Vector2(g.E, g.G) * pi;
    const auto corners = vertices_of_degree(locus.graph, 3);
    CHECK(locus.graph.vertices.size() == 2);
    REQUIRE(corners.size() == 2);
    CHECK(distance_to_nearest(metric, corners, p + centre) < 1e-9);
    CHECK(distance_to_nearest(metric, corners, p - centre) < 1e-9);
    for (const CutVertex& corner : corners) CHECK(std::abs(corner.distance - g.norm(centre)) < 1e-9);

    REQUIRE(locus.graph.arcs.size() == 3);
    const auto lengths = sorted_lengths(locus.graph), expected = voronoi_lengths(g);
    for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(lengths[i] - expected[i]) < 1e-9);
    double worst = 0;
    for (const CutArc& arc : locus.graph.arcs)
        for (const CutSample& sample : arc.samples) {
            const auto distances = lattice_distances(g, torus_periods.wrapped(sample.x - p));
            worst = std::max({worst, distances[1] - distances[0], std::abs(distances[0] - sample.distance)});
        }
    CHECK(worst < 1e-9);
}
