// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic/connect.h"

#include <algorithm>
#include <cmath>

namespace dsc::geodesic {

std::optional<GeodesicState> connect(GeodesicFlow& flow, const Point2& target, double theta, double t,
                                     const ConnectParameters& parameters) {
    for (int iteration = 0; iteration < parameters.max_iterations; ++iteration) {
        if (!(t > 0)) return std::nullopt;
        GeodesicState state = flow.shoot(theta, t);
        const MetricTensor tensor = flow.metric().tensor(state.x);
        const Vector2 miss = target - state.x;
        // (velocity, normal) is an orthonormal basis, and ∂E/∂t = velocity, ∂E/∂theta = j normal.
        const double along = tensor.inner(miss, state.velocity);
        const double across = tensor.inner(miss, tensor.rotated(state.velocity));
        const double step = std::hypot(along, across);
        if (!std::isfinite(step)) return std::nullopt;
        if (step <= parameters.tolerance) return state;
        if (state.j == 0) return std::nullopt;
        const double shortened = std::min(1.0, parameters.largest_step / step);
        theta += shortened * across / state.j;
        t += shortened * along;
    }
    return std::nullopt;
}

}  // namespace dsc::geodesic
