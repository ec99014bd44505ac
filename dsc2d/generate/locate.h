// SPDX-License-Identifier: GPL-3.0-or-later
// Point location by walking in the universal cover, and insertion of a point.
// Source: Devillers, Pion, Teillaud (2002), "Walking in a triangulation". Guarantee: exact; the walk ends with
// probability one in any triangulation (edges are tried in a seeded random order, the same on every run).
// Cost: about the square root of the number of faces.
#pragma once

#include <optional>

#include "dsc2d/complex.h"

namespace dsc::dsc2d {

struct Location {
    HalfedgeId halfedge;  ///< of the face that contains the point
    LatticeVector cell;   ///< position(from(halfedge)) + translation(cell) is the corner near the point
    int zero_sides;       ///< 0: inside; 1: on edge(halfedge); 2: at vertex from(halfedge)
};

/// Nothing when the point lies outside a domain with boundary. Precondition: point on the grid and in reach.
std::optional<Location> locate(const Complex& complex, const Point2& point);

struct CoverVertex {
    VertexId vertex;
    LatticeVector cell;  ///< position(vertex) + translation(cell) is the point
};

/// The vertex at the point, a new one if there is none; a new vertex has exactly the cover coordinates given (on the
/// grid). Throws core::InputError when the point lies outside the domain or on its boundary.
CoverVertex insert_point(Complex& complex, const Point2& point);

}  // namespace dsc::dsc2d
