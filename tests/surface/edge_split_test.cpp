// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/edge_split.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/errors.h"
#include "surface/vertex_rings.h"
#include "tests/geometry/surfaces.h"

using namespace dsc;
using namespace dsc::surface;

namespace {

/// Visits the place of the new vertex of every edge of a closed surface, with its ends.
template <class Visit>
void split_all(const geometry::SurfaceData& surface, const Visit& visit) {
    const VertexRings rings(surface);
    std::vector<RingTriangle> at_a, at_b;
    for (const auto& corners : surface.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = corners[k], b = corners[(k + 1) % 3];
            if (a > b) continue;
            visit(surface.vertices[a], surface.vertices[b],
                  split_position(rings.ring(a, at_a), rings.ring(b, at_b), {}));
        }
    }
}

/// A disc of radius 1 with n sectors, and its mirror image, `height` below: a cylinder.
geometry::SurfaceData closed_cylinder(std::uint32_t n, double height) {
    geometry::SurfaceData surface;
    surface.vertices = {Point3(0, 0, 0), Point3(0, 0, -height)};
    for (std::uint32_t i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        for (const double z : {0.0, -height}) surface.vertices.push_back(Point3(std::cos(angle), std::sin(angle), z));
    }
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t a = 2 + 2 * i, b = 2 + 2 * ((i + 1) % n);
        surface.triangles.insert(surface.triangles.end(),
                                 {{0, a, b}, {1, b + 1, a + 1}, {a, a + 1, b + 1}, {a, b + 1, b}});
    }
    return surface;
}

}  // namespace

TEST_CASE("halved edges of a ball have their middles much nearer to it than their chords") {
    const auto errors = [](int levels) {
        double of_chord = 0, of_split = 0;
        split_all(tests::icosphere(levels), [&](const Point3& a, const Point3& b, const Point3& middle) {
            of_chord = std::max(of_chord, 1 - (0.5 * (a + b)).norm());
            of_split = std::max(of_split, std::abs(1 - middle.norm()));
        });
        return std::pair(of_chord, of_split);
    };
    for (const int levels : {2, 3, 4}) {
        const auto [chord, split] = errors(levels);
        CHECK(split < chord / 10);
    }
}

TEST_CASE("the rim of a cylinder is halved on its circle, what is straight stays straight") {
    const auto rim_error = [](std::uint32_t n) {
        double error = 0;
        const double height = 0.4;
        split_all(closed_cylinder(n, height), [&](const Point3& a, const Point3& b, const Point3& middle) {
            if (a.z() == b.z() && a.norm() > 0.5 && b.norm() > 0.5) {
                REQUIRE(std::abs(middle.z() - a.z()) < 1e-15);
                if (a.z() == 0) error = std::max(error, std::abs(1 - middle.norm()));
            } else {
                REQUIRE((middle - 0.5 * (a + b)).norm() < 1e-15);  // in a lid, or across the side
            }
        });
        return error;
    };
    CHECK(std::log2(rim_error(16) / rim_error(32)) == Approx(4).margin(0.2));
    CHECK(rim_error(32) < 1e-4);
}

TEST_CASE("edges of a box are halved in their middles") {
    split_all(tests::box(), [](const Point3& a, const Point3& b, const Point3& middle) {
        REQUIRE((middle - 0.5 * (a + b)).norm() < 1e-15);
    });
}

TEST_CASE("parameters of splits out of their range are refused") {
    CHECK_THROWS_AS(SplitParameters({.feature_angle = 90}).validate(), core::UsageError);
    CHECK_NOTHROW(SplitParameters().validate());
}
