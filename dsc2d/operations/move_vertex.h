// SPDX-License-Identifier: GPL-3.0-or-later
// Vertex motion along a straight line, up to the link of the vertex.
// Source: thesis algorithm 5. Guarantee: motion stops short of the link, where every face of the star is still strictly
// counterclockwise by exact predicate; there is never a flat face. Cost: linear in the valence, no allocation.
#pragma once

#include "dsc2d/complex.h"

namespace dsc::dsc2d {

struct MoveResult {
    bool is_reached;      ///< the vertex is at its target
    double fraction;      ///< share of the way that was made, in [0, 1]
    HalfedgeId blocking;  ///< the outgoing half-edge whose face is in the way; invalid when the target was reached
};

/// How much of the way to the link is used, in (0, 1).
struct Approach {
    double to_mesh;       ///< when the link is met at an edge inside a region
    double to_interface;  ///< when the link is met at an edge of the interface, which may itself be on its way
};

/// True when every face at v would be strictly counterclockwise with v at `place`, which must be on the grid.
bool can_move_vertex(const Complex& complex, VertexId v, const Point2& place);

/// Moves v to `target` (cover coordinates, on the grid), or as far as it goes. Precondition: v is not on the boundary.
MoveResult move_vertex(Complex& complex, VertexId v, const Point2& target, const Approach& approach);

}  // namespace dsc::dsc2d
