// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic/two_point.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"

namespace dsc::geodesic {

namespace {

// A Newton correction beyond this part of the polyline's extent in the chart is not trusted: the polyline is too rough
// for the linearization, whose Γ terms then make the matrix nearly singular.
constexpr double largest_correction = 0.5;

double largest_component(const Vector2& a) { return a.cwiseAbs().maxCoeff(); }

double extent(std::span<const Point2> nodes) {
    double largest = 0;
    for (const Point2& node : nodes) largest = std::max(largest, largest_component(node - nodes.front()));
    return largest;
}

/// The inverse by the formula for 2 x 2 (Eigen's, without its test of the size).
Eigen::Matrix2d inverse(const Eigen::Matrix2d& m) {
    const double determinant = m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
    Eigen::Matrix2d result;
    result << m(1, 1), -m(0, 1), -m(1, 0), m(0, 0);
    return result / determinant;
}

/// The symmetric bilinear form Γ(a, b) of one component: (Γ_uu, Γ_uv, Γ_vv).
double form(const std::array<double, 3>& symbols, const Vector2& a, const Vector2& b) {
    return symbols[0] * a.x() * b.x() + symbols[1] * (a.x() * b.y() + a.y() * b.x()) + symbols[2] * a.y() * b.y();
}

/// The covector Γ(·, a) of one component.
Vector2 contraction(const std::array<double, 3>& symbols, const Vector2& a) {
    return {symbols[0] * a.x() + symbols[1] * a.y(), symbols[1] * a.x() + symbols[2] * a.y()};
}

/// The gradient of Γ(a, a) of one component for a fixed a.
Vector2 form_gradient(const std::array<Vector2, 3>& gradient, const Vector2& a) {
    return gradient[0] * (a.x() * a.x()) + gradient[1] * (2 * a.x() * a.y()) + gradient[2] * (a.y() * a.y());
}

/// The tangent of unit length at x0 of a curve through x0, x1, x2 (equal steps of its parameter, in either sense): the
/// 3-point formula. Zero if the points coincide.
Vector2 unit_tangent(const Metric& metric, const Point2& x0, const Point2& x1, const Point2& x2) {
    const Vector2 tangent = 4 * (x1 - x0) - (x2 - x0);
    const double norm = metric.tensor(x0).norm(tangent);
    return norm > 0 ? Vector2(tangent / norm) : Vector2(0, 0);
}

}  // namespace

TwoPointSolver::TwoPointSolver(const Metric& metric, const TwoPointParameters& parameters)
    : metric_(metric), parameters_(parameters) {
    DSC_ASSERT(parameters.tolerance > 0 && parameters.max_iterations >= 1);
    corrections_.reserve(static_cast<std::size_t>(parameters.max_iterations));
}

/// Fills the rows of (5.6) at `nodes`.
void TwoPointSolver::assemble(std::span<const Point2> nodes) {
    for (std::size_t p = 1; p + 1 < nodes.size(); ++p) {
        const ConnectionJet jet = metric_.connection_jet(nodes[p]);
        const Vector2 before = nodes[p] - nodes[p - 1], after = nodes[p + 1] - nodes[p], chord = before + after;
        BlockRow& row = rows_[p - 1];
        // The difference of the differences, not x⁺ - 2x + x⁻: its rounding error is that of a segment.
        row.residual = (after - before) / 2 +
                       Vector2{form(jet.christoffel_u, chord, chord), form(jet.christoffel_v, chord, chord)} / 8;
        Eigen::Matrix2d slope;
        slope << contraction(jet.christoffel_u, chord).transpose() / 4,
            contraction(jet.christoffel_v, chord).transpose() / 4;
        row.lower = Eigen::Matrix2d::Identity() / 2 - slope;
        row.upper = Eigen::Matrix2d::Identity() / 2 + slope;
        row.diagonal << form_gradient(jet.christoffel_u_gradient, chord).transpose() / 8,
            form_gradient(jet.christoffel_v_gradient, chord).transpose() / 8;
        row.diagonal -= Eigen::Matrix2d::Identity();
    }
}

/// Block elimination (Thomas' algorithm): forwards, then backwards. Fills correction_, returns its largest component.
double TwoPointSolver::eliminate() {
    const std::size_t count = rows_.size();
    Eigen::Matrix2d ratio = Eigen::Matrix2d::Zero();  // δ_(p-1) = correction_(p-1) - ratio δ_p
    Vector2 previous{0, 0};
    for (std::size_t p = 0; p < count; ++p) {
        BlockRow& row = rows_[p];
        const Eigen::Matrix2d pivot = inverse(row.diagonal - row.lower * ratio);
        correction_[p] = previous = pivot * (-row.residual - row.lower * previous);
        row.upper = ratio = pivot * row.upper;
    }
    double largest = largest_component(correction_[count - 1]);
    for (std::size_t p = count - 1; p-- > 0;) {
        correction_[p] -= rows_[p].upper * correction_[p + 1];
        largest = std::max(largest_component(correction_[p]), largest);  // a NaN goes on to the first node, and stays
    }
    return largest;
}

/// Drops the derivatives of the Γ term from the rows, whose residuals stay: the correction then solves the linear part
/// of (5.4) with the Γ term held, the thesis' fixed-point iteration taken to its end, which smooths the polyline.
void TwoPointSolver::hold_symbols() {
    for (BlockRow& row : rows_) {
        row.lower = row.upper = Eigen::Matrix2d::Identity() / 2;
        row.diagonal = -Eigen::Matrix2d::Identity();
    }
}

TwoPointReport TwoPointSolver::solve(std::span<Point2> nodes) {
    DSC_ASSERT(nodes.size() >= 2);
    TwoPointReport report;
    rows_.resize(nodes.size() - 2);
    correction_.resize(nodes.size() - 2);
    corrections_.clear();
    report.is_converged = rows_.empty();
    while (!report.is_converged && report.iterations < parameters_.max_iterations) {
        assemble(nodes);
        double size = eliminate();
        if (!(size <= largest_correction * extent(nodes))) {
            hold_symbols();
            size = eliminate();
        }
        if (!std::isfinite(size)) break;
        for (std::size_t p = 0; p < correction_.size(); ++p) nodes[p + 1] += correction_[p];
        ++report.iterations;
        corrections_.push_back(size);
        report.is_converged = size <= parameters_.tolerance;
    }
    report.length = length(metric_, nodes);
    // A single segment is its own tangent: the third point is put straight on.
    const std::size_t last = nodes.size() - 1;
    const Point2 third = last > 1 ? nodes[2] : Point2(2 * nodes[1] - nodes[0]);
    const Point2 third_last = last > 1 ? nodes[last - 2] : Point2(2 * nodes[0] - nodes[1]);
    report.initial_direction = unit_tangent(metric_, nodes[0], nodes[1], third);
    report.final_direction = -unit_tangent(metric_, nodes[last], nodes[last - 1], third_last);
    return report;
}

std::vector<Point2> straight_polyline(const Point2& from, const Point2& to, int segments) {
    DSC_ASSERT(segments >= 1);
    std::vector<Point2> nodes;
    nodes.reserve(static_cast<std::size_t>(segments) + 1);
    for (int i = 0; i <= segments; ++i) {
        const double s = static_cast<double>(i) / segments;
        nodes.push_back((1 - s) * from + s * to);
    }
    return nodes;
}

double length(const Metric& metric, std::span<const Point2> nodes) {
    double sum = 0;
    for (std::size_t p = 0; p + 1 < nodes.size(); ++p)
        sum += metric.tensor((nodes[p] + nodes[p + 1]) / 2).norm(nodes[p + 1] - nodes[p]);
    return sum;
}

}  // namespace dsc::geodesic
