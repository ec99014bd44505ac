// SPDX-License-Identifier: GPL-3.0-or-later
// Distances of points from a surface. Source: CGAL's AABB tree. Guarantee: exact but for rounding; the same bits on any
// number of threads. Cost: some 5 us per point.
#pragma once

#include <span>
#include <vector>

#include "geometry/predicates.h"
#include "geometry/surface_data.h"

namespace dsc::reconstruct {

using geometry::Point3;

/// Precondition: the surface has a triangle. Zero threads mean all.
std::vector<double> distances_from_surface(std::span<const Point3> points, const geometry::SurfaceData& surface,
                                           int threads);

}  // namespace dsc::reconstruct
