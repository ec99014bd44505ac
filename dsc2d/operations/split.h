// SPDX-License-Identifier: GPL-3.0-or-later
// Splits: a new vertex on an edge or inside a face.
// Source: thesis 4.3.1 (detail control), 5.2.2 (refinement of the front). Guarantee: the new faces are strictly
// counterclockwise by exact predicate and inherit label and interface flags; the new vertex is not locked and its cover
// coordinates lie in the period of from(h). Cost: constant, amortized growth of the arrays.
#pragma once

#include <optional>

#include "dsc2d/complex.h"

namespace dsc::dsc2d {

/// Where a split of edge(h) at parameter s (0 at from(h), 1 at to(h)) would put its vertex, on the grid; nothing when a
/// face would not stay strictly counterclockwise. An edge of the domain's boundary is split only where that is exact.
std::optional<Point2> can_split_edge(const Complex& complex, HalfedgeId h, double s);
/// Precondition: `place` comes from can_split_edge(complex, h, s).
VertexId split_edge(Complex& complex, HalfedgeId h, const Point2& place);

/// True when `place`, given in the period of from(h), lies strictly inside face(h).
bool can_split_face(const Complex& complex, HalfedgeId h, const Point2& place);
VertexId split_face(Complex& complex, HalfedgeId h, const Point2& place);

/// True when `place`, given in the period of from(h), may be the new vertex of edge(h).
bool can_split_edge_at(const Complex& complex, HalfedgeId h, const Point2& place);

}  // namespace dsc::dsc2d
