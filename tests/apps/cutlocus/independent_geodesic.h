// SPDX-License-Identifier: GPL-3.0-or-later
// Geodesics by an integrator that shares nothing with the library's own but the metric: GSL's Prince-Dormand method of
// order 8 on the geodesic equation alone.
#pragma once

#include <gsl/gsl_odeiv2.h>

#include <stdexcept>

#include "geodesic/metric.h"

namespace dsc::tests {

class IndependentGeodesic {
public:
    struct State {
        geodesic::Point2 x;
        geodesic::Vector2 velocity;
    };

    IndependentGeodesic(const geodesic::Metric& metric, const geodesic::Point2& origin, double tolerance = 1e-13)
        : metric_(metric),
          origin_(origin),
          system_{&right_hand_side, nullptr, 4, const_cast<geodesic::Metric*>(&metric)},
          driver_(gsl_odeiv2_driver_alloc_y_new(&system_, gsl_odeiv2_step_rk8pd, 1e-2, tolerance, tolerance)) {}
    ~IndependentGeodesic() { gsl_odeiv2_driver_free(driver_); }
    IndependentGeodesic(const IndependentGeodesic&) = delete;
    IndependentGeodesic& operator=(const IndependentGeodesic&) = delete;

    /// At p, in the direction theta from ∂u towards ∂v in the orthonormal frame.
    State start(double theta) const {
        const geodesic::MetricTensor g = metric_.tensor(origin_);
        const geodesic::Vector2 e1(1 / std::sqrt(g.E), 0);
        geodesic::Vector2 e2(-g.F / g.E, 1);  // Gram-Schmidt
        e2 /= std::sqrt(g.G - g.F * g.F / g.E);
        return {origin_, std::cos(theta) * e1 + std::sin(theta) * e2};
    }
    void advance(State& state, double distance) {
        double t = 0, y[4] = {state.x.x(), state.x.y(), state.velocity.x(), state.velocity.y()};
        gsl_odeiv2_driver_reset(driver_);
        if (gsl_odeiv2_driver_apply(driver_, &t, distance, y) != 0) throw std::runtime_error("GSL gave up");
        state = {{y[0], y[1]}, {y[2], y[3]}};
    }
    geodesic::Point2 end(double theta, double distance) {
        State state = start(theta);
        advance(state, distance);
        return state.x;
    }

private:
    static int right_hand_side(double, const double y[], double dydt[], void* parameters) {
        const auto& metric = *static_cast<const geodesic::Metric*>(parameters);
        const geodesic::LocalGeometry local = metric.local_geometry({y[0], y[1]});
        const auto acceleration = [&](const std::array<double, 3>& symbols) {
            return -(symbols[0] * y[2] * y[2] + 2 * symbols[1] * y[2] * y[3] + symbols[2] * y[3] * y[3]);
        };
        dydt[0] = y[2];
        dydt[1] = y[3];
        dydt[2] = acceleration(local.christoffel_u);
        dydt[3] = acceleration(local.christoffel_v);
        return 0;
    }

    const geodesic::Metric& metric_;
    geodesic::Point2 origin_;
    gsl_odeiv2_system system_;
    gsl_odeiv2_driver* driver_;
};

}  // namespace dsc::tests
