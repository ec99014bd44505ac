// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/triangle_wall.h"

#include <catch2/catch.hpp>
#include <limits>

#include "core/errors.h"
#include "core/random.h"
#include "dsc3d/generate/blocks.h"
#include "dsc3d/generate/shapes.h"
#include "dsc3d/operations/flat_surface.h"
#include "tests/dsc3d/cylinder.h"
#include "tests/dsc3d/support.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;

namespace {

/// The vertices of a surface joined to its centre.
Mesh coned(const geometry::SurfaceData& surface, const Point3& centre) {
    geometry::TetData data{.vertices = surface.vertices};
    const auto middle = static_cast<std::uint32_t>(data.vertices.size());
    data.vertices.push_back(centre);
    for (const auto& [a, b, c] : surface.triangles) data.tets.push_back({middle, a, b, c});
    return Mesh(data);
}

}  // namespace

TEST_CASE("a wall of triangles that approximate a sphere has its places and normals, to second order") {
    const Point3 centre(0.2, -0.1, 0.4);
    const geometry::SurfaceData sphere = icosphere(centre, 2, 12);
    const TriangleWall wall(sphere);
    core::Random random(seed(1));
    for (int i = 0; i < 100; ++i) {
        const Point3 out = Point3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)).normalized();
        const Point3 p = centre + random.uniform(1.5, 2.5) * out;
        const Point3 q = wall.nearest(p);
        CHECK((q - centre).norm() < 2 + 1e-14);
        CHECK((q - centre).norm() > 2 * (1 - 4e-3));
        CHECK((q - centre).normalized().dot(out) > 1 - 2e-3);
        CHECK((wall.nearest(q) - q).norm() < 1e-14);
        CHECK(wall.normal(p).norm() == Approx(1).epsilon(1e-14));
        CHECK(wall.normal(p).dot((q - centre).normalized()) > 1 - 2e-4);
        const Point3 beside = p + 1e-6 * out.unitOrthogonal();
        CHECK((wall.normal(beside) - wall.normal(p)).norm() < 1e-5);
    }
    for (const Point3& p : sphere.vertices) CHECK((wall.nearest(p) - p).norm() < 1e-14);
    CHECK_THROWS_AS(TriangleWall(geometry::SurfaceData{}), core::UsageError);
}

TEST_CASE("a container is cut along its sharp edges, and its plane pieces are no walls") {
    CHECK(container_walls(box_surface({Point3(0, 0, 0), Point3(1, 2, 3)}, 0.5)).empty());
    CHECK(container_walls(icosphere(Point3(0, 0, 0), 1, 3)).size() == 1);
    CHECK(container_walls(two_spheres(Point3(0, 0, 0), 1, 0.1, 3)).size() == 2);
    const Walls walls = container_walls(cylinder(1, 2, 4));
    REQUIRE(walls.size() == 1);
    // The mantle alone: what lies under the middle of a lid comes to the rim.
    const Point3 at_rim = walls[0]->nearest(Point3(0.5, 0, 1.1));
    CHECK(at_rim.z() == Approx(1));
    CHECK(at_rim.head<2>().norm() > 0.98);
}

TEST_CASE("sharp edges of a container keep their vertices, its smooth pieces let them slide") {
    const geometry::SurfaceData container = cylinder(1, 2, 4);
    Mesh mesh = coned(container, Point3(0, 0, 0));
    const FlatSurface surface = FlatSurface::flat_boundary(mesh, container_walls(container));
    for (const VertexId v : vertices(mesh.complex())) {
        if (!mesh.complex().is_boundary(v)) continue;
        const Point3& p = mesh.position(v);
        const bool is_at_lid = std::abs(std::abs(p.z()) - 1) < 1e-12;
        const bool is_at_mantle = std::abs(p.head<2>().norm() - 1) < 1e-12;
        CHECK(surface.motion(v) == (is_at_lid && is_at_mantle ? VertexMotion::fixed : VertexMotion::plane));
        if (is_at_lid && is_at_mantle) continue;
        const Point3 moved = surface.settled(v, p + Point3(0.01, 0.02, 0.03));
        if (is_at_lid) {
            CHECK(moved.z() == Approx(p.z()).epsilon(1e-14));
        } else {
            CHECK((container_walls(container)[0]->nearest(moved) - moved).norm() < 1e-14);
        }
    }
}
