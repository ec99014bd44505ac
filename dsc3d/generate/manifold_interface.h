// SPDX-License-Identifier: GPL-3.0-or-later
// Labels changed until the surface of a region is a manifold: where the region, or the rest, touches itself in an edge
// or a vertex only, the smaller of the pieces that touch goes to the other side. Source: thesis 2.1.1 (links).
// Guarantee: only tetrahedra at such edges and vertices change, none of them back again more often than `most_rounds`;
// the same bits for the same input. Cost: linear in the stars of the interface, per round.
#pragma once

#include <cstddef>

#include "dsc3d/mesh.h"

namespace dsc::dsc3d {

struct ManifoldInterfaceReport {
    std::size_t relabelled = 0;  ///< changes of a tetrahedron's label
    std::size_t pinches = 0;     ///< edges and vertices where it is still no manifold
};

/// `inside` is the label of the region, `outside` that of all the rest.
ManifoldInterfaceReport make_interface_manifold(Mesh& mesh, int inside, int outside, int most_rounds = 30);

}  // namespace dsc::dsc3d
