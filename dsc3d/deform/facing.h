// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a tetrahedron separates two sheets of its region's surface, or a sheet and a wall of the domain. Two sheets:
// all its vertices are on the interface, and it is
// thin along the normals of two of them, which point away from each other; or the region has a waist there, as an
// hourglass, whose normals point elsewhere: a face inside with three edges on the interface, or an edge inside between
// two of its vertices. One sheet, however flat the tetrahedra under it, faces nothing. A wall: some of its vertices are
// on it, the other ones on the interface, and one of these is near the plane of the wall and its sheet looks towards
// it. Source: what the thesis (4.3.2.1) calls a collision, judged by distance and direction instead of by the quality
// of the tetrahedron alone, which does not tell a contact from a sliver. Cost: linear in four stars.
#pragma once

#include <optional>

#include "dsc3d/deform/pass_context.h"

namespace dsc::dsc3d {

/// Two vertices of a tetrahedron on sheets that face each other; with a wall, b is on the wall.
struct Facing {
    VertexId a, b;
    double gap;              ///< of the sheets' planes at the vertices, the wider one; at a waist its width
    Eigen::Vector3d across;  ///< from a to b; with a wall, along its normal
};

/// The nearest sheets across t that are closer than `distance`, in units of the least edge length wanted at t; or the
/// wall that a sheet is closest to.
std::optional<Facing> facing_sheets(PassContext& context, TetId t, double distance);

/// Whether the two wanted to come closer in this substep. What rests, parts, or goes along a wall is no collision,
/// however near.
bool is_closing(const PassContext& context, const Facing& facing);

}  // namespace dsc::dsc3d
