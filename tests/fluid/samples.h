// SPDX-License-Identifier: GPL-3.0-or-later
// Fluids to test with: a disc of rings, a ball of tetrahedra, and boxes of cells.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>

#include "core/observer.h"
#include "core/random.h"
#include "dsc3d/generate/lattice.h"
#include "dsc3d/generate/shapes.h"
#include "dsc3d/generate/tetrahedralize.h"
#include "fluid/flow.h"

namespace dsc::fluid {

/// The cells of label 1, or all of them.
inline SimplexMesh<3> fluid_of(const geometry::TetData& data, bool whole = false) {
    SimplexMesh<3> mesh;
    std::map<std::uint32_t, std::uint32_t> number;
    for (std::size_t t = 0; t < data.tets.size(); ++t) {
        if (!whole && data.label(t) != 1) continue;
        auto& cell = mesh.cells.emplace_back();
        for (std::size_t i = 0; i < 4; ++i) {
            const std::uint32_t v = data.tets[t][i];
            const auto [place, is_new] = number.try_emplace(v, static_cast<std::uint32_t>(number.size()));
            if (is_new) mesh.positions.push_back(data.vertices[v]);
            cell[i] = place->second;
        }
        mesh.phases.push_back(0);
    }
    return mesh;
}

inline SimplexMesh<3> ball(std::uint32_t frequency) {
    const Eigen::AlignedBox3d box(Vector<3>::Constant(-2), Vector<3>::Constant(2));
    core::Observer observer;
    return fluid_of(
        dsc3d::tetrahedralize(dsc3d::icosphere(Vector<3>::Zero(), 1, frequency), box, {.growth = 0}, observer));
}

/// The unit disc: rings of 6 k vertices.
inline SimplexMesh<2> disc(int rings) {
    SimplexMesh<2> mesh;
    mesh.positions.push_back(Vector<2>::Zero());
    const auto number = [](int ring, int i) {
        return static_cast<std::uint32_t>(ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + i % (6 * ring));
    };
    for (int ring = 1; ring <= rings; ++ring) {
        for (int i = 0; i < 6 * ring; ++i) {
            const double angle = 2 * std::numbers::pi * i / (6 * ring);
            mesh.positions.push_back(static_cast<double>(ring) / rings * Vector<2>(std::cos(angle), std::sin(angle)));
        }
        for (int sector = 0; sector < 6; ++sector) {
            for (int i = 0; i < ring; ++i) {
                const std::uint32_t outer = number(ring, sector * ring + i), next = number(ring, sector * ring + i + 1);
                const std::uint32_t inner = number(ring - 1, sector * (ring - 1) + i);
                mesh.cells.push_back({inner, outer, next});
                if (i + 1 < ring) mesh.cells.push_back({inner, next, number(ring - 1, sector * (ring - 1) + i + 1)});
            }
        }
    }
    mesh.phases.assign(mesh.cells.size(), 0);
    return mesh;
}

/// The square from (0, 0) to (1, 1), of squares that are halved in the same direction.
inline SimplexMesh<2> regular_square(int n) {
    SimplexMesh<2> mesh;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
            mesh.positions.emplace_back(static_cast<double>(i) / n, static_cast<double>(j) / n);
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const auto a = static_cast<std::uint32_t>(j * (n + 1) + i), b = a + 1;
            const auto c = static_cast<std::uint32_t>(b + n + 1), d = c - 1;
            mesh.cells.push_back({a, b, c});
            mesh.cells.push_back({a, c, d});
        }
    mesh.phases.assign(mesh.cells.size(), 0);
    return mesh;
}

/// The same with its inner vertices shaken, and those on a side along it.
inline SimplexMesh<2> square(int n, std::uint64_t seed) {
    SimplexMesh<2> mesh = regular_square(n);
    core::Random random(seed);
    const double shake = 0.2 / n;
    for (auto& p : mesh.positions)
        for (int k = 0; k < 2; ++k)
            if (p[k] > 0 && p[k] < 1) p[k] += random.uniform(-shake, shake);
    return mesh;
}

inline SimplexMesh<3> cube(double spacing) {
    return fluid_of(dsc3d::lattice({Vector<3>::Zero(), Vector<3>::Ones()}, spacing), true);
}

template <int Dimension>
std::vector<SurfaceElement<Dimension>> free_surface(const SimplexMesh<Dimension>& mesh, double tension = 1) {
    std::vector<SurfaceElement<Dimension>> result;
    for (const auto& facet : facets(mesh))
        if (!facet.opposite) result.push_back({facet.vertices, tension});
    return result;
}

template <int Dimension>
std::vector<Vector<Dimension>> random_velocities(std::size_t count, core::Random& random) {
    std::vector<Vector<Dimension>> result(count);
    for (auto& u : result)
        for (int k = 0; k < Dimension; ++k) u[k] = random.uniform(-1, 1);
    return result;
}

template <int Dimension>
Eigen::VectorXd flat(const std::vector<Vector<Dimension>>& vectors) {
    Eigen::VectorXd result(static_cast<Eigen::Index>(vectors.size()) * Dimension);
    for (std::size_t i = 0; i < vectors.size(); ++i)
        result.template segment<Dimension>(Dimension * static_cast<Eigen::Index>(i)) = vectors[i];
    return result;
}

/// D u, of each cell.
template <int Dimension>
Eigen::VectorXd growth_rates(const SimplexMesh<Dimension>& mesh, const std::vector<Vector<Dimension>>& velocities) {
    return divergence_matrix(mesh, Elements<Dimension>(mesh)) * flat(velocities);
}

}  // namespace dsc::fluid
