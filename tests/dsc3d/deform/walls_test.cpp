// SPDX-License-Identifier: GPL-3.0-or-later
// A ball that is pressed against a wall and pulled off again, in a box and in a vessel.
#include "dsc3d/deform/deformer.h"
#include "dsc3d/generate/shapes.h"
#include "dsc3d/generate/tetrahedralize.h"
#include "dsc3d/generate/vessel.h"
#include "dsc3d/operations/triangle_wall.h"
#include "tests/dsc3d/cylinder.h"
#include "tests/dsc3d/deform/support.h"
#include "tests/dsc3d/volumes.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;
using motion::TopologyPolicy;

namespace {

constexpr double radius = 0.15;
const Point3 start(0.5, 0.5, 0.19);

geometry::InterfaceData ball() {
    geometry::InterfaceData data{.surface = icosphere(start, radius, 4)};
    data.sides.assign(data.surface.triangles.size(), {0, 1});
    return data;
}

/// Of the triangles of the ball with the plane at this height.
double section_area(double height) {
    double area = 0;
    const geometry::SurfaceData surface = ball().surface;
    const Point3 middle(start.x(), start.y(), height);
    for (const auto& triangle : surface.triangles) {
        std::vector<Point3> ends;
        for (std::size_t k = 0; k < 3; ++k) {
            const Point3 &a = surface.vertices[triangle[k]], &b = surface.vertices[triangle[(k + 1) % 3]];
            if ((a.z() < height) == (b.z() < height)) continue;
            ends.push_back(a + (height - a.z()) / (b.z() - a.z()) * (b - a));
        }
        if (ends.size() == 2) area += (ends[0] - middle).cross(ends[1] - middle).norm() / 2;
    }
    return area;
}

/// Enclosed by the boundary faces, by the divergence theorem.
double domain_volume(const Mesh& mesh) {
    double volume = 0;
    for (const TetId t : tets(mesh.complex())) {
        for (int i = 0; i < 4; ++i) {
            if (mesh.complex().neighbour(t, i).is_valid()) continue;
            const FaceVertices f = mesh.complex().oriented_face(t, i);
            volume += mesh.position(f[0]).dot(mesh.position(f[1]).cross(mesh.position(f[2]))) / 6;
        }
    }
    return volume;
}

struct Press {
    explicit Press(Mesh made, Walls walls = {}, TopologyPolicy policy = TopologyPolicy::adaptive)
        : mesh(std::move(made)),
          deformer(mesh, {.edge_length = 0.04, .topology = policy}, listener, std::move(walls)) {}

    /// All of the interface, in steps of 0.005.
    void go(double distance) {
        const int steps = static_cast<int>(std::round(std::abs(distance) / 0.005));
        for (int i = 0; i < steps; ++i) {
            std::vector<std::optional<Point3>> targets(mesh.complex().vertex_capacity());
            for (const VertexId v : vertices(mesh.complex()))
                if (mesh.complex().is_interface(v))
                    targets[v.index()] = mesh.position(v) + Point3(0, 0, distance / steps);
            deformer.step(targets);
            require_valid(mesh);
            REQUIRE(volume_of_label(mesh, 0) + volume_of_label(mesh, 1) == Approx(domain_volume(mesh)).epsilon(1e-12));
        }
    }
    /// As far as it takes to leave the wall, but not farther than this.
    void pull_off(double farthest) {
        for (double way = 0; way < farthest && contact_area() > 0; way += 0.05) go(0.05);
    }
    double contact_area() const { return statistics_by_label(mesh).at(1).boundary_area; }
    int components() const { return components_of_label(mesh.complex(), 1); }

    Mesh mesh;
    Listener listener;
    Deformer deformer;
};

Mesh in_box() {
    core::Observer observer;
    return Mesh(tetrahedralize(ball(), {Point3(0, 0, 0), Point3(1, 1, 1)}, {}, observer));
}

}  // namespace

TEST_CASE("a ball pressed against a side of the box loses what would be outside, and leaves as one piece", "[slow]") {
    Press press(in_box());
    const double volume = volume_of_label(press.mesh, 1);
    press.go(-0.115);  // to a depth of half its radius
    CHECK(press.components() == 1);
    const double depth = radius / 2;
    const double cap =
        std::numbers::pi * depth * depth * (radius - depth / 3) / (4 * std::numbers::pi / 3 * std::pow(radius, 3));
    CHECK(volume_of_label(press.mesh, 1) / volume == Approx(1 - cap).margin(0.02));
    CHECK(press.contact_area() == Approx(section_area(start.z() - 0.075)).epsilon(0.15));
    for (const VertexId v : vertices(press.mesh.complex()))
        if (press.mesh.complex().is_boundary(v)) {
            const Point3& p = press.mesh.position(v);
            REQUIRE((p.array() * (1 - p.array())).abs().minCoeff() < 1e-15);
        }
    press.pull_off(0.4);
    CHECK(press.contact_area() == 0);
    CHECK(press.components() == 1);
    CHECK(statistics_by_label(press.mesh).at(1).genus == 0);
    CHECK(domain_volume(press.mesh) == Approx(1).epsilon(1e-12));
}

TEST_CASE("a ball is stopped in front of a wall where it may not touch it", "[slow]") {
    for (const TopologyPolicy policy : {TopologyPolicy::preserved, TopologyPolicy::split_only}) {
        Press press(in_box(), {}, policy);
        press.go(-0.06);
        CHECK(press.contact_area() == 0);
        CHECK(press.components() == 1);
        CHECK(statistics_by_label(press.mesh).at(1).genus == 0);
    }
}

TEST_CASE("a ball pressed against a spherical vessel touches it and leaves as one piece", "[slow]") {
    const Point3 centre(0.5, 0.5, 0.5);
    const double size = 0.5;
    core::Observer observer;
    const geometry::SurfaceData vessel = icosphere(centre, size, 12);
    Press press(Mesh(tetrahedralize_within(ball(), vessel, {}, observer)),
                {std::make_shared<SphereWall>(centre, size)});
    const double domain = domain_volume(press.mesh);
    press.go(-0.115);
    CHECK(press.components() == 1);
    CHECK(press.contact_area() > 0.04);
    press.pull_off(0.6);
    CHECK(press.contact_area() == 0);
    CHECK(press.components() == 1);
    CHECK(domain_volume(press.mesh) == Approx(domain).epsilon(0.005));
    for (const VertexId v : vertices(press.mesh.complex()))
        if (press.mesh.complex().is_boundary(v))
            REQUIRE((press.mesh.position(v) - centre).norm() == Approx(size).epsilon(1e-14));
}

TEST_CASE("a ball pressed against the curved side of a container of triangles leaves it as one piece", "[slow]") {
    geometry::SurfaceData container = cylinder(0.5, 1, 6);
    for (Point3& p : container.vertices) p = Point3(0.5 + p.z(), 0.5 + p.x(), 0.5 + p.y());
    const Walls walls = container_walls(container);
    core::Observer observer;
    Press press(Mesh(tetrahedralize_within(ball(), container, {}, observer)), walls);
    const double domain = domain_volume(press.mesh);
    press.go(-0.115);
    CHECK(press.components() == 1);
    CHECK(press.contact_area() > 0.04);
    press.pull_off(0.6);
    CHECK(press.contact_area() == 0);
    CHECK(press.components() == 1);
    CHECK(domain_volume(press.mesh) == Approx(domain).epsilon(0.01));
    for (const VertexId v : vertices(press.mesh.complex())) {
        if (!press.mesh.complex().is_boundary(v)) continue;
        const Point3& p = press.mesh.position(v);
        const double to_lid = std::min(std::abs(p.x()), std::abs(1 - p.x()));
        REQUIRE(std::min(to_lid, (walls[0]->nearest(p) - p).norm()) < 1e-14);
    }
}
