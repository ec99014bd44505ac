// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/time_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace dsc::fluid {

template <int Dimension>
std::optional<double> capillary_limit(const std::vector<Vector<Dimension>>& positions,
                                      std::span<const SurfaceElement<Dimension>> surface, double density) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& element : surface) {
        if (element.tension == 0) continue;
        for (std::size_t a = 0; a < Dimension; ++a)
            for (std::size_t b = 0; b < a; ++b) {
                const double h = (positions[element.vertices[a]] - positions[element.vertices[b]]).norm();
                least = std::min(least, density * h * h * h / (2 * std::numbers::pi * std::abs(element.tension)));
            }
    }
    if (!std::isfinite(least)) return std::nullopt;
    return std::sqrt(least);
}

template <int Dimension>
std::optional<double> gravity_limit(const SimplexMesh<Dimension>& mesh, const Vector<Dimension>& gravity) {
    if (gravity.isZero(0)) return std::nullopt;
    double shortest = std::numeric_limits<double>::infinity();
    for (const auto& cell : mesh.cells)
        for (std::size_t a = 0; a <= Dimension; ++a)
            for (std::size_t b = 0; b < a; ++b)
                shortest = std::min(shortest, (mesh.positions[cell[a]] - mesh.positions[cell[b]]).norm());
    return std::sqrt(shortest / gravity.norm());
}

template <int Dimension>
std::optional<double> deformation_limit(const SimplexMesh<Dimension>& mesh,
                                        std::span<const Vector<Dimension>> velocities) {
    double fastest = 0;
    for (const auto& cell : mesh.cells)
        for (std::size_t a = 0; a <= Dimension; ++a)
            for (std::size_t b = 0; b < a; ++b)
                fastest = std::max(fastest, (velocities[cell[a]] - velocities[cell[b]]).norm() /
                                                (mesh.positions[cell[a]] - mesh.positions[cell[b]]).norm());
    if (fastest == 0) return std::nullopt;
    return 1 / fastest;
}

template std::optional<double> capillary_limit(const std::vector<Vector<2>>&, std::span<const SurfaceElement<2>>,
                                               double);
template std::optional<double> capillary_limit(const std::vector<Vector<3>>&, std::span<const SurfaceElement<3>>,
                                               double);
template std::optional<double> gravity_limit(const SimplexMesh<2>&, const Vector<2>&);
template std::optional<double> gravity_limit(const SimplexMesh<3>&, const Vector<3>&);
template std::optional<double> deformation_limit(const SimplexMesh<2>&, std::span<const Vector<2>>);
template std::optional<double> deformation_limit(const SimplexMesh<3>&, std::span<const Vector<3>>);

}  // namespace dsc::fluid
