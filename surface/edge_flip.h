// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the edge between two triangles should be exchanged for the other diagonal: better angles, the same surface.
// Source: thesis 4.3.2.2: not a feature edge, not Delaunay, and the tetrahedron of the two triangles has hardly any
// volume; where the surface is flat, the Delaunay criterion is that the smallest angle rises. Guarantee: a flip changes
// the enclosed volume by that of the tetrahedron; every flip raises the smallest angle of its two triangles, so that
// flips never go round in circles for one pair of triangles. Cost: constant, no allocation.
//
//     if (surface::flip_gain(p(a), p(b), p(c), p(d), {})) flip(edge);
#pragma once

#include <optional>

#include "surface/one_ring.h"

namespace dsc::surface {

struct FlipParameters {
    /// Edges that bend by more stay [degree]. In (0, 90).
    double feature_angle = 40;
    /// Largest volume of the tetrahedron of the two triangles [longest edge cubed]; equilateral triangles that bend by
    /// an angle have sin(angle) / 8. In [0, 0.11].
    double max_volume = 0.003;
    /// Distance of the two diagonals up to which the triangles are in one plane, whatever the normal of a needle says
    /// [longest edge]. >= 0.
    double coplanar_distance = 1e-9;
    /// Least rise of the smallest angle [degree]. >= 0.
    double min_gain = 1;

    /// Throws core::UsageError that names the first field out of its range.
    void validate() const;
};

/// By how much the flip of ab raises the smallest angle of the triangles (a, b, c) and (b, a, d), which become (a, d,
/// c) and (d, b, c) [degree]; none when the flip should not be made.
std::optional<double> flip_gain(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                                const FlipParameters& parameters);

/// Volume of the tetrahedron abcd over the cube of its longest edge: 0 for a flat pair of triangles, at most 0.12.
double flatness(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

}  // namespace dsc::surface
