// SPDX-License-Identifier: GPL-3.0-or-later
// Which vertices and edges of a surface carry its shape: corners and ridges, by the angle between triangles and by the
// quadric. Source: thesis 4.3.2.2 ("feature edge"); Jiao (2007). Guarantee: depends on the planes, not on how they are
// triangulated. Cost: quadratic in the ring, which is small; no allocation.
#pragma once

#include <cstdint>
#include <optional>

#include "surface/one_ring.h"
#include "surface/vertex_quadric.h"

namespace dsc::surface {

/// In the order of how much they hold a vertex.
enum class VertexFeature : std::uint8_t { smooth, ridge, corner };

/// Angle between the normals of the triangles (a, b, c) and (b, a, d), 0 where they are in one plane [degree].
double bend(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// An edge is a feature when it bends by more than `feature_angle` [degree].
bool is_feature_edge(const Point3& a, const Point3& b, const Point3& c, const Point3& d, double feature_angle);

/// The edge from the centre to the neighbour at `end`, by the triangles of the ring at it; an edge that is not between
/// two triangles is a feature. Precondition: `end` is the position of a neighbour, bit for bit.
bool is_feature_edge(const OneRing& ring, const Point3& end, double feature_angle);

/// The neighbour at the other feature edge of the centre, when there is exactly one besides that to `end`.
std::optional<Point3> other_feature_end(const OneRing& ring, const Point3& end, double feature_angle);

/// A corner: the quadric has rank 3, or three feature edges meet, or two that turn by more than `feature_angle`.
/// A ridge: rank 2, or two feature edges in line.
VertexFeature vertex_feature(const OneRing& ring, const VertexQuadric& quadric, double feature_angle);

}  // namespace dsc::surface
