// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic/torus.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "core/errors.h"

namespace dsc::geodesic {

namespace {

std::string text(double value) {
    std::array<char, 32> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.12g", value);
    return buffer.data();
}

}  // namespace

TorusOfRevolution::TorusOfRevolution(double major_radius, double lambda)
    : Metric({2 * std::numbers::pi, 2 * std::numbers::pi}), major_radius_(major_radius), lambda_(lambda) {
    // The squares enter the metric: they must be ordinary numbers too.
    if (!(lambda > 0) || !std::isnormal(lambda * lambda))
        throw core::UsageError("--lambda must be a positive number, e.g. 2; it is " + text(lambda));
    if (!(std::abs(major_radius) > 1) || !std::isfinite(major_radius * major_radius))
        throw core::UsageError("--major-radius must exceed 1, e.g. 2; it is " + text(major_radius) +
                               ": the surface would meet its axis, where R + cos v = 0 and the metric degenerates");
}

MetricTensor TorusOfRevolution::tensor(const Point2& x) const {
    const double s = std::sin(x.y()), c = std::cos(x.y()), radius = major_radius_ + c;
    return {radius * radius, 0, s * s + lambda_ * lambda_ * c * c};
}

LocalGeometry TorusOfRevolution::local_geometry(const Point2& x) const {
    const double s = std::sin(x.y()), c = std::cos(x.y());
    const double radius = major_radius_ + c, lambda2 = lambda_ * lambda_;
    const double G = s * s + lambda2 * c * c, G_v = 2 * (1 - lambda2) * s * c;
    const double inverse_radius = 1 / radius, inverse_G = 1 / G;
    LocalGeometry local;
    local.tensor = {radius * radius, 0, G};
    local.christoffel_u = {0, -s * inverse_radius, 0};
    local.christoffel_v = {radius * s * inverse_G, 0, G_v * inverse_G / 2};
    local.curvature = lambda2 * c * inverse_radius * inverse_G * inverse_G;
    local.curvature_gradient = {
        0, lambda2 * inverse_G * inverse_G * inverse_radius * (-s + c * (s * inverse_radius - 2 * G_v * inverse_G))};
    return local;
}

ConnectionJet TorusOfRevolution::connection_jet(const Point2& x) const {
    const double s = std::sin(x.y()), c = std::cos(x.y());
    const double radius = major_radius_ + c, lambda2 = lambda_ * lambda_;
    const double G = s * s + lambda2 * c * c, G_v = 2 * (1 - lambda2) * s * c,
                 G_vv = 2 * (1 - lambda2) * (c * c - s * s);
    ConnectionJet jet;
    jet.tensor = {radius * radius, 0, G};
    jet.christoffel_u = {0, -s / radius, 0};
    jet.christoffel_v = {radius * s / G, 0, G_v / (2 * G)};
    const Vector2 zero(0, 0);
    jet.christoffel_u_gradient = {zero, {0, -(c * radius + s * s) / (radius * radius)}, zero};
    jet.christoffel_v_gradient = {Vector2(0, (radius * c - s * s) / G - radius * s * G_v / (G * G)), zero,
                                  Vector2(0, (G_vv * G - G_v * G_v) / (2 * G * G))};
    return jet;
}

std::optional<Point3> TorusOfRevolution::position(const Point2& x) const {
    const double radius = major_radius_ + std::cos(x.y());
    return Point3{radius * std::cos(x.x()), radius * std::sin(x.x()), lambda_ * std::sin(x.y())};
}

}  // namespace dsc::geodesic
