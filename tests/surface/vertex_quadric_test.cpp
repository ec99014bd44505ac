// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/vertex_quadric.h"

#include <catch2/catch.hpp>

#include "surface/features.h"
#include "surface/triangle.h"
#include "surface/vertex_rings.h"
#include "tests/geometry/surfaces.h"
#include "tests/support/seed.h"
#include "tests/surface/rings.h"

using namespace dsc;
using namespace dsc::surface;

namespace {

constexpr double feature_angle = 30;

VertexFeature feature(const OneRing& ring) { return vertex_feature(ring, vertex_quadric(ring), feature_angle); }

}  // namespace

TEST_CASE("the quadric of planes does not depend on their triangulation") {
    core::Random random(tests::seed(1));
    for (int i = 0; i < 200; ++i) {
        const VertexQuadric corner = vertex_quadric(tests::cube_corner(random).view());
        CHECK((corner.values - Vector3::Constant(1.0 / 3)).norm() < 1e-14);
        CHECK(corner.rank(feature_angle) == 3);

        const double bend = random.uniform(0.01, 3.1);
        const VertexQuadric ridge = vertex_quadric(tests::ridge(random, bend).view());
        const double c = std::cos(bend / 2), s = std::sin(bend / 2);
        CHECK(std::abs(ridge.values[0] - std::max(c * c, s * s)) < 1e-14);
        CHECK(std::abs(ridge.values[1] - std::min(c * c, s * s)) < 1e-14);
        CHECK(std::abs(ridge.values[2]) < 1e-15);
        CHECK(std::abs(std::abs(ridge.vector(2).z()) - 1) < 1e-14);
        CHECK((ridge.mean_normal - Vector3(0, c, 0)).norm() < 1e-14);
        CHECK(ridge.rank(feature_angle) == (bend > radians(feature_angle) ? 2 : 1));
    }
}

TEST_CASE("the rim of a sheet is a ridge however thin it is") {
    core::Random random(tests::seed(2));
    for (const double bend : {2.0, 3.0, 3.14, 3.1415}) {
        const tests::OwnedRing rim = tests::ridge(random, bend);
        CHECK(vertex_quadric(rim.view()).rank(feature_angle) == 2);
        CHECK(feature(rim.view()) == VertexFeature::ridge);
    }
}

TEST_CASE("a cube has 8 corners, a cylinder two rims, a ball nothing") {
    core::Random random(tests::seed(3));
    for (int i = 0; i < 50; ++i) {
        CHECK(feature(tests::cube_corner(random).view()) == VertexFeature::corner);
        CHECK(feature(tests::ridge(random, 1.5).view()) == VertexFeature::ridge);
        CHECK(feature(tests::ridge(random, -1.5).view()) == VertexFeature::ridge);
        CHECK(feature(tests::flat(random).view()) == VertexFeature::smooth);
    }
    const geometry::SurfaceData ball = tests::icosphere(2);
    const VertexRings rings(ball);
    std::vector<RingTriangle> buffer;
    for (std::uint32_t v = 0; v < ball.vertices.size(); ++v) {
        REQUIRE(feature(rings.ring(v, buffer)) == VertexFeature::smooth);
    }

    // A lid of radius 1 at the end of a cylinder.
    const int n = 24;
    const auto rim = [](int k) {
        const double angle = 2 * std::numbers::pi * k / n;
        return Point3(std::cos(angle), std::sin(angle), 0);
    };
    const Point3 depth(0, 0, -0.3), top(0, 0, 0);
    const std::array<RingTriangle, 5> lid{{{rim(1), top},
                                           {top, rim(-1)},
                                           {rim(-1), rim(-1) + depth},
                                           {rim(-1) + depth, rim(0) + depth},
                                           {rim(0) + depth, rim(1)}}};
    CHECK(vertex_quadric({rim(0), lid}).rank(feature_angle) == 2);
    CHECK(feature({rim(0), lid}) == VertexFeature::ridge);
}

TEST_CASE("a ridge that turns is a corner") {
    // The wall of a path that turns by 90 degrees, under a roof whose bend is hardly more than the feature angle.
    const double slope = std::tan(radians(32));
    const Point3 west(-1, 0, 0), south(0, -1, 0), ridge_end(1, 1, -slope);
    const std::array<RingTriangle, 4> roof{
        {{west, Point3(-1, -1, 0)}, {Point3(-1, -1, 0), south}, {south, ridge_end}, {ridge_end, west}}};
    CHECK(feature({Point3::Zero(), roof}) == VertexFeature::corner);
}

TEST_CASE("where three sheets meet there is a ridge, whatever their orientation") {
    core::Random random(tests::seed(4));
    for (int i = 0; i < 50; ++i) {
        tests::OwnedRing ring;
        const Point3 up = Point3::UnitZ(), down = -up;
        for (const double direction : {0.3, 2.4, 4.5}) {
            const Point3 across(std::cos(direction), std::sin(direction), 0);
            tests::add_fan(ring, tests::sector(random, up, across, std::numbers::pi), up, down);
        }
        for (RingTriangle& t : ring.triangles) {
            if (random.below(2) == 0) std::swap(t.a, t.b);
        }
        CHECK(feature(ring.view()) == VertexFeature::ridge);
    }
}

TEST_CASE("the bend of an edge is the angle between the normals") {
    const Point3 a(0, 0, 0), b(0, 0, 1), c(1, 0, 0.3);
    for (const double angle : {0.0, 1.0, 29.0, 31.0, 90.0, 170.0}) {
        const Point3 d(-std::cos(radians(angle)), std::sin(radians(angle)), 0.6);
        CHECK(bend(a, b, c, d) == Approx(angle).margin(1e-12));
        CHECK(is_feature_edge(a, b, c, d, feature_angle) == (angle > feature_angle));
    }
}

TEST_CASE("a ring without normals has rank 0") {
    CHECK(vertex_quadric({Point3::Zero(), {}}).rank(feature_angle) == 0);
    const std::array<RingTriangle, 1> line{{{Point3(1, 0, 0), Point3(2, 0, 0)}}};
    CHECK(vertex_quadric({Point3::Zero(), line}).rank(feature_angle) == 0);
}
