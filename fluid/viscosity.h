// SPDX-License-Identifier: GPL-3.0-or-later
// The viscous forces of linear velocities: the second derivative of the dissipation, integral of mu |grad u + grad
// u^T|^2 / 4, by the velocities. A free surface carries no viscous traction by itself; rigid motions dissipate nothing.
// Source: the term that thesis 6.6 misses; its weak form as in any text on Stokes flow. Cost: linear.
#pragma once

#include <span>
#include <vector>

#include "fluid/elements.h"

namespace dsc::fluid {

/// Entries to be summed, `scale` times those of the matrix. `viscosities`: dynamic ones, of each phase.
template <int Dimension>
void add_viscosity_matrix(const SimplexMesh<Dimension>& mesh, const Elements<Dimension>& elements,
                          std::span<const double> viscosities, double scale,
                          std::vector<Eigen::Triplet<double, int>>& entries);

}  // namespace dsc::fluid
