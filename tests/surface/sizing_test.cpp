// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/sizing.h"

#include <catch2/catch.hpp>

#include "core/errors.h"
#include "core/random.h"
#include "surface/thickness.h"
#include "surface/triangle.h"
#include "tests/geometry/surfaces.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::surface;

namespace {

/// The unit sphere times `radius`, flattened to `flat` of its height.
geometry::SurfaceData spheroid(int levels, double radius, double flat) {
    geometry::SurfaceData surface = tests::icosphere(levels);
    for (Point3& p : surface.vertices) p = radius * Point3(p.x(), p.y(), flat * p.z());
    return surface;
}

/// By relaxation until nothing changes, in rounds.
void limit_by_rounds(const geometry::SurfaceData& surface, double gradation, std::vector<double>& lengths) {
    for (bool changed = true; changed;) {
        changed = false;
        for (const auto& t : surface.triangles) {
            for (const std::uint32_t v : t) {
                for (const std::uint32_t w : t) {
                    const double limit = lengths[v] + gradation * (surface.vertices[w] - surface.vertices[v]).norm();
                    if (lengths[w] > limit) lengths[w] = limit, changed = true;
                }
            }
        }
    }
}

}  // namespace

TEST_CASE("the thickness of a ball is its diameter") {
    for (const double t : thickness(spheroid(3, 0.5, 1))) CHECK(t == Approx(1).epsilon(0.01));
}

TEST_CASE("the thickness of a slab is that of its faces") {
    geometry::SurfaceData slab = tests::box();
    for (Point3& p : slab.vertices) p = Point3(10 * p.x(), 10 * p.y(), 0.1 * p.z());
    // In the middle of the top and of the bottom.
    slab.vertices.push_back(Point3(4, 6, 0.1));
    slab.vertices.push_back(Point3(5.5, 5, 0));
    slab.triangles.erase(slab.triangles.begin(), slab.triangles.begin() + 4);
    slab.triangles.insert(slab.triangles.end(), {{4, 5, 8}, {5, 7, 8}, {7, 6, 8}, {6, 4, 8}});
    slab.triangles.insert(slab.triangles.end(), {{0, 9, 1}, {1, 9, 3}, {3, 9, 2}, {2, 9, 0}});
    const std::vector<double> t = thickness(slab);
    CHECK(t[8] == Approx(0.1).epsilon(1e-14));
    CHECK(t[9] == Approx(0.1).epsilon(1e-14));
}

TEST_CASE("a hole inside ends the thickness, and what lies beyond the outside does not count") {
    geometry::SurfaceData shell = spheroid(3, 1, 1);
    geometry::SurfaceData hole = spheroid(3, 0.7, 1);
    for (auto& t : hole.triangles) std::swap(t[0], t[1]);
    const std::size_t outer = shell.vertices.size();
    shell = tests::joined(shell, hole);
    const std::vector<double> t = thickness(shell);
    for (std::size_t v = 0; v < outer; ++v) REQUIRE(t[v] == Approx(0.3).epsilon(0.03));
    for (std::size_t v = outer; v < t.size(); ++v) REQUIRE(t[v] == Approx(0.3).epsilon(0.03));
}

TEST_CASE("an open sheet and a vertex of no triangle have no thickness") {
    geometry::SurfaceData sheet;
    sheet.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}};
    sheet.triangles = {{0, 1, 2}};
    for (const double t : thickness(sheet)) CHECK(std::isinf(t));
    CHECK(thickness({}).empty());
}

TEST_CASE("uniform sizing is the same everywhere") {
    for (const double l : wanted_lengths(tests::box(), {.length = 0.25})) CHECK(l == 0.25);
}

TEST_CASE("sizing by curvature lets the surface turn by the angle that was asked for") {
    const double turn = 15;
    for (const double radius : {0.1, 1.0}) {
        const std::vector<double> lengths =
            wanted_lengths(spheroid(3, radius, 1), {.length = 10, .min_length = 1e-3, .max_turn = turn});
        for (const double l : lengths) REQUIRE(l == Approx(2 * radius * std::sin(radians(turn) / 2)).epsilon(0.05));
    }
    for (const double l : lengths_by_curvature(tests::torus(32, 0.25), radians(turn))) {
        REQUIRE(l == Approx(2 * 0.25 * std::sin(radians(turn) / 2)).epsilon(0.05));
    }
}

TEST_CASE("sizing by thickness puts the edges across that were asked for") {
    const geometry::SurfaceData lens = spheroid(4, 1, 0.1);
    SizingParameters parameters{.length = 1, .min_length = 0.02};
    parameters.edges_across = 2;
    parameters.gradation = 100;
    const std::vector<double> lengths = wanted_lengths(lens, parameters);
    std::size_t flat = 0;
    for (std::size_t v = 0; v < lengths.size(); ++v) {
        const Point3& p = lens.vertices[v];
        if (p.head<2>().norm() > 0.5) continue;
        ++flat;
        CHECK(lengths[v] == Approx(std::abs(p.z())).epsilon(0.03));
    }
    CHECK(flat > 100);
}

TEST_CASE("lengths stay in their range and are the least of what was asked for") {
    const geometry::SurfaceData ball = spheroid(2, 1, 1);
    SizingParameters parameters{.length = 0.5, .min_length = 0.1};
    parameters.field = [](const Point3& p) { return p.x() > 0.9 ? 1e-9 : 10.0; };
    parameters.edges_across = 5;  // 0.4
    const std::vector<double> lengths = wanted_lengths(ball, parameters);
    CHECK(*std::ranges::min_element(lengths) == 0.1);
    CHECK(*std::ranges::max_element(lengths) == Approx(0.4).epsilon(0.02));

    parameters.field = [](const Point3& p) { return p.x(); };
    CHECK_THROWS_WITH(wanted_lengths(ball, parameters), Catch::Contains("has to be positive"));
}

TEST_CASE("the gradation holds along every edge, and lowers no more than it has to") {
    const geometry::SurfaceData ball = spheroid(3, 1, 1);
    core::Random random(tests::seed(1));
    std::vector<double> lengths;
    for (std::size_t v = 0; v < ball.vertices.size(); ++v) lengths.push_back(random.uniform(0.01, 1));
    std::vector<double> expected = lengths;
    limit_by_rounds(ball, 0.3, expected);
    limit_gradation(ball, 0.3, lengths);
    for (std::size_t v = 0; v < lengths.size(); ++v) CHECK(lengths[v] == Approx(expected[v]).epsilon(1e-14));
}

TEST_CASE("sizing parameters out of their range are refused by name") {
    CHECK_THROWS_WITH(SizingParameters{}.validate(), Catch::StartsWith("length"));
    CHECK_THROWS_WITH((SizingParameters{.length = 1, .max_turn = 10}.validate()), Catch::StartsWith("min_length"));
    CHECK_THROWS_WITH((SizingParameters{.length = 1, .min_length = 0.1, .max_turn = 100}.validate()),
                      Catch::StartsWith("max_turn"));
    CHECK_THROWS_AS((SizingParameters{.length = 1, .gradation = 0}.validate()), core::UsageError);
}
