// SPDX-License-Identifier: GPL-3.0-or-later
// Initial-value geodesics from one point, with their Jacobi field: the exponential map E(theta, t) and its derivatives.
// Thesis 5.2.3, equation (5.3); the Jacobi equation replaces the stored polyline of each front vertex by a state.
//
//   GeodesicFlow flow(torus, {0, 0});
//   GeodesicState s = flow.shoot(0.3, 5.0);      // s.x, s.velocity, s.j, ...
//   flow.advance(s, 0.1);                        // on to t = 5.1
//
// Guarantee: local error of each component below the tolerance per step (Dormand-Prince 8(5,3)).
// Cost: 12 evaluations of the metric per step; no allocation. Not thread-safe: one flow per thread.
#pragma once

#include <memory>

#include "geodesic/metric.h"

namespace dsc::geodesic {

/// A geodesic of unit speed at distance t from its origin.
struct GeodesicState {
    double theta = 0;        ///< start direction, an angle in Frame(tensor(origin))
    double t = 0;            ///< distance travelled
    Point2 x{0, 0};          ///< position in the universal cover of the chart
    Vector2 velocity{0, 0};  ///< dx/dt, of metric length 1
    double j = 0;            ///< length of the Jacobi field ∂E/∂theta, signed: j'' + K j = 0, j(0) = 0, j'(0) = 1
    double j_t = 0;          ///< dj/dt
    double area = 0;         ///< ∫₀ᵗ j dt: area of the sector per unit of theta
    double j_theta = 0;      ///< ∂j/∂theta
    double j_theta_t = 0;    ///< ∂²j/∂theta∂t
    double area_theta = 0;   ///< ∂area/∂theta
};

class GeodesicFlow {
public:
    /// `metric` must outlive the flow. `tolerance` bounds the local error of each step.
    GeodesicFlow(const Metric& metric, const Point2& origin, double tolerance = 1e-13);
    ~GeodesicFlow();
    GeodesicFlow(GeodesicFlow&&) noexcept;

    const Metric& metric() const;
    const Point2& origin() const;

    /// The state at distance 0 in direction `theta`.
    GeodesicState start(double theta) const;
    /// Moves `state` along its geodesic by `distance` >= 0.
    /// Throws core::RunError where the metric is not finite or not positive definite.
    void advance(GeodesicState& state, double distance);
    /// The state at distance t >= 0 in direction `theta`.
    GeodesicState shoot(double theta, double t);

    /// Number of evaluations of the metric so far.
    long evaluations() const;

private:
    class Integrator;
    std::unique_ptr<Integrator> integrator_;
};

/// `state` moved by small steps in theta and t, to first order in position, j and area; the velocity stays as it is.
GeodesicState nearby(const Metric& metric, const GeodesicState& state, double theta_step, double t_step);

/// ∂E/∂theta at `state`: the Jacobi field, a vector of metric length |j| across the geodesic.
Vector2 jacobi_field(const Metric& metric, const GeodesicState& state);

}  // namespace dsc::geodesic
