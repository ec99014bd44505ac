// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic/geodesic_flow.h"

#include <array>
#include <cmath>
#include <string>

#include "core/assert.h"
#include "core/errors.h"
#include "geodesic/dormand_prince.h"

namespace dsc::geodesic {

namespace {

constexpr int dimension = 10;
using Components = DormandPrince853<dimension>::State;

Components components_of(const GeodesicState& s) {
    Components y;
    y << s.x, s.velocity, s.j, s.j_t, s.area, s.j_theta, s.j_theta_t, s.area_theta;
    return y;
}

void assign(GeodesicState& s, const Components& y) {
    s.x = y.segment<2>(0);
    s.velocity = y.segment<2>(2);
    s.j = y[4], s.j_t = y[5], s.area = y[6], s.j_theta = y[7], s.j_theta_t = y[8], s.area_theta = y[9];
}

Components derivative(const Metric& metric, const Components& y) {
    const LocalGeometry local = metric.local_geometry({y[0], y[1]});
    const double a = y[2], b = y[3], j = y[4];
    // Derivative of the Jacobi equation in theta: K changes across the geodesic, where neighbours are j apart.
    const double curvature_slope = local.curvature_gradient.dot(local.tensor.rotated({a, b}));
    Components slope;
    slope << a, b,
        -(local.christoffel_u[0] * a * a + 2 * local.christoffel_u[1] * a * b + local.christoffel_u[2] * b * b),
        -(local.christoffel_v[0] * a * a + 2 * local.christoffel_v[1] * a * b + local.christoffel_v[2] * b * b), y[5],
        -local.curvature * j, j, y[8], -local.curvature * y[7] - curvature_slope * j * j, y[7];
    return slope;
}

}  // namespace

class GeodesicFlow::Integrator {
public:
    Integrator(const Metric& surface, const Point2& start, double tolerance)
        : metric(&surface), origin(start), frame(surface.tensor(start)), method_(tolerance) {}

    void integrate(Components& y, double distance) {
        double step = std::min(distance, step_);
        const auto right_hand_side = [this](const Components& at) {
            ++evaluations;
            return derivative(*metric, at);
        };
        if (!method_.integrate(right_hand_side, y, distance, step))
            throw core::RunError("the metric is not regular near (u, v) = (" + std::to_string(y[0]) + ", " +
                                 std::to_string(y[1]) + "): the geodesic can't be continued");
    }

    const Metric* metric;
    Point2 origin;
    Frame frame;
    long evaluations = 0;

private:
    // A guess that the control corrects within a step or two; always the same, so that a shot does not depend on the
    // ones before it.
    static constexpr double step_ = 0.25;
    DormandPrince853<dimension> method_;
};

GeodesicFlow::GeodesicFlow(const Metric& metric, const Point2& origin, double tolerance)
    : integrator_(std::make_unique<Integrator>(metric, origin, tolerance)) {}
GeodesicFlow::~GeodesicFlow() = default;
GeodesicFlow::GeodesicFlow(GeodesicFlow&&) noexcept = default;

const Metric& GeodesicFlow::metric() const { return *integrator_->metric; }
const Point2& GeodesicFlow::origin() const { return integrator_->origin; }
long GeodesicFlow::evaluations() const { return integrator_->evaluations; }

GeodesicState GeodesicFlow::start(double theta) const {
    GeodesicState state;
    state.theta = theta;
    state.x = integrator_->origin;
    state.velocity = integrator_->frame.direction(theta);
    state.j_t = 1;
    return state;
}

void GeodesicFlow::advance(GeodesicState& state, double distance) {
    DSC_ASSERT(distance >= 0);
    if (distance <= 0) return;
    Components y = components_of(state);
    integrator_->integrate(y, distance);
    assign(state, y);
    state.t += distance;
}

GeodesicState GeodesicFlow::shoot(double theta, double t) {
    GeodesicState state = start(theta);
    advance(state, t);
    return state;
}

GeodesicState nearby(const Metric& metric, const GeodesicState& state, double theta_step, double t_step) {
    GeodesicState moved = state;
    moved.theta += theta_step;
    moved.t += t_step;
    moved.x += theta_step * jacobi_field(metric, state) + t_step * state.velocity;
    moved.j += theta_step * state.j_theta + t_step * state.j_t;
    moved.area += theta_step * state.area_theta + t_step * state.j;
    return moved;
}

Vector2 jacobi_field(const Metric& metric, const GeodesicState& state) {
    return state.j * metric.tensor(state.x).rotated(state.velocity);
}

}  // namespace dsc::geodesic
