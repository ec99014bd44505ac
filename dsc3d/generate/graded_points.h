// SPDX-License-Identifier: GPL-3.0-or-later
// Points for a tetrahedral mesh of a box around a surface: dense next to the surface, sparse far from it, and as
// regular as a body-centred lattice in between. Source: corners and centres of an octree whose leaves follow the wanted
// edge length (octree meshing after Yerry and Shephard, 1984; body-centred as in Labelle and Shewchuk, "Isosurface
// stuffing", 2007), thinned by a Poisson-disk condition where leaves of different size meet.
// Guarantee: the corners of the box are among the points, points on its sides lie there exactly; none is near the
// surface or near another one; the same bits for the same input. Cost: n log n, some microseconds per point.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "core/observer.h"
#include "dsc3d/generate/sizing.h"

namespace dsc::dsc3d {

struct GradedPointsParameters {
    double leaf = 1.3;         ///< size of a leaf, in wanted edge lengths: then the points are about one apart
    double separation = 0.75;  ///< least distance of two points, in wanted edge lengths
    double clearance = 0.7;    ///< least distance from the surface, in edge lengths of the surface
};

struct GradedPoints {
    std::vector<Point3> on_box;  ///< the eight corners first
    std::vector<Point3> inside;
};

/// Throws core::UsageError when that would be more than 2^22 points, or the box is more than 2^30 times as large as the
/// edges of the surface, core::Cancelled when the observer asks for it.
GradedPoints graded_points(const Eigen::AlignedBox3d& box, const Sizing& sizing, core::Observer& observer,
                           const GradedPointsParameters& parameters = {});

}  // namespace dsc::dsc3d
