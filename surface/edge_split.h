// SPDX-License-Identifier: GPL-3.0-or-later
// Where the new vertex of an edge that is halved goes: on the curved surface that the rings of its ends suggest, not on
// the chord, which cuts off volume.
// Source: thesis 4.3.2.2 (long edges are split); the cubic of PN triangles: Vlachos, Peters, Boyd, Mitchell (2001), at
// its middle; along ridges the cubic through the ridge's own tangents. Guarantee: a surface of planes and straight
// ridges stays as it is (to rounding); along a circle the new vertex is on it to fourth order in the length, where a
// chord is to second, and on a ball within a tenth of what the chord misses it by, whose normals at irregular
// vertices are no better. Cost: quadratic in the rings, which are small; no allocation.
//
//     mesh.split(edge, surface::split_position(ring(a), ring(b), {}));
#pragma once

#include "surface/one_ring.h"

namespace dsc::surface {

struct SplitParameters {
    /// Edges that bend by more are ridges [degree]. In (0, 90).
    double feature_angle = 40;

    /// Throws core::UsageError that names the first field out of its range.
    void validate() const;
};

/// Precondition: each centre is the position of a neighbour in the other ring, bit for bit.
Point3 split_position(const OneRing& a, const OneRing& b, const SplitParameters& parameters);

}  // namespace dsc::surface
