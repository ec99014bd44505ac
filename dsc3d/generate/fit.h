// SPDX-License-Identifier: GPL-3.0-or-later
// Fits a mesh to the zero set of a function, without stair-steps: vertices near it are put on it, edges that still
// cross it are split there, and every tetrahedron is labelled by the side on which it lies. Source: the two steps
// (warp, cut) of Labelle and Shewchuk, "Isosurface stuffing" (2007), on any mesh. Guarantee: every vertex of the new
// interface is within rounding of a zero of the function on an edge; all tetrahedra stay positive by exact predicate;
// the domain boundary keeps its place. Cost: linear, with some 10 evaluations of the function per vertex near the
// interface.
//
//     dsc3d::fit(mesh, [](const Point3& p) { return p.norm() - 0.3; }, {.inside = 1});
#pragma once

#include <functional>
#include <span>

#include "dsc3d/mesh.h"

namespace dsc::dsc3d {

struct FitParameters {
    int inside = 1;     ///< label where the function is negative; the rest keeps its label
    double warp = 0.3;  ///< a vertex moves when the surface cuts one of its edges within this share of its length
};

/// `function`: continuous, negative inside. Throws core::UsageError when the surface reaches the boundary of the
/// domain, or the function is not finite at a vertex.
void fit(Mesh& mesh, const std::function<double(const Point3&)>& function, const FitParameters& parameters = {});

/// The same for values at the vertices, in the order of their handles, and linear along the edges: for a function that
/// is dear, or known there only. Throws core::UsageError as above, and when there are not as many values as vertices.
void fit(Mesh& mesh, std::span<const double> values, const FitParameters& parameters = {});

}  // namespace dsc::dsc3d
