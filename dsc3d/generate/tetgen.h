// SPDX-License-Identifier: GPL-3.0-or-later
// Constrained Delaunay tetrahedralization by the program TetGen, run as a process of its own: its licence (AGPL)
// doesn't extend to programs that call it so. Source: H. Si (2015), "TetGen, a Delaunay-based quality tetrahedral mesh
// generator"; thesis 3.5 (meshes of its table 3.1).
// Guarantee: the points given keep their order and coordinates, those that TetGen adds follow; every input triangle is
// the face of a tetrahedron. Cost: some 10 microseconds per tetrahedron and a few files in the temporary folder, which
// are removed.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/observer.h"
#include "geometry/predicates.h"
#include "geometry/tet_data.h"

namespace dsc::dsc3d {

using geometry::Point3;

/// A plane polygon and points within it that have to be vertices of its triangulation.
struct PlaneFacet {
    std::vector<std::uint32_t> outline;
    std::vector<std::uint32_t> points;
};

struct TetGenInput {
    std::vector<Point3> points;  ///< used by triangles and facets
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<PlaneFacet> facets;
    std::vector<Point3> free_points;  ///< inside
};

/// Throws core::RunError when `program`, a name to be found in PATH or a path, can't be run, or fails; core::Cancelled
/// when the observer asks for it: then the program is ended.
geometry::TetData tetgen(const TetGenInput& input, const std::string& program, core::Observer& observer);

}  // namespace dsc::dsc3d
