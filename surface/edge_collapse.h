// SPDX-License-Identifier: GPL-3.0-or-later
// Where the two ends of an edge should become one vertex, if at all: corners and ridges stay, the triangles left do
// not turn and do not become slivers.
// Source: thesis 4.3.2.2 ("non-feature edges shorter than a threshold"); the position between two smooth ends keeps the
// volume: Lindstrom, Turk (1998), "Fast and memory efficient polygonal simplification". Edges along a ridge are
// shortened too, to one of their ends: a moving ridge would be left with ever shorter edges otherwise.
// Guarantee: a surface of planes stays as it is (to rounding); between two smooth ends with closed rings the enclosed
// volume stays (to rounding). Cost: quadratic in the rings, which are small; no allocation. Whether the mesh allows the
// collapse (link condition, other cells) is for the mesh to say.
#pragma once

#include <optional>

#include "surface/features.h"
#include "surface/one_ring.h"

namespace dsc::surface {

struct CollapseParameters {
    /// Edges that bend by more are ridges [degree]. In (0, 90).
    double feature_angle = 40;
    /// Largest turn of a triangle that is left [degree]. In (0, 90).
    double max_turn = 20;
    /// Least angle of the triangles that are left, unless they had a smaller one before [degree]. In [0, 60).
    double min_angle = 10;

    /// Throws core::UsageError that names the first field out of its range.
    void validate() const;
};

/// The place of the vertex that replaces both ends, whose rings are `a` and `b`; none when they had better stay.
/// Feature of an end: vertex_feature(); `is_feature_edge`: the edge bends by more than the feature angle, or is not
/// between two triangles.
std::optional<Point3> collapsed_position(const OneRing& a, VertexFeature feature_a, const OneRing& b,
                                         VertexFeature feature_b, bool is_feature_edge,
                                         const CollapseParameters& parameters);
/// The same, when the features are not known yet.
std::optional<Point3> collapsed_position(const OneRing& a, const OneRing& b, const CollapseParameters& parameters);

/// Where both ends of an edge that is too short to mean anything go, whatever that does to the surface: to the end that
/// carries more of the shape, or to the middle.
Point3 dominant_position(const OneRing& a, const OneRing& b, const CollapseParameters& parameters);

}  // namespace dsc::surface
