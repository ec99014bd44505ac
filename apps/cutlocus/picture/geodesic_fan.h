// SPDX-License-Identifier: GPL-3.0-or-later
// A fan of geodesics from p, up to their cut distances (or to a given length): evenly spaced on the circle of
// directions, and finer where the Jacobi field spreads them.
//
// Guarantee: neighbours lie no further apart on the surface than asked for, as long as the number of rays allows it.
// Cost: one integration per ray, with a stop at every step.
#pragma once

#include <optional>
#include <vector>

#include "apps/cutlocus/picture/cut_distance.h"
#include "apps/cutlocus/picture/polyline.h"
#include "geodesic/geodesic_flow.h"

namespace dsc::cutlocus {

struct FanParameters {
    int directions = 360;      ///< evenly spaced at the start; >= 3
    double step = 0.1;         ///< between the states of a ray, on the surface; > 0
    double largest_gap = 0.1;  ///< between neighbours, on the surface; > 0
    int max_rays = 6000;
    std::optional<double> length;  ///< of every ray; without it, up to the cut locus
    double tolerance = 1e-9;       ///< local error of the integration
};

struct FanRay {
    double theta = 0;  ///< in [0, 2π)
    double length = 0;
    bool ends_on_locus = true;  ///< false: followed no further than asked for
    double apart_at = 0;        ///< its neighbours were too far apart from this length on; 0 for the evenly spaced rays
    double step = 0;
    std::vector<geodesic::GeodesicState> states;  ///< at the multiples of step, and at the end

    /// The place at distance t in [0, length], in the universal cover: Hermite interpolation between the states.
    geodesic::Point2 point(double t) const;
    /// Places from `begin` to `end` at most `spacing` apart, both ends included.
    Polyline line(double begin, double end, double spacing) const;
};

/// The rays in the order of their directions.
std::vector<FanRay> geodesic_fan(const geodesic::Metric& metric, const geodesic::Point2& p, const CutDistance& cut,
                                 const FanParameters& parameters);

}  // namespace dsc::cutlocus
