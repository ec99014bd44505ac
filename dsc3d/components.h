// SPDX-License-Identifier: GPL-3.0-or-later
// The connected parts of the labels' regions: tetrahedra of one label that share a face are in one part.
// Cost: linear in the mesh, but for the inverse of Ackermann's function.
#pragma once

#include "core/disjoint_sets.h"
#include "dsc3d/complex/complex.h"

namespace dsc::dsc3d {

/// Over the handles of the tetrahedra; deleted ones are alone.
core::DisjointSets components(const Complex& complex);

}  // namespace dsc::dsc3d
