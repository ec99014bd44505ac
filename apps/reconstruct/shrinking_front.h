// SPDX-License-Identifier: GPL-3.0-or-later
// The front of the thesis: a sphere around everything that moves inwards without a change of its topology, tetrahedron
// by tetrahedron. Where it meets itself it stops: a tunnel keeps a film of tetrahedra at its narrowest place, separate
// parts hang together by a thread, cavities are filled.
// Source: thesis 4.4.3 (bounding surface that shrinks onto the cloud); simple points: Bertrand (1994), "Simple points,
// topological numbers and geodesic neighborhoods in cubic grids", here for tetrahedra: one may change its label when it
// meets the front in a disk. Guarantee: the interface is one closed manifold of genus 0. Cost: some 5 us per
// tetrahedron.
#pragma once

#include "apps/reconstruct/front.h"
#include "apps/reconstruct/kd_tree.h"

namespace dsc::reconstruct {

/// Labels as inside what the front does not reach through outside tetrahedra, those farthest from the cloud first.
/// Throws core::RunError when the front is stuck at the box.
void shrink_to_genus_zero(dsc3d::Mesh& mesh, const KdTree& cloud);

}  // namespace dsc::reconstruct
