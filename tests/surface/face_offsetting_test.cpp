// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/face_offsetting.h"

#include <catch2/catch.hpp>

#include "surface/triangle.h"
#include "surface/vertex_rings.h"
#include "tests/geometry/surfaces.h"
#include "tests/support/seed.h"
#include "tests/surface/rings.h"

using namespace dsc;
using namespace dsc::surface;

TEST_CASE("the corner of a cube moves by (d, d, d), however its faces are triangulated") {
    core::Random random(tests::seed(1));
    for (int i = 0; i < 500; ++i) {
        const double d = random.uniform(-0.1, 0.1);
        tests::OwnedRing ring = tests::cube_corner(random);
        CHECK((offset_displacement(ring.view(), d, {}) - Vector3::Constant(d)).norm() < 2e-15 * std::abs(d));

        const Eigen::Affine3d placement = tests::random_placement(random);
        ring.transform(placement);
        const Vector3 exact = placement.linear() * Vector3::Constant(d);
        CHECK((offset_displacement(ring.view(), d, {}) - exact).norm() < 1e-14 * std::abs(d));
    }
}

TEST_CASE("planes that move by different distances meet where they should") {
    core::Random random(tests::seed(2));
    for (int i = 0; i < 200; ++i) {
        const tests::OwnedRing corner = tests::cube_corner(random);
        const Vector3 planes(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        std::vector<double> distances;
        for (const RingTriangle& t : corner.triangles) {
            distances.push_back(unit_normal(corner.centre, t.a, t.b).dot(planes));
        }
        CHECK((offset_displacement(corner.view(), distances, {}) - planes).norm() < 5e-15);
    }
}

TEST_CASE("a ridge moves to the intersection of its planes and not along itself") {
    core::Random random(tests::seed(3));
    for (int i = 0; i < 500; ++i) {
        const double bend = random.uniform(-2.7, 2.7);
        const double d = random.uniform(-0.1, 0.1);
        const Vector3 step = offset_displacement(tests::ridge(random, bend).view(), d, {});
        // Below the feature angle too: the common normal of equal weights lies halfway.
        CHECK((step - Vector3(0, d / std::cos(bend / 2), 0)).norm() < 1e-13 * std::abs(d));
    }
}

TEST_CASE("a flat piece moves along its normal, a needle no further than it may") {
    core::Random random(tests::seed(4));
    for (int i = 0; i < 200; ++i) {
        CHECK((offset_displacement(tests::flat(random).view(), 0.1, {}) - Vector3(0, 0.1, 0)).norm() < 1e-15);
    }
    const tests::OwnedRing rim = tests::ridge(random, 3.1);  // sharp answer: 48 times the distance
    CHECK(offset_displacement(rim.view(), 0.1, {.max_stretch = 5}).norm() == Approx(0.5));
    CHECK(offset_displacement(rim.view(), 0.1, {.max_stretch = 50}).norm() == Approx(0.1 / std::cos(1.55)));
}

TEST_CASE("a cube offset in many steps stays a cube; going back leads back") {
    geometry::SurfaceData cube = tests::box(Point3(-0.5, -0.5, -0.5));
    const VertexRings rings(cube);
    std::vector<RingTriangle> buffer;
    const auto offset_all = [&](double d) {
        std::vector<Point3> moved;
        for (std::uint32_t v = 0; v < cube.vertices.size(); ++v) {
            moved.push_back(cube.vertices[v] + offset_displacement(rings.ring(v, buffer), d, {}));
        }
        cube.vertices = moved;
    };
    const std::vector<Point3> start = cube.vertices;
    for (int step = 0; step < 10; ++step) offset_all(0.01);
    for (std::size_t v = 0; v < 8; ++v) CHECK((cube.vertices[v] - 1.2 * start[v]).norm() < 1e-14);
    for (int step = 0; step < 10; ++step) offset_all(-0.01);
    for (std::size_t v = 0; v < 8; ++v) CHECK((cube.vertices[v] - start[v]).norm() < 1e-14);
}

TEST_CASE("a ball offset by d has a radius larger by d, to second order in the edge length") {
    std::array<double, 2> errors{};
    for (std::size_t i = 0; i < 2; ++i) {
        const geometry::SurfaceData ball = tests::icosphere(3 + static_cast<int>(i));
        const VertexRings rings(ball);
        std::vector<RingTriangle> buffer;
        for (std::uint32_t v = 0; v < ball.vertices.size(); ++v) {
            const OneRing ring = rings.ring(v, buffer);
            const Point3 moved = ring.centre + offset_displacement(ring, 0.1, {});
            errors[i] = std::max(errors[i], (moved - 1.1 * ring.centre).norm());
        }
    }
    CHECK(errors[0] < 0.003);
    CHECK(errors[1] < 0.6 * errors[0]);
}

TEST_CASE("a ring without normals does not move; parameters out of range are refused by name") {
    CHECK(offset_displacement({Point3::Zero(), {}}, 1, {}).isZero(0));
    CHECK_THROWS_WITH(OffsetParameters{.feature_angle = 90}.validate(), Catch::StartsWith("feature_angle"));
    CHECK_THROWS_WITH(OffsetParameters{.max_stretch = 0.5}.validate(), Catch::StartsWith("max_stretch"));
}
