// SPDX-License-Identifier: GPL-3.0-or-later
// Where a triangle surface intersects itself.
// Source: A. Zomorodian, H. Edelsbrunner (2002), "Fast software for box intersections", for the pairs that come into
// question; predicates of CGAL's exact kernel for each.
// Guarantee: exact for the coordinates given; touching counts. Triangles without a common vertex must not meet at all;
// with one common vertex, not beyond it; with a common edge, not overlap. Vertices at the same place but of different
// index are different ones. Triangles of no area are left out: geometry/surface_check.h lists them.
// Cost: O(n log³ n + candidates), about 3 s per million triangles of a surface without intersections.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/surface_data.h"

namespace dsc::geometry {

/// Pairs of intersecting triangles, the lower index first, in ascending order. Coordinates have to be finite.
std::vector<std::array<std::uint32_t, 2>> self_intersections(const SurfaceData& surface);

}  // namespace dsc::geometry
