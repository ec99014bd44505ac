// SPDX-License-Identifier: GPL-3.0-or-later
// Tangential smoothing of a vertex that leaves the surface as it is: towards the mean of the centroids of its
// triangles, within the null space of its quadric.
// Source: thesis 4.3.2.2; Jiao (2007). Corners stay, vertices of a ridge slide along it, the others in their tangent
// plane; and all of them perpendicular to the sum of the area vectors of the ring.
// Guarantee: where the surface is of planes no vertex leaves its planes (to rounding); a closed ring of one sheet
// encloses the same volume afterwards (to rounding), because the volume is linear in the place of its centre; the
// surface moves by no more than `freedom`. Cost: quadratic in the ring, which is small; no allocation.
//
//     if (const std::optional<Point3> place = surface::smoothed_position(ring, {})) move(v, *place);
#pragma once

#include <optional>

#include "surface/features.h"
#include "surface/one_ring.h"

namespace dsc::surface {

struct SmoothingParameters {
    /// Edges that bend by more are ridges [degree]. In (0, 90).
    double feature_angle = 40;
    /// How far the surface may move where it is curved [mean edge length at the vertex]. >= 0.
    double freedom = 0.02;
    /// Rings whose smallest angle is above this are left as they are [degree]. In [0, 60].
    double good_angle = 30;

    /// Throws core::UsageError that names the first field out of its range.
    void validate() const;
};

/// Where Jiao's smoothing would put the centre, minus the centre; `freedom` is kept.
Vector3 null_space_displacement(const OneRing& ring, const VertexQuadric& quadric, VertexFeature feature,
                                const SmoothingParameters& parameters);

/// The place of the centre after the whole displacement, half of it or a quarter, the first that raises the smallest
/// angle of the ring and turns no triangle over; none when there is no such place or the ring is good.
std::optional<Point3> smoothed_position(const OneRing& ring, const SmoothingParameters& parameters);

/// Smallest angle of the triangles of the ring when its centre is at `centre` [rad].
double min_angle_at(const OneRing& ring, const Point3& centre);

}  // namespace dsc::surface
