// SPDX-License-Identifier: GPL-3.0-or-later
// Local thickness of what a closed surface encloses: the distance from a vertex, straight inwards, to the plane of the
// triangle where the ray leaves again. It is h everywhere on a slab of thickness h and the diameter on a ball; where
// the opposite side is not parallel, the distance to its plane is less than the length of the ray.
// Source: thesis 4.3.2.2 asks for detail where it is needed; Shapira, Shamir, Cohen-Or (2008), "Consistent mesh
// partitioning and skeletonisation using the shape diameter function", with one ray and the plane it meets. Guarantee:
// triangles at the vertex itself and those that face the ray do not count. Cost: n log n for n triangles (an AABB
// tree).
#pragma once

#include <vector>

#include "geometry/surface_data.h"

namespace dsc::surface {

/// Thickness at each vertex; infinite where the ray meets nothing, as at a vertex that no triangle uses.
std::vector<double> thickness(const geometry::SurfaceData& surface);

}  // namespace dsc::surface
