// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of the unit cube for the tests of improve: n³ cells of six tetrahedra each, vertices shaken by a seed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/random.h"
#include "geometry/predicates.h"
#include "geometry/tet_data.h"
#include "tests/support/seed.h"

namespace dsc::tests {

inline bool is_positive(const geometry::TetData& data, std::size_t tet) {
    const auto& [a, b, c, d] = data.tets[tet];
    return geometry::is_positive(data.vertices[a], data.vertices[b], data.vertices[c], data.vertices[d]);
}

/// Kuhn's triangulation of a grid: the corners of a tetrahedron are met on a way along x, y and z in some order.
inline geometry::TetData box_mesh(std::uint32_t n) {
    geometry::TetData data;
    for (std::uint32_t k = 0; k <= n; ++k)
        for (std::uint32_t j = 0; j <= n; ++j)
            for (std::uint32_t i = 0; i <= n; ++i) data.vertices.emplace_back(1.0 * i / n, 1.0 * j / n, 1.0 * k / n);
    const std::array<std::uint32_t, 3> step{1, n + 1, (n + 1) * (n + 1)};
    constexpr std::array<std::array<int, 3>, 6> ways{
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
    for (std::uint32_t k = 0; k < n; ++k) {
        for (std::uint32_t j = 0; j < n; ++j) {
            for (std::uint32_t i = 0; i < n; ++i) {
                for (std::size_t way = 0; way < ways.size(); ++way) {
                    std::array<std::uint32_t, 4> tet{i * step[0] + j * step[1] + k * step[2]};
                    for (std::size_t corner = 0; corner < 3; ++corner)
                        tet[corner + 1] = tet[corner] + step[static_cast<std::size_t>(ways[way][corner])];
                    if (way >= 3) std::swap(tet[2], tet[3]);  // an odd order
                    data.tets.push_back(tet);
                }
            }
        }
    }
    return data;
}

/// Moves the vertices that lie neither on the boundary nor on x = 1/2 by up to `reach` cells, where no tetrahedron
/// inverts.
inline void shake(geometry::TetData& data, std::uint32_t n, double reach, std::uint64_t seed) {
    std::vector<std::vector<std::size_t>> star(data.vertices.size());
    for (std::size_t tet = 0; tet < data.tets.size(); ++tet)
        for (const std::uint32_t v : data.tets[tet]) star[v].push_back(tet);
    core::Random random(seed);
    for (std::size_t v = 0; v < data.vertices.size(); ++v) {
        const Eigen::Vector3d old = data.vertices[v];
        if (old.minCoeff() == 0 || old.maxCoeff() == 1 || old.x() == 0.5) continue;
        for (double& x : data.vertices[v]) x += random.uniform(-reach, reach) / n;
        for (const std::size_t tet : star[v])
            if (!is_positive(data, tet)) data.vertices[v] = old;
    }
}

inline geometry::TetData shaken_box(std::uint32_t n, double reach = 0.45, std::uint64_t default_seed = 1) {
    geometry::TetData data = box_mesh(n);
    shake(data, n, reach, seed(default_seed));
    return data;
}

/// Regions 3 and 7 on the two sides of x = 1/2, which is an interface for even n.
inline geometry::TetData two_regions(std::uint32_t n) {
    geometry::TetData data = shaken_box(n);
    for (const auto& tet : data.tets) {
        double x = 0;
        for (const std::uint32_t v : tet) x += data.vertices[v].x() / 4;
        data.labels.push_back(x < 0.5 ? 3 : 7);
    }
    return data;
}

}  // namespace dsc::tests
