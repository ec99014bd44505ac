// SPDX-License-Identifier: GPL-3.0-or-later
// The shape of least surface among those with the connectivity of a closed polyhedron (in the plane: polygon) and its
// volume: what a drop of this mesh is at rest. Source: thesis 6.5 starts from a reprojected sphere, which is not quite
// at rest. Newton's method on grad A = lambda grad V, V = V_0, among displacements without rigid motion. Guarantee: the
// volume is V_0 and the gradient is balanced to the tolerance, or core::RunError. Cost: a few sparse factorizations.
#pragma once

#include <vector>

#include "fluid/surface_energy.h"

namespace dsc::fluid {

struct EquilibriumParameters {
    /// Of the unbalanced gradient, relative to the gradient of the area. > 0.
    double tolerance = 1e-12;
    /// > 0.
    int max_iterations = 60;
};

/// Positions of least area; vertices that no element has stay. All tensions count as one.
template <int Dimension>
std::vector<Vector<Dimension>> equilibrium(std::vector<Vector<Dimension>> positions,
                                           std::span<const SurfaceElement<Dimension>> surface,
                                           const EquilibriumParameters& parameters = {});

}  // namespace dsc::fluid
