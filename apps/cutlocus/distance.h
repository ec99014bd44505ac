// SPDX-License-Identifier: GPL-3.0-or-later
// The distance from p to a point of the surface, and all minimising geodesics between them, from the cut locus of p.
#pragma once

#include <vector>

#include "apps/cutlocus/cut_graph.h"
#include "geodesic/geodesic_flow.h"

namespace dsc::cutlocus {

/// All minimising geodesics from p to `target` (any point of the chart), of equal length up to `tolerance`, in the
/// order of their directions: one, or several if the point lies on the cut locus. Geodesics that belong to the inside
/// of the cut locus of p are tried near the target, by Newton's method. Throws core::RunError if none is found.
std::vector<geodesic::GeodesicState> minimising_geodesics(const geodesic::Metric& metric, const Point2& p,
                                                          const CutGraph& graph, const Point2& target,
                                                          double tolerance);

}  // namespace dsc::cutlocus
