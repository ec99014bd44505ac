// SPDX-License-Identifier: GPL-3.0-or-later
// Laplacians of the pressure over the facets between cells. The stabilization S lets a little fluid flow from a cell of
// higher pressure to its neighbour, so that linear velocities and constant pressures don't lock.
// Source: thesis 6.4.4, equation (6.11), with delta = beta / (rho h_ij), h_ij the distance of the centroids: then beta
// has no dimension. Guarantee: symmetric, positive semidefinite; rows sum to zero, so that the volume of the fluid is
// kept. Cells of different phases are never coupled: the pressure may jump there, and no fluid may leave its phase.
#pragma once

#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "fluid/facets.h"

namespace dsc::fluid {

/// S for beta = 1.
template <int Dimension>
Eigen::SparseMatrix<double> stabilization_matrix(const SimplexMesh<Dimension>& mesh,
                                                 std::span<const Facet<Dimension>> facets,
                                                 std::span<const double> densities);

/// The finite volume Laplacian of the pressure over density with zero pressure outside of the fluid: spectrally like
/// the Schur complement, but with a row as short as a cell has neighbours. `is_closed`: of each facet, that it is held
/// by a wall.
template <int Dimension>
Eigen::SparseMatrix<double> pressure_laplacian(const SimplexMesh<Dimension>& mesh,
                                               std::span<const Facet<Dimension>> facets,
                                               std::span<const double> densities, const std::vector<char>& is_closed);

}  // namespace dsc::fluid
