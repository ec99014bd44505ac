// SPDX-License-Identifier: GPL-3.0-or-later
// The connected parts of the labels' regions: faces of one label that share an edge are in one part.
// Cost: linear in the mesh, but for the inverse of Ackermann's function.
#pragma once

#include "core/disjoint_sets.h"
#include "dsc2d/complex.h"

namespace dsc::dsc2d {

/// Over the handles of the faces; deleted ones are alone.
core::DisjointSets components(const Complex& complex);

}  // namespace dsc::dsc2d
