// SPDX-License-Identifier: GPL-3.0-or-later
// Motion in the normal direction that keeps corners and ridges: the planes of the triangles at a vertex are offset, and
// the vertex goes to where they meet.
// Source: thesis 4.4.1.3; Jiao (2007), "Face offsetting: a unified approach for explicit moving interfaces". Least
// squares over the planes, each weighing as much as its angle at the vertex, within the primary space of the quadric:
// along the normal on a smooth piece, across a ridge, anywhere at a corner; the part in the null space is zero.
// Guarantee: when the planes are further apart than `feature_angle` and have a point in common, as at the corners and
// edges of a polyhedron, the vertex goes there (to rounding), however the planes are triangulated. Cost: linear in the
// ring, no allocation.
//
//     const Vector3 step = surface::offset_displacement(ring, distance, {});   // grows for distance > 0
#pragma once

#include <span>

#include "surface/one_ring.h"
#include "surface/vertex_quadric.h"

namespace dsc::surface {

struct OffsetParameters {
    /// Planes whose normals are further apart are kept apart [degree]. In (0, 90).
    double feature_angle = 30;
    /// Longest step of a vertex: the tip of a needle would run away [largest distance of its planes]. >= 1.
    double max_stretch = 5;

    /// Throws core::UsageError that names the first field out of its range.
    void validate() const;
};

/// Displacement of the centre when the plane of triangle i moves by distances[i] along its normal.
Vector3 offset_displacement(const OneRing& ring, std::span<const double> distances, const OffsetParameters& parameters);
/// ... when all planes move by `distance`.
Vector3 offset_displacement(const OneRing& ring, double distance, const OffsetParameters& parameters);

}  // namespace dsc::surface
