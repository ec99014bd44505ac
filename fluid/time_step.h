// SPDX-License-Identifier: GPL-3.0-or-later
// How long a step may be: shorter than the period of the shortest capillary wave, and not so long that a cell is turned
// over. Source: J. U. Brackbill, D. B. Kothe, C. Zemach (1992), "A continuum method for modeling surface tension",
// equation (61): sqrt(rho h^3 / (2 pi gamma)). Cost: linear.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fluid/surface_energy.h"

namespace dsc::fluid {

/// The least sqrt(rho h^3 / (2 pi gamma)) over the edges h of the surface; none without tension. `density`: of the
/// lightest fluid at the surface.
template <int Dimension>
std::optional<double> capillary_limit(const std::vector<Vector<Dimension>>& positions,
                                      std::span<const SurfaceElement<Dimension>> surface, double density);

/// sqrt(h / g) with the shortest edge h of the mesh: the time in which gravity takes a wave of that length through
/// about half of a period; none without gravity.
template <int Dimension>
std::optional<double> gravity_limit(const SimplexMesh<Dimension>& mesh, const Vector<Dimension>& gravity);

/// The time in which the ends of an edge come closer by its length, at least, over all edges; none when nothing moves.
template <int Dimension>
std::optional<double> deformation_limit(const SimplexMesh<Dimension>& mesh,
                                        std::span<const Vector<Dimension>> velocities);

}  // namespace dsc::fluid
