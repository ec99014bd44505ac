// SPDX-License-Identifier: GPL-3.0-or-later
// The inverse exponential map by shooting: the geodesic from the origin of a flow to a point, near a known geodesic.
#pragma once

#include <optional>

#include "geodesic/geodesic_flow.h"

namespace dsc::geodesic {

struct ConnectParameters {
    double tolerance = 1e-12;   ///< largest last Newton step, a length on the surface
    int max_iterations = 20;    ///< Newton steps before giving up
    double largest_step = 0.5;  ///< a Newton step is shortened to this length on the surface
};

/// Newton's method on E(theta, t) = `target` (a point of the universal cover) from (`theta`, `t`).
/// Empty when it does not converge, or runs into a conjugate point (j = 0) or t <= 0.
std::optional<GeodesicState> connect(GeodesicFlow& flow, const Point2& target, double theta, double t,
                                     const ConnectParameters& parameters = {});

}  // namespace dsc::geodesic
