// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/wall.h"

#include <catch2/catch.hpp>
#include <limits>

#include "core/errors.h"
#include "core/random.h"
#include "dsc3d/generate/shapes.h"
#include "dsc3d/operations/rated_mesh.h"
#include "tests/dsc3d/samples.h"
#include "tests/dsc3d/support.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;

namespace {

const Point3 wall_centre(0.2, -0.1, 0.4);

/// An icosphere around one vertex.
Mesh coned_ball(double radius, std::uint32_t frequency) {
    const geometry::SurfaceData sphere = icosphere(wall_centre, radius, frequency);
    TetData data{.vertices = sphere.vertices};
    const auto middle = static_cast<std::uint32_t>(data.vertices.size());
    data.vertices.push_back(wall_centre);
    for (const auto& [a, b, c] : sphere.triangles) data.tets.push_back({middle, a, b, c});
    return Mesh(data);
}

}  // namespace

TEST_CASE("the nearest place on a sphere is on it, in the direction of the point, and itself on the sphere") {
    const SphereWall wall(wall_centre, 2);
    core::Random random(seed(1));
    for (int i = 0; i < 100; ++i) {
        const Point3 p(random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5));
        const Point3 q = wall.nearest(p);
        CHECK((q - wall_centre).norm() == Approx(2).epsilon(1e-14));
        CHECK((p - wall_centre).cross(q - wall_centre).norm() < 1e-13);
        CHECK((p - wall_centre).dot(q - wall_centre) > 0);
        CHECK((wall.nearest(q) - q).norm() < 1e-14);
        CHECK(wall.normal(p).cross(p - wall_centre).norm() < 1e-13);
        CHECK(wall.normal(p).norm() == Approx(1).epsilon(1e-14));
    }
    CHECK((wall.nearest(wall_centre) - wall_centre).norm() == Approx(2));
}

TEST_CASE("a sphere without a finite centre or a positive radius is refused") {
    CHECK_THROWS_AS(SphereWall(wall_centre, 0), core::UsageError);
    CHECK_THROWS_AS(SphereWall(wall_centre, -1), core::UsageError);
    CHECK_THROWS_AS(SphereWall(wall_centre, std::numeric_limits<double>::infinity()), core::UsageError);
    CHECK_THROWS_AS(SphereWall(Point3(0, std::nan(""), 0), 1), core::UsageError);
}

TEST_CASE("vertices slide on a curved wall, and edges of it are halved on it") {
    Mesh mesh = coned_ball(1.5, 4);
    const auto wall = std::make_shared<SphereWall>(wall_centre, 1.5);
    const FlatSurface without = FlatSurface::flat_boundary(mesh);
    RatedMesh rated(mesh, geometry::QualityMeasure::minimum_sine, FlatSurface::flat_boundary(mesh, {wall}));
    const auto is_on_wall = [&](const Point3& p) { return std::abs((p - wall_centre).norm() - 1.5) < 1e-14; };
    for (const VertexId v : vertices(mesh.complex())) {
        if (!mesh.complex().is_boundary(v)) continue;
        CHECK(without.motion(v) == VertexMotion::fixed);
        REQUIRE(rated.surface().motion(v) == VertexMotion::plane);
        const Point3 aside = mesh.position(v) + Point3(0.1, -0.05, 0.2);
        CHECK(is_on_wall(rated.surface().settled(v, aside)));
        CHECK(rated.on_boundary(v, aside) == wall->nearest(aside));
        const Eigen::Vector3d step = rated.surface().allowed(v, Point3(1, 2, 3));
        CHECK(std::abs(step.dot(mesh.position(v) - wall_centre)) < 1e-13);
        CHECK(rated.surface().has_room(v, wall->nearest(aside)));
        CHECK_FALSE(rated.surface().has_room(v, aside));
    }
    const std::vector<EdgeId> edges = tests::edges(mesh.complex());
    for (const EdgeId e : edges) {
        if (!mesh.complex().is_boundary(e)) continue;
        const VertexId m = rated.split(e, rated.middle(e));
        REQUIRE(m.is_valid());
        CHECK(is_on_wall(mesh.position(m)));
        CHECK(rated.surface().motion(m) == VertexMotion::plane);
    }
    require_valid(mesh);
}

TEST_CASE("no edge may come over which a curved wall turns by more than 6 degrees") {
    Mesh mesh = coned_ball(1, 4);
    const FlatSurface surface = FlatSurface::flat_boundary(mesh, {std::make_shared<SphereWall>(wall_centre, 1)});
    const FlatSurface flat = FlatSurface::flat_boundary(mesh);
    const auto at = [](double degrees) {
        const double angle = degrees * std::numbers::pi / 180;
        return Point3(wall_centre + Point3(std::cos(angle), std::sin(angle), 0));
    };
    CHECK(surface.allows_edge(0, at(10), at(15.9)));
    CHECK_FALSE(surface.allows_edge(0, at(10), at(16.1)));
    CHECK(flat.allows_edge(0, at(0), at(90)));
}
