// SPDX-License-Identifier: GPL-3.0-or-later
// The Delaunay tetrahedralization of points: fills their convex hull. Source: CGAL, which places points in a spatial
// order and breaks ties of cospherical points by perturbation (Devillers, Teillaud 2011), so that no tetrahedron is
// flat. Guarantee: every different point is a vertex, with its number; positive, conforming; the same bits for the same
// input. Cost: some 10 us per point.
//
//     dsc3d::Mesh mesh(dsc3d::delaunay(points));
#pragma once

#include <span>

#include "geometry/predicates.h"
#include "geometry/tet_data.h"

namespace dsc::dsc3d {

using geometry::Point3;

/// Throws core::UsageError unless there are four points that are not in a plane.
geometry::TetData delaunay(std::span<const Point3> points);

}  // namespace dsc::dsc3d
