// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/fluid/initial_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "dsc3d/generate/shapes.h"
#include "dsc3d/generate/tetrahedralize.h"
#include "fluid/equilibrium.h"

namespace dsc::fluid_app {

namespace {

constexpr double tet_growth = 0.15;  // of the edge length per distance from the surface

// The displacement grad(r^2 P_2) / 2 has no divergence, so that a ball keeps its volume to first order.
Point3 swollen(const Ball& ball, const Point3& place) {
    const Point3 arm = place - ball.centre;
    return place + ball.swell * Point3(-arm.x() / 2, -arm.y() / 2, arm.z());
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

InitialMesh drops(const Scene& scene, core::Observer& observer) {
    geometry::SurfaceData surface;
    for (const Ball& ball : scene.balls) {
        const geometry::SurfaceData part = drop(ball, scene.edge_length);
        const auto first = static_cast<std::uint32_t>(surface.vertices.size());
        surface.vertices.insert(surface.vertices.end(), part.vertices.begin(), part.vertices.end());
        for (const auto& [a, b, c] : part.triangles) surface.triangles.push_back({a + first, b + first, c + first});
    }
    InitialMesh mesh{.edge_length = mean_edge_length(surface)};
    mesh.tets = dsc3d::tetrahedralize(surface, scene.domain, {.growth = tet_growth}, observer);
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

// Cubes of six tetrahedra each, around their diagonals (Kuhn): flat in every plane of the grid.
InitialMesh layer(const Scene& scene) {
    constexpr std::array<std::array<int, 3>, 6> orders = {
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
    const Point3 size = scene.domain.sizes();
    const auto count = [&](double length) {
        return std::max(1, static_cast<int>(std::lround(length / scene.edge_length)));
    };
    const int below = count(*scene.depth), above = count(size.z() - *scene.depth);
    const std::array<int, 3> n = {count(size.x()), count(size.y()), below + above};
    const auto number = [&](const std::array<int, 3>& at) {
        return static_cast<std::uint32_t>((at[2] * (n[1] + 1) + at[1]) * (n[0] + 1) + at[0]);
    };
    InitialMesh mesh{.edge_length = scene.edge_length};
    std::array<int, 3> at{};
    for (at[2] = 0; at[2] <= n[2]; ++at[2])
        for (at[1] = 0; at[1] <= n[1]; ++at[1])
            for (at[0] = 0; at[0] <= n[0]; ++at[0]) {
                const double z = at[2] <= below ? *scene.depth * at[2] / below
                                                : *scene.depth + (size.z() - *scene.depth) * (at[2] - below) / above;
                mesh.tets.vertices.push_back(scene.domain.min() +
                                             Point3(size.x() * at[0] / n[0], size.y() * at[1] / n[1], z));
            }
    for (at[2] = 0; at[2] < n[2]; ++at[2])
        for (at[1] = 0; at[1] < n[1]; ++at[1])
            for (at[0] = 0; at[0] < n[0]; ++at[0])
                for (std::size_t i = 0; i < 6; ++i) {
                    std::array<int, 3> corner = at;
                    auto& tet = mesh.tets.tets.emplace_back();
                    tet[0] = number(corner);
                    for (std::size_t k = 0; k < 3; ++k) {
                        ++corner[static_cast<std::size_t>(orders[i][k])];
                        tet[k + 1] = number(corner);
                    }
                    if (i >= 3) std::swap(tet[2], tet[3]);  // odd orders are mirrored
                    mesh.tets.labels.push_back(at[2] < below ? 1 : 0);
                }
    mesh.velocities.assign(mesh.tets.vertices.size(), Point3::Zero());
    return mesh;
}

}  // namespace

InitialMesh initial_mesh(const Scene& scene, core::Observer& observer) {
    return scene.depth ? layer(scene) : drops(scene, observer);
}

}  // namespace dsc::fluid_app
