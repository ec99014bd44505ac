// SPDX-License-Identifier: GPL-3.0-or-later
// The flow of a velocity field by one Runge-Kutta step of order 1 to 4: Euler, midpoint, Kutta's third order, and the
// classical method. Source: Hairer, Nørsett, Wanner (1993), "Solving Ordinary Differential Equations I", II.1.
// Guarantee: errors are of the order of the step plus one; a velocity that is the same everywhere and at any time gives
// start + dt * velocity without any other rounding. Cost: as many velocities as the order says.
#pragma once

#include <string>
#include <utility>

#include "core/errors.h"
#include "motion/velocity.h"

namespace dsc::motion {

/// Precondition: 1 <= order <= 4. Stages are taken as differences to the first one, so that constants stay exact.
template <int Dimension>
Vector<Dimension> runge_kutta_step(const VelocityField<Dimension>& velocity, int order, const Vector<Dimension>& x,
                                   double t, double h) {
    using V = Vector<Dimension>;
    const V k1 = velocity(x, t);
    if (order == 1) return x + h * k1;
    const V k2 = velocity(x + h / 2 * k1, t + h / 2);
    if (order == 2) return x + h * k2;
    if (order == 3) {
        const V k3 = velocity(x + h * (k1 + 2 * (k2 - k1)), t + h);
        return x + h * (k1 + (4 * (k2 - k1) + (k3 - k1)) / 6);
    }
    const V k3 = velocity(x + h / 2 * k2, t + h / 2);
    const V k4 = velocity(x + h * k3, t + h);
    return x + h * (k1 + (2 * (k2 - k1) + 2 * (k3 - k1) + (k4 - k1)) / 6);
}

template <int Dimension>
class RungeKuttaFlow final : public FlowMap<Dimension> {
public:
    /// Throws core::UsageError unless 1 <= order <= 4.
    explicit RungeKuttaFlow(VelocityField<Dimension> velocity, int order = 4)
        : velocity_(std::move(velocity)), order_(order) {
        if (order < 1 || order > 4) throw core::UsageError("order: has to be 1, 2, 3 or 4");
    }

    /// One step from t0 to t.
    Vector<Dimension> at(const Vector<Dimension>& start, double t0, double t) const override {
        return runge_kutta_step<Dimension>(velocity_, order_, start, t0, t - t0);
    }

private:
    VelocityField<Dimension> velocity_;
    int order_;
};

}  // namespace dsc::motion
