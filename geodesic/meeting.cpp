// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic/meeting.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "core/assert.h"

namespace dsc::geodesic {

double Meeting::speed() const { return std::hypot(t_w, first.j * (middle_w + 1)); }

std::optional<Meeting> meet(GeodesicFlow& flow, double w, const LatticeVector& lattice, double middle, double t,
                            const MeetingParameters& parameters) {
    DSC_ASSERT(w != 0);
    const Metric& metric = flow.metric();
    const Vector2 translation = metric.periods().translation(lattice);
    for (int iteration = 0; iteration < parameters.max_iterations; ++iteration) {
        Meeting meeting{w, middle, t, lattice, flow.shoot(middle + w, t), flow.shoot(middle - w, t)};
        const Vector2 field1 = jacobi_field(metric, meeting.first), field2 = jacobi_field(metric, meeting.second);
        Eigen::Matrix2d jacobian;  // of first.x - second.x in (middle, t)
        jacobian << field1 - field2, meeting.first.velocity - meeting.second.velocity;
        const double determinant = jacobian.determinant();
        if (determinant == 0 || !std::isfinite(determinant)) return std::nullopt;
        Eigen::Matrix2d adjugate;
        adjugate << jacobian(1, 1), -jacobian(0, 1), -jacobian(1, 0), jacobian(0, 0);
        const Vector2 miss = translation - (meeting.first.x - meeting.second.x);
        const Vector2 correction = adjugate * miss / determinant;
        const double step =
            std::hypot(std::max(std::abs(meeting.first.j), std::abs(meeting.second.j)) * correction[0], correction[1]);
        if (!std::isfinite(step)) return std::nullopt;
        if (step <= parameters.linear_step) {
            const Vector2 slope = -(adjugate * (field1 + field2)) / determinant;
            meeting.middle_w = slope[0], meeting.t_w = slope[1];
            meeting.sensitivity = adjugate.row(0).norm() / std::abs(determinant);
            meeting.middle += correction[0], meeting.t += correction[1];
            meeting.first = nearby(metric, meeting.first, correction[0], correction[1]);
            meeting.second = nearby(metric, meeting.second, correction[0], correction[1]);
            return meeting;
        }
        const double shortened = std::min(1.0, parameters.largest_step * t / step);
        middle += shortened * correction[0];
        t += shortened * correction[1];
        if (!(t > 0)) return std::nullopt;
    }
    return std::nullopt;
}

std::optional<Meeting> nearest_meeting(GeodesicFlow& flow, double theta1, double theta2, double t,
                                       const LatticeVector& lattice, const MeetingParameters& parameters) {
    constexpr double near_enough = 1e-3;     // of t: meet() does the rest
    constexpr double smallest_angle = 0.05;  // between the geodesics, for a correction without bound
    const Metric& metric = flow.metric();
    const Vector2 translation = metric.periods().translation(lattice);
    for (int iteration = 0; iteration < parameters.max_iterations; ++iteration) {
        const GeodesicState first = flow.shoot(theta1, t), second = flow.shoot(theta2, t);
        if (!(first.j > 0) || !(second.j > 0)) break;
        // Lengths across both geodesics and along them, in the orthonormal frame of the first one.
        const MetricTensor tensor = metric.tensor(first.x);
        const Vector2 normal = tensor.rotated(first.velocity);
        const auto in_frame = [&](const Vector2& a) {
            return Vector2(tensor.inner(a, first.velocity), tensor.inner(a, normal));
        };
        Eigen::Matrix<double, 2, 3> effect;
        effect << Vector2(0, 1), -in_frame(tensor.rotated(second.velocity)), Vector2(1, 0) - in_frame(second.velocity);
        const Eigen::Matrix2d gram = effect * effect.transpose();
        if (gram.determinant() < smallest_angle * smallest_angle) break;
        const Vector2 miss = in_frame(translation - (first.x - second.x));
        const Eigen::Vector3d correction = effect.transpose() * (gram.inverse() * miss);
        const double step = correction.norm();
        if (!std::isfinite(step)) return std::nullopt;
        const double shortened = std::min(1.0, parameters.largest_step * t / step);
        theta1 += shortened * correction[0] / first.j;
        theta2 += shortened * correction[1] / second.j;
        t += shortened * correction[2];
        if (!(t > 0)) return std::nullopt;
        if (step <= near_enough * t) break;
    }
    if (theta1 == theta2) return std::nullopt;
    return meet(flow, (theta1 - theta2) / 2, lattice, (theta1 + theta2) / 2, t, parameters);
}

namespace {

/// Ends of all arrivals at length t, brought to that of the first one.
struct Ends {
    std::vector<GeodesicState> states;
    Eigen::VectorXd miss;

    Ends(GeodesicFlow& flow, std::span<const Arrival> arrivals, const Eigen::VectorXd& unknowns) {
        const auto count = static_cast<Eigen::Index>(arrivals.size());
        const ChartPeriods& periods = flow.metric().periods();
        for (Eigen::Index i = 0; i < count; ++i) states.push_back(flow.shoot(unknowns[i], unknowns[count]));
        miss.resize(2 * (count - 1));
        for (Eigen::Index i = 1; i < count; ++i)
            miss.segment<2>(2 * (i - 1)) = states[i].x - periods.translation(arrivals[i].lattice) - states[0].x;
    }

    Eigen::MatrixXd jacobian(const Metric& metric) const {
        const auto count = static_cast<Eigen::Index>(states.size());
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(2 * (count - 1), count + 1);
        for (Eigen::Index i = 1; i < count; ++i) {
            matrix.block<2, 1>(2 * (i - 1), 0) = -jacobi_field(metric, states[0]);
            matrix.block<2, 1>(2 * (i - 1), i) = jacobi_field(metric, states[i]);
            matrix.block<2, 1>(2 * (i - 1), count) = states[i].velocity - states[0].velocity;
        }
        return matrix;
    }

    double residual(const Metric& metric) const {
        const MetricTensor tensor = metric.tensor(states[0].x);
        double largest = 0;
        for (Eigen::Index i = 0; i < miss.size(); i += 2) largest = std::max(largest, tensor.norm(miss.segment<2>(i)));
        return largest;
    }
};

}  // namespace

std::optional<BranchPoint> branch_point(GeodesicFlow& flow, std::span<const Arrival> arrivals, double t,
                                        const MeetingParameters& parameters) {
    DSC_ASSERT(arrivals.size() >= 3);
    const auto count = static_cast<Eigen::Index>(arrivals.size());
    Eigen::VectorXd unknowns(count + 1);
    for (Eigen::Index i = 0; i < count; ++i) unknowns[i] = arrivals[i].theta;
    unknowns[count] = t;
    for (int iteration = 0; iteration < parameters.max_iterations; ++iteration) {
        Ends ends(flow, arrivals, unknowns);
        const Eigen::VectorXd correction = -ends.jacobian(flow.metric()).colPivHouseholderQr().solve(ends.miss);
        double step = std::abs(correction[count]);
        for (Eigen::Index i = 0; i < count; ++i) step = std::max(step, std::abs(correction[i] * ends.states[i].j));
        if (!std::isfinite(step)) return std::nullopt;
        if (step <= parameters.tolerance) {
            const double residual = ends.residual(flow.metric());
            return BranchPoint{std::move(ends.states), unknowns[count], residual};
        }
        unknowns += std::min(1.0, parameters.largest_step * unknowns[count] / step) * correction;
        if (!(unknowns[count] > 0)) return std::nullopt;
    }
    return std::nullopt;
}

std::optional<GeodesicState> conjugate_end(GeodesicFlow& flow, double theta, double t,
                                           const MeetingParameters& parameters) {
    constexpr double difference = 1e-4;  // of theta, for ∂²j/∂theta²: balances round-off against the cubic term
    for (int iteration = 0; iteration < parameters.max_iterations; ++iteration) {
        GeodesicState state = flow.shoot(theta, t);
        const double j_theta_theta =
            (flow.shoot(theta + difference, t).j_theta - flow.shoot(theta - difference, t).j_theta) / (2 * difference);
        Eigen::Matrix2d jacobian;  // of (j, ∂j/∂theta) in (theta, t)
        jacobian << state.j_theta, state.j_t, j_theta_theta, state.j_theta_t;
        const Vector2 correction = -jacobian.colPivHouseholderQr().solve(Vector2(state.j, state.j_theta));
        // At the solution j = ∂j/∂theta = 0: the position depends on theta in third order only.
        constexpr double theta_weight = 1e-4;
        const double step = std::max(std::abs(correction[1]), theta_weight * std::abs(correction[0]));
        if (!std::isfinite(step)) return std::nullopt;
        if (step <= parameters.tolerance) return state;
        const double shortened =
            std::min(1.0, parameters.largest_step / std::max(std::abs(correction[0]), std::abs(correction[1]) / t));
        theta += shortened * correction[0];
        t += shortened * correction[1];
        if (!(t > 0)) return std::nullopt;
    }
    return std::nullopt;
}

}  // namespace dsc::geodesic
