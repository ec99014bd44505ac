// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/edge_collapse.h"

#include <catch2/catch.hpp>

#include "surface/vertex_rings.h"
#include "tests/geometry/surfaces.h"
#include "tests/support/seed.h"
#include "tests/surface/rings.h"

using namespace dsc;
using namespace dsc::surface;

namespace {

/// The place that both ends of the edge ab of a surface would get.
std::optional<Point3> collapsed(const geometry::SurfaceData& surface, std::uint32_t a, std::uint32_t b) {
    const VertexRings rings(surface);
    std::vector<RingTriangle> at_a, at_b;
    const OneRing ring_a = rings.ring(a, at_a), ring_b = rings.ring(b, at_b);
    return collapsed_position(ring_a, ring_b, {});
}

geometry::SurfaceData after(geometry::SurfaceData surface, std::uint32_t a, std::uint32_t b, const Point3& place) {
    surface = tests::glued(surface, b, a);
    surface.vertices[a] = surface.vertices[b] = place;
    std::erase_if(surface.triangles, [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
    return surface;
}

/// A grid of (2 n + 1)^2 vertices over [-n, n]^2; vertex (i, j) is number (2 n + 1)(i + n) + j + n.
template <class Height>
geometry::SurfaceData sheet(int n, const Height& height) {
    geometry::SurfaceData surface;
    const int row = 2 * n + 1;
    for (int i = -n; i <= n; ++i) {
        for (int j = -n; j <= n; ++j) surface.vertices.push_back(Point3(i, j, height(i, j)));
    }
    for (int i = 0; i < 2 * n; ++i) {
        for (int j = 0; j < 2 * n; ++j) {
            const auto v = static_cast<std::uint32_t>(row * i + j), w = v + static_cast<std::uint32_t>(row);
            surface.triangles.insert(surface.triangles.end(), {{v, w, w + 1}, {v, w + 1, v + 1}});
        }
    }
    return surface;
}

std::uint32_t number(int i, int j) { return static_cast<std::uint32_t>(9 * (i + 4) + j + 4); }  // in a sheet of n = 4

}  // namespace

TEST_CASE("collapses of a ball keep its volume") {
    const geometry::SurfaceData ball = tests::icosphere(3);
    const double before = tests::volume(ball);
    int count = 0;
    for (std::size_t t = 0; t < ball.triangles.size(); t += 7) {
        const auto& [a, b, c] = ball.triangles[t];
        const std::optional<Point3> place = collapsed(ball, a, b);
        if (!place) continue;
        ++count;
        REQUIRE(tests::volume(after(ball, a, b, *place)) == Approx(before).epsilon(1e-14));
        REQUIRE((*place - (ball.vertices[a] + ball.vertices[b]) / 2).norm() < 0.02);
    }
    CHECK(count > 150);
}

TEST_CASE("flat vertices are collapsed within their plane, those of a roof along its ridge only") {
    const geometry::SurfaceData plane = sheet(4, [](int, int) { return 0.0; });
    const std::optional<Point3> middle = collapsed(plane, number(0, 0), number(0, 1));
    REQUIRE(middle.has_value());
    CHECK((*middle - Point3(0, 0.5, 0)).norm() < 1e-15);

    const geometry::SurfaceData roof = sheet(4, [](int i, int) { return -std::abs(i); });
    const Point3 at_ridge(0, 0, 0), further(0, 1, 0);
    const std::optional<Point3> along = collapsed(roof, number(0, 0), number(0, 1));
    REQUIRE(along.has_value());
    CHECK((*along == at_ridge || *along == further));
    // From the plane onto the ridge, whichever end comes first.
    CHECK(collapsed(roof, number(1, 0), number(0, 0)) == std::optional(at_ridge));
    CHECK(collapsed(roof, number(0, 0), number(1, 0)) == std::optional(at_ridge));
}

TEST_CASE("corners stay, and take their neighbours") {
    // The corner of three planes at (0, 0, 0).
    const geometry::SurfaceData corner = sheet(4, [](int i, int j) { return -2.0 * std::max({i, j, 0}); });
    CHECK(collapsed(corner, number(0, 0), number(0, -1)) == std::optional(Point3(0, 0, 0)));
    CHECK(collapsed(corner, number(-1, -1), number(0, 0)) == std::optional(Point3(0, 0, 0)));
    const VertexRings rings(corner);
    std::vector<RingTriangle> at_a, at_b;
    const OneRing a = rings.ring(number(0, 0), at_a), b = rings.ring(number(0, -1), at_b);
    CHECK_FALSE(collapsed_position(a, VertexFeature::corner, b, VertexFeature::corner, true, {}).has_value());
}

TEST_CASE("two ridges are not joined across the plane between them") {
    // A bank of width 1: the edges i = 0 and i = 1 are ridges.
    const geometry::SurfaceData bank = sheet(4, [](int i, int) { return i <= 0 ? i : 1.0 - i; });
    CHECK_FALSE(collapsed(bank, number(0, 0), number(1, 0)).has_value());
    CHECK(collapsed(bank, number(0, 0), number(0, 1)).has_value());
}

TEST_CASE("nothing is collapsed that would turn a triangle over or make a sliver") {
    geometry::SurfaceData plane = sheet(4, [](int, int) { return 0.0; });
    // The neighbour (1, 2) is pulled in beside the edge, where it would be left behind.
    plane.vertices[number(1, 1)] = Point3(0.05, 0.45, 0);
    CHECK_FALSE(collapsed(plane, number(0, 0), number(0, 1)).has_value());

    const geometry::SurfaceData peak = sheet(4, [](int i, int j) { return i == 0 && j == 0 ? 0.4 : 0.0; });
    CHECK_FALSE(collapsed(peak, number(0, 0), number(0, 1)).has_value());
}

TEST_CASE("an edge that is too short goes to the end that carries the shape, or to the middle") {
    const auto dominant = [](const geometry::SurfaceData& surface, std::uint32_t a, std::uint32_t b) {
        const VertexRings rings(surface);
        std::vector<RingTriangle> at_a, at_b;
        const OneRing ring_a = rings.ring(a, at_a), ring_b = rings.ring(b, at_b);
        const Point3 place = dominant_position(ring_a, ring_b, {});
        REQUIRE(dominant_position(ring_b, ring_a, {}) == place);  // whichever end comes first
        return place;
    };
    const geometry::SurfaceData plane = sheet(4, [](int, int) { return 0.0; });
    CHECK(dominant(plane, number(0, 0), number(0, 1)) == Point3(0, 0.5, 0));
    const geometry::SurfaceData roof = sheet(4, [](int i, int) { return -std::abs(i); });
    CHECK(dominant(roof, number(0, 0), number(1, 0)) == Point3(0, 0, 0));
    CHECK(dominant(roof, number(0, 0), number(0, 1)) == Point3(0, 0.5, 0));
    const geometry::SurfaceData corner = sheet(4, [](int i, int j) { return -2.0 * std::max({i, j, 0}); });
    CHECK(dominant(corner, number(0, 0), number(0, -1)) == Point3(0, 0, 0));
    CHECK(dominant(corner, number(-1, -1), number(0, 0)) == Point3(0, 0, 0));
    // What collapsed_position() refuses, a bank across and a peak, has a place too.
    const geometry::SurfaceData bank = sheet(4, [](int i, int) { return i <= 0 ? i : 1.0 - i; });
    CHECK(dominant(bank, number(0, 0), number(1, 0)) == Point3(0.5, 0, 0));
    const geometry::SurfaceData peak = sheet(4, [](int i, int j) { return i == 0 && j == 0 ? 1.0 : 0.0; });
    CHECK(dominant(peak, number(0, 0), number(0, 1)) == Point3(0, 0.5, 0.5));  // of two corners
}

TEST_CASE("collapse parameters out of their range are refused by name") {
    CHECK_THROWS_WITH(CollapseParameters{.max_turn = 90}.validate(), Catch::StartsWith("max_turn"));
    CHECK_THROWS_WITH(CollapseParameters{.min_angle = 60}.validate(), Catch::StartsWith("min_angle"));
    CHECK_NOTHROW(CollapseParameters{}.validate());
}
