// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/surface_intersections.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "core/random.h"
#include "geometry/predicates.h"
#include "tests/geometry/surfaces.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::tests;
using geometry::orientation;
using geometry::Point3;
using geometry::self_intersections;
using geometry::Sign;
using geometry::SurfaceData;

namespace {

using Pairs = std::vector<std::array<std::uint32_t, 2>>;

// For segments and triangles in general position.
bool do_cross(const Point3& p, const Point3& q, const std::array<Point3, 3>& t) {
    if (orientation(t[0], t[1], t[2], p) == orientation(t[0], t[1], t[2], q)) return false;
    const Sign side = orientation(p, q, t[0], t[1]);
    return orientation(p, q, t[1], t[2]) == side && orientation(p, q, t[2], t[0]) == side;
}

Pairs by_brute_force(const SurfaceData& surface) {
    const auto corners = [&](std::uint32_t i) {
        const auto& [a, b, c] = surface.triangles[i];
        return std::array<Point3, 3>{surface.vertices[a], surface.vertices[b], surface.vertices[c]};
    };
    const auto sides_cross = [&](const std::array<Point3, 3>& s, const std::array<Point3, 3>& t) {
        return do_cross(s[0], s[1], t) || do_cross(s[1], s[2], t) || do_cross(s[2], s[0], t);
    };
    Pairs pairs;
    for (std::uint32_t i = 0; i < surface.triangles.size(); ++i) {
        for (std::uint32_t j = i + 1; j < surface.triangles.size(); ++j) {
            if (sides_cross(corners(i), corners(j)) || sides_cross(corners(j), corners(i))) pairs.push_back({i, j});
        }
    }
    return pairs;
}

SurfaceData two_triangles(const std::vector<Point3>& vertices, const std::array<std::uint32_t, 3>& second) {
    return {.vertices = vertices, .triangles = {{0, 1, 2}, second}, .labels = {}};
}

}  // namespace

TEST_CASE("surfaces without self-intersection have none") {
    CHECK(self_intersections({}).empty());
    CHECK(self_intersections(box()).empty());
    CHECK(self_intersections(icosphere(3)).empty());
    CHECK(self_intersections(torus(30, 0.3)).empty());
    CHECK(self_intersections(moebius_strip(30)).empty());
}

TEST_CASE("random triangles intersect as brute force finds") {
    core::Random random(seed(72));
    for (int round = 0; round < 5; ++round) {
        SurfaceData surface;
        for (std::uint32_t i = 0; i < 60; ++i) {
            const Point3 center(random.uniform(), random.uniform(), random.uniform());
            for (int k = 0; k < 3; ++k) {
                const double x = random.uniform(-0.3, 0.3), y = random.uniform(-0.3, 0.3);
                surface.vertices.push_back(center + Point3(x, y, random.uniform(-0.3, 0.3)));
            }
            surface.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        }
        const Pairs pairs = self_intersections(surface);
        CHECK(pairs.size() > 10);
        CHECK(pairs == by_brute_force(surface));
    }
}

TEST_CASE("of two crossing boxes the sides that meet are found") {
    const Pairs pairs = self_intersections(joined(box(), box({0.5, 0.4, 0.3})));
    CHECK_FALSE(pairs.empty());
    std::set<std::uint32_t> touched;
    for (const auto& [a, b] : pairs) {
        CHECK(a < 12);
        CHECK(b >= 12);
        touched.insert({a, b});
    }
    // The far sides of the first box (x, y, z = 1) and the near sides of the second one, no others.
    for (const std::uint32_t triangle : touched) {
        INFO(triangle);
        const std::vector<std::uint32_t> sides{2, 3, 6, 7, 10, 11, 12, 13, 16, 17, 20, 21};
        CHECK(std::ranges::find(sides, triangle) != sides.end());
    }
    CHECK(self_intersections(joined(box(), box({0.25, 0.25, 0.25}, 0.5))).empty());
}

TEST_CASE("touching is intersecting, to the last bit") {
    const std::vector<Point3> floor{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}};
    for (const double height : {0.0, 5e-324, -5e-324}) {
        std::vector<Point3> vertices = floor;
        vertices.insert(vertices.end(), {{0.7, 0.7, height}, {0, 0, 1}, {1, 0, 1}});
        CHECK(self_intersections(two_triangles(vertices, {3, 4, 5})).empty() == (height > 0));
    }
    CHECK(self_intersections(joined(box(), box({1, 0, 0}))).size() >= 2);
}

TEST_CASE("triangles with a common vertex may meet only there") {
    const std::vector<Point3> floor{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
    const auto meet = [&](const Point3& p, const Point3& q) {
        std::vector<Point3> vertices = floor;
        vertices.insert(vertices.end(), {p, q});
        return !self_intersections(two_triangles(vertices, {3, 0, 4})).empty();
    };
    CHECK_FALSE(meet({0, 0, 1}, {1, 1, 1}));
    CHECK_FALSE(meet({-1, 0, 0}, {-1, -1, 0}));
    CHECK(meet({1, 1, 1}, {1, 1, -1}));
    CHECK(meet({0.5, 0.1, 0}, {0.1, 0.5, 0}));
    CHECK(meet({5, 1, 0}, {1, 5, 0}));
    CHECK(meet({1, 0, 0}, {0, -1, 0}));
}

TEST_CASE("triangles with a common edge may not be folded onto each other") {
    const auto meet = [&](const Point3& p) {
        return !self_intersections(two_triangles({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, p}, {3, 1, 0})).empty();
    };
    CHECK(meet({1, 1, 0}));
    CHECK(meet({7, 1, 0}));
    CHECK_FALSE(meet({1, -1, 0}));
    CHECK_FALSE(meet({1, 1, 5e-324}));
    CHECK(self_intersections(two_triangles({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {2, 1, 0})) == Pairs{{0, 1}});
}

TEST_CASE("triangles of no area are left out") {
    SurfaceData surface = box();
    surface.vertices.emplace_back(0.5, 0.5, -1);
    surface.vertices.emplace_back(0.5, 0.5, 3);
    surface.triangles.push_back({8, 9, 9});
    CHECK(self_intersections(surface).empty());
}
