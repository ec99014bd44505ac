// SPDX-License-Identifier: GPL-3.0-or-later
// Distance circles: the level sets of the distance from p, which end on the cut locus; and the circles of all geodesics
// of one length, cut locus or not (thesis Fig. 5.1).
//
// Guarantee: a circle ends where it meets an arc, to within the chord of two samples.
// Cost: O(rays + samples) per circle.
#pragma once

#include <span>
#include <vector>

#include "apps/cutlocus/picture/geodesic_fan.h"

namespace dsc::cutlocus {

/// The level set of `radius` as lines of the universal cover; `fan` ends on the cut locus.
std::vector<Polyline> distance_circle(std::span<const FanRay> fan, const CutGraph& graph,
                                      const geodesic::ChartPeriods& periods, double radius);

/// The ends of all geodesics of length `radius`, a closed line; every ray of `fan` is at least as long.
Polyline geodesic_circle(std::span<const FanRay> fan, double radius);

/// The first conjugate points along the rays, as lines that are interrupted where a ray is too short to have one.
std::vector<Polyline> conjugate_locus(std::span<const FanRay> fan);

/// About `count` radii up to `largest`, the multiples of a round number.
std::vector<double> round_radii(double largest, int count);

}  // namespace dsc::cutlocus
