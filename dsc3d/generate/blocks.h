// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces with faces along the coordinate planes: a box, a cube with a slot, a block of three labels.
// Guarantee: closed, oriented, manifold (for the block of three labels: each label's surface is); faces are exactly
// plane; the triangles are halves of rectangles whose sides are as near to the edge length as whole parts allow, their
// diagonals alternating. The same bits everywhere. Throws core::UsageError, naming the shape, for lengths that are not
// positive or don't fit together. Cost: linear, below a microsecond per triangle.
//
//     geometry::SurfaceData cube = dsc3d::box_surface({Point3(0, 0, 0), Point3(1, 1, 1)}, 0.1);  // 1200 triangles
#pragma once

#include <Eigen/Geometry>

#include "geometry/interface_data.h"
#include "geometry/predicates.h"

namespace dsc::dsc3d {

using geometry::Point3;

geometry::SurfaceData box_surface(const Eigen::AlignedBox3d& box, double edge_length);

struct SlottedCubeSize {
    double side = 0.4;
    double slot_width = 0.1;  ///< in direction x, in the middle of the cube; in (0, side)
    double slot_depth = 0.2;  ///< in direction -z, from the top; in (0, side)
};

/// A cube that is cut in direction y through its whole length.
geometry::SurfaceData slotted_cube(const Point3& centre, const SlottedCubeSize& size, double edge_length);

/// A box of three labels that meet in a line in direction y through its centre: 1 fills the half of low x, 2 and 3
/// the lower and the upper half of the rest. Outside is 0.
geometry::InterfaceData labelled_block(const Eigen::AlignedBox3d& box, double edge_length);

}  // namespace dsc::dsc3d
