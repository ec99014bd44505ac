// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/fluid/initial_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "dsc3d/generate/remesh.h"
#include "dsc3d/generate/shapes.h"
#include "dsc3d/generate/tetrahedralize.h"
#include "dsc3d/generate/vessel.h"
#include "fluid/equilibrium.h"
#include "geometry/surface_check.h"
#include "io/closed_surface.h"
#include "io/surface_mesh.h"

namespace dsc::fluid_app {

namespace {

constexpr double tet_growth = 0.15;  // of the edge length per distance from the surface

// The displacement grad(r^2 P_2) / 2 has no divergence, so that a ball keeps its volume to first order.
Point3 swollen(const Ball& ball, const Point3& place) {
    const Point3 arm = place - ball.centre;
    return place + ball.swell * Point3(-arm.x() / 2, -arm.y() / 2, arm.z());
}

// The surface of the file with edges of this length, as large as fits in the ball.
geometry::SurfaceData from_file(const Ball& ball, double edge_length) {
    geometry::SurfaceData surface = io::read_surface_mesh(*ball.surface);
    surface.labels.clear();
    io::require_closed_surface(*ball.surface, surface);
    if (geometry::check_surface(surface).volume.value_or(0) < 0)
        for (auto& triangle : surface.triangles) std::swap(triangle[1], triangle[2]);
    Eigen::AlignedBox3d box;
    for (const Point3& place : surface.vertices) box.extend(place);
    double reach = 0;
    for (const Point3& place : surface.vertices) reach = std::max(reach, (place - box.center()).norm());
    for (Point3& place : surface.vertices) place = ball.centre + ball.radius / reach * (place - box.center());
    return dsc3d::remeshed(surface, {.edge_length = edge_length});
}

// A drop of these triangles at rest.
geometry::SurfaceData drop(const Ball& ball, double edge_length) {
    geometry::SurfaceData surface =
        dsc3d::icosphere(ball.centre, ball.radius, dsc3d::icosphere_frequency(ball.radius, edge_length));
    std::vector<fluid::SurfaceElement<3>> elements;
    for (const auto& triangle : surface.triangles) elements.push_back({triangle, 1.0});
    surface.vertices = fluid::equilibrium<3>(surface.vertices, elements);
    for (Point3& place : surface.vertices) place = swollen(ball, place);
    return surface;
}

double mean_edge_length(const geometry::SurfaceData& surface) {
    double sum = 0;
    for (const auto& triangle : surface.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            sum += (surface.vertices[triangle[k]] - surface.vertices[triangle[(k + 1) % 3]]).norm();
    return sum / 3 / static_cast<double>(surface.triangles.size());
}

geometry::TetData in_vessel(const geometry::SurfaceData& surface, const Vessel& vessel, double edge_length,
                            core::Observer& observer) {
    geometry::InterfaceData interface { .surface = surface };
    interface.sides.assign(surface.triangles.size(), {0, 1});
    // As fine as the fluid that will touch it: splitting edges of the wall later would change the volume inside.
    const geometry::SurfaceData wall =
        dsc3d::icosphere(vessel.centre, vessel.radius, dsc3d::icosphere_frequency(vessel.radius, edge_length));
    return dsc3d::tetrahedralize_within(interface, wall, {.growth = tet_growth}, observer);
}

InitialMesh drops(const Scene& scene, core::Observer& observer) {
    geometry::SurfaceData surface;
    for (const Ball& ball : scene.balls) {
        const geometry::SurfaceData part =
            ball.surface ? from_file(ball, scene.edge_length) : drop(ball, scene.edge_length);
        const auto first = static_cast<std::uint32_t>(surface.vertices.size());
        surface.vertices.insert(surface.vertices.end(), part.vertices.begin(), part.vertices.end());
        for (const auto& [a, b, c] : part.triangles) surface.triangles.push_back({a + first, b + first, c + first});
    }
    InitialMesh mesh{.edge_length = mean_edge_length(surface)};
    mesh.tets = scene.vessel ? in_vessel(surface, *scene.vessel, mesh.edge_length, observer)
                             : dsc3d::tetrahedralize(surface, scene.domain, {.growth = tet_growth}, observer);
    mesh.velocities.assign(mesh.tets.vertices.size(), Point3::Zero());
    for (std::size_t t = 0; t < mesh.tets.tets.size(); ++t) {
        if (mesh.tets.label(t) != 1) continue;
        Point3 centre = Point3::Zero();
        for (const std::uint32_t v : mesh.tets.tets[t]) centre += mesh.tets.vertices[v] / 4;
        const Ball& ball = *std::min_element(scene.balls.begin(), scene.balls.end(), [&](const Ball& a, const Ball& b) {
            return (a.centre - centre).norm() / a.radius < (b.centre - centre).norm() / b.radius;
        });
        for (const std::uint32_t v : mesh.tets.tets[t])
            mesh.velocities[v] = ball.velocity + ball.spin.cross(mesh.tets.vertices[v] - ball.centre);
    }
    return mesh;
}

// Cubes of six tetrahedra each, around their diagonals (Kuhn): flat in every plane of the grid, whose planes these are.
InitialMesh grid(const std::array<std::vector<double>, 3>& planes, const std::function<int(const Point3&)>& label) {
    constexpr std::array<std::array<std::size_t, 3>, 6> orders = {
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
    using Index = std::array<std::size_t, 3>;
    const auto number = [&](const Index& at) {
        return static_cast<std::uint32_t>((at[2] * planes[1].size() + at[1]) * planes[0].size() + at[0]);
    };
    InitialMesh mesh;
    for (const double z : planes[2])
        for (const double y : planes[1])
            for (const double x : planes[0]) mesh.tets.vertices.emplace_back(x, y, z);
    Index at{};
    for (at[2] = 0; at[2] + 1 < planes[2].size(); ++at[2])
        for (at[1] = 0; at[1] + 1 < planes[1].size(); ++at[1])
            for (at[0] = 0; at[0] + 1 < planes[0].size(); ++at[0])
                for (std::size_t i = 0; i < orders.size(); ++i) {
                    Index corner = at;
                    std::array<std::uint32_t, 4> tet{};
                    tet[0] = number(corner);
                    for (std::size_t k = 0; k < 3; ++k) {
                        ++corner[orders[i][k]];
                        tet[k + 1] = number(corner);
                    }
                    const Point3 centre = (mesh.tets.vertices[tet[0]] + mesh.tets.vertices[tet[3]]) / 2;  // of the cube
                    if (i >= 3) std::swap(tet[2], tet[3]);  // odd orders are mirrored
                    mesh.tets.tets.push_back(tet);
                    mesh.tets.labels.push_back(label(centre));
                }
    mesh.velocities.assign(mesh.tets.vertices.size(), Point3::Zero());
    return mesh;
}

// From `low` to `high`, at distances of about `length`.
void add_planes(std::vector<double>& planes, double low, double high, double length) {
    const int count = std::max(1, static_cast<int>(std::lround((high - low) / length)));
    for (int i = planes.empty() ? 0 : 1; i <= count; ++i)
        planes.push_back(i == count ? high : low + (high - low) * i / count);
}

// Of this size, in the lower corner of the domain.
InitialMesh block(const Scene& scene, const Point3& size) {
    const Eigen::AlignedBox3d& box = scene.domain;
    const Eigen::AlignedBox3d fluid(box.min(), box.min() + size);
    std::array<std::vector<double>, 3> planes;
    for (int k = 0; k < 3; ++k) {
        auto& of_axis = planes[static_cast<std::size_t>(k)];
        add_planes(of_axis, box.min()[k], fluid.max()[k], scene.edge_length);
        if (fluid.max()[k] < box.max()[k]) add_planes(of_axis, fluid.max()[k], box.max()[k], scene.edge_length);
    }
    InitialMesh mesh = grid(planes, [&](const Point3& centre) { return fluid.contains(centre) ? 1 : 0; });
    mesh.edge_length = scene.edge_length;
    return mesh;
}

// A box of fluid on the floor, with the grid around it drawn to half a ball.
InitialMesh half_ball(const Scene& scene) {
    const Eigen::AlignedBox3d& box = scene.domain;
    const double radius = *scene.sessile_radius;
    const Point3 middle(box.center().x(), box.center().y(), box.min().z());
    // On the sphere the sides of the box become longer by half of pi over two.
    const double length = scene.edge_length / 1.3;
    std::array<std::vector<double>, 3> planes;
    for (int k = 0; k < 2; ++k) {
        auto& of_axis = planes[static_cast<std::size_t>(k)];
        add_planes(of_axis, box.min()[k], middle[k] - radius, scene.edge_length);
        add_planes(of_axis, middle[k] - radius, middle[k] + radius, length);
        add_planes(of_axis, middle[k] + radius, box.max()[k], scene.edge_length);
    }
    add_planes(planes[2], middle.z(), middle.z() + radius, length);
    add_planes(planes[2], middle.z() + radius, box.max().z(), scene.edge_length);
    const auto height = [&](const Point3& p) { return (p - middle).cwiseAbs().maxCoeff(); };
    InitialMesh mesh = grid(planes, [&](const Point3& centre) { return height(centre) < radius ? 1 : 0; });
    const double reach = std::min(box.sizes().head<2>().minCoeff() / 2, box.sizes().z());
    for (Point3& p : mesh.tets.vertices) {
        const double s = height(p);
        if (s == 0 || s >= reach) continue;
        const double weight = s <= radius ? s / radius : (reach - s) / (reach - radius);
        p = middle + (1 - weight + weight * s / (p - middle).norm()) * (p - middle);
    }
    mesh.edge_length = scene.edge_length;
    return mesh;
}

}  // namespace

InitialMesh initial_mesh(const Scene& scene, core::Observer& observer) {
    if (scene.depth) return block(scene, {scene.domain.sizes().x(), scene.domain.sizes().y(), *scene.depth});
    if (scene.column) return block(scene, *scene.column);
    return scene.sessile_radius ? half_ball(scene) : drops(scene, observer);
}

}  // namespace dsc::fluid_app
