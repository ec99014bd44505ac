// SPDX-License-Identifier: GPL-3.0-or-later
// The body-centred cubic lattice in a box as a tetrahedral mesh: the start of a deformable complex.
// Source: Labelle and Shewchuk, "Isosurface stuffing" (2007), section 3: its tetrahedra have dihedral angles of 60 and
// 90 degrees; at the sides of the box pyramids are halved (45 degrees and more). Guarantee: positive, conforming, fills
// the box exactly. Cost: linear.
//
//     dsc3d::Mesh mesh(dsc3d::lattice({Point3(0, 0, 0), Point3(1, 1, 1)}, 0.1));
#pragma once

#include <Eigen/Geometry>

#include "geometry/tet_data.h"

namespace dsc::dsc3d {

/// Cubes with sides of about `spacing`, as many as fit each side of the box best. Throws core::UsageError when the box
/// is empty, the spacing not positive, or the lattice would have more than 2^30 vertices.
geometry::TetData lattice(const Eigen::AlignedBox3d& box, double spacing);

}  // namespace dsc::dsc3d
