// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/implicit_curvature.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "core/assert.h"
#include "core/errors.h"
#include "surface/curvature.h"

namespace dsc::surface {

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Columns = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// Vertices that move are the unknowns, in the order of the vertices.
constexpr int known = -1;

struct System {
    Matrix matrix;
    Columns right;
};

System system(const geometry::SurfaceData& surface, const std::vector<int>& unknown, int count, double dt) {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(12 * surface.triangles.size());
    System result{Matrix(count, count), Columns::Zero(count, 3)};

    const auto add_mass = [&](std::uint32_t v, double area) {
        if (unknown[v] == known) return;
        entries.emplace_back(unknown[v], unknown[v], area);
        result.right.row(unknown[v]) += area * surface.vertices[v].transpose();
    };
    const auto add_edge = [&](std::uint32_t v, std::uint32_t w, double weight) {
        if (unknown[v] == known) return;
        entries.emplace_back(unknown[v], unknown[v], weight);
        if (unknown[w] == known) {
            result.right.row(unknown[v]) += weight * surface.vertices[w].transpose();
        } else {
            entries.emplace_back(unknown[v], unknown[w], -weight);
        }
    };
    for (const auto& triangle : surface.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t v = triangle[i], p = triangle[(i + 1) % 3], q = triangle[(i + 2) % 3];
            const CotangentTriangle t = cotangents(surface.vertices[v], surface.vertices[p], surface.vertices[q]);
            add_mass(v, t.mixed_area);
            add_edge(v, p, dt * t.cot_q / 2);
            add_edge(v, q, dt * t.cot_p / 2);
        }
    }
    result.matrix.setFromTriplets(entries.begin(), entries.end());
    return result;
}

}  // namespace

std::vector<Point3> implicit_curvature_step(const geometry::SurfaceData& surface, double dt,
                                            std::span<const std::uint8_t> is_fixed) {
    DSC_ASSERT(dt > 0);
    DSC_ASSERT(is_fixed.empty() || is_fixed.size() == surface.vertices.size());
    std::vector<int> unknown(surface.vertices.size(), known);
    for (const auto& triangle : surface.triangles) {
        for (const std::uint32_t v : triangle) unknown[v] = 0;
    }
    int count = 0;
    for (std::size_t v = 0; v < unknown.size(); ++v) {
        if (!is_fixed.empty() && is_fixed[v] != 0) unknown[v] = known;
        if (unknown[v] != known) unknown[v] = count++;
    }
    std::vector<Point3> positions = surface.vertices;
    if (count == 0) return positions;

    const System equations = system(surface, unknown, count, dt);
    const Eigen::SimplicialLDLT<Matrix> solver(equations.matrix);
    if (solver.info() != Eigen::Success) throw core::RunError("implicit curvature step: triangles have no area");
    const Columns solution = solver.solve(equations.right);
    if (!solution.allFinite()) throw core::RunError("implicit curvature step: triangles have no area");
    for (std::size_t v = 0; v < unknown.size(); ++v) {
        if (unknown[v] != known) positions[v] = solution.row(unknown[v]).transpose();
    }
    return positions;
}

}  // namespace dsc::surface
