// SPDX-License-Identifier: GPL-3.0-or-later
// Corners and centres of the leaves of an octree around a cloud: the vertices of a body-centred lattice that is as fine
// as asked for at the points and grows with the distance from them. Source: Yerry, Shephard (1984); Labelle, Shewchuk
// (2007). Guarantee: no two equal; the corners of the cube are among them; in the order of the leaves, near ones
// near each other. Cost: n log n.
#pragma once

#include <span>
#include <vector>

#include "apps/reconstruct/kd_tree.h"

namespace dsc::reconstruct {

/// `cell`: wanted side of a leaf at each point, met within a factor of sqrt(2); `growth` per distance. The cube has its
/// centre in the origin.
std::vector<Point3> octree_points(const KdTree& tree, std::span<const double> cell, double growth, double half_side);

}  // namespace dsc::reconstruct
