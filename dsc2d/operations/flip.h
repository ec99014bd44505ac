// SPDX-License-Identifier: GPL-3.0-or-later
// Edge flip: the edge between two faces is replaced by the other diagonal of their quadrilateral.
// Source: thesis 4.3.1. Guarantee: can_flip is exact; after flip both faces are strictly counterclockwise and the cover is
// simplicial. Cost: constant, no allocation.
#pragma once

#include "dsc2d/complex.h"

namespace dsc::dsc2d {

/// True for an inner edge whose quadrilateral is strictly convex and whose other diagonal joins two different vertices.
/// Says nothing about the interface.
bool can_flip(const Complex& complex, EdgeId e);

/// Precondition: can_flip and not is_interface(e).
void flip(Complex& complex, EdgeId e);

/// Flip of an interface edge, which changes the topology of the interface: both faces get the label of face(h).
/// Precondition: can_flip(edge(h)).
void flip_to_label_of(Complex& complex, HalfedgeId h);

}  // namespace dsc::dsc2d
