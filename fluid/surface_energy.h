// SPDX-License-Identifier: GPL-3.0-or-later
// The energy of surfaces, tension times area (in the plane: times length), with its gradient and the positive part of
// its second derivative. Source: thesis 6.4.3; the second derivative is what it names as a next step (6.6).
// Guarantee: gradients sum to zero and exert no torque, so that tension changes no momentum. The positive part of the
// Hessian is positive semidefinite. Cost: linear.
#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <span>
#include <vector>

#include "fluid/simplex_mesh.h"

namespace dsc::fluid {

/// A facet with tension. [energy / area]; negative where a wall attracts the fluid more than the void does.
template <int Dimension>
struct SurfaceElement {
    std::array<std::uint32_t, Dimension> vertices;
    double tension;
};

template <int Dimension>
double surface_energy(const std::vector<Vector<Dimension>>& positions,
                      std::span<const SurfaceElement<Dimension>> surface);

/// Of the energy, all coordinates of all vertices.
template <int Dimension>
Eigen::VectorXd surface_energy_gradient(const std::vector<Vector<Dimension>>& positions,
                                        std::span<const SurfaceElement<Dimension>> surface);

enum class HessianPart {
    whole,
    positive,  ///< without the negative eigenvalues of each element
};

/// Entries to be summed, `scale` times those of the Hessian.
template <int Dimension>
void add_surface_energy_hessian(const std::vector<Vector<Dimension>>& positions,
                                std::span<const SurfaceElement<Dimension>> surface, HessianPart part, double scale,
                                std::vector<Eigen::Triplet<double, int>>& entries);

}  // namespace dsc::fluid
