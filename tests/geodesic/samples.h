// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces and helpers that several tests of the geodesic module share.
#pragma once

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include "core/random.h"
#include "geodesic/metric.h"

namespace dsc::tests {

inline constexpr double pi = std::numbers::pi;
inline const geodesic::ChartPeriods torus_periods{2 * pi, 2 * pi};

/// The torus of revolution of the built-in class, as text.
inline std::string torus_embedding(double major_radius, double lambda) {
    std::ostringstream text;
    text << "x=(" << major_radius << "+cos(v))*cos(u); y=(" << major_radius << "+cos(v))*sin(u); z=" << lambda
         << "*sin(v)";
    return text.str();
}
inline std::string torus_tensor(double major_radius, double lambda) {
    std::ostringstream text;
    text << "E=(" << major_radius << "+cos(v))^2; F=0; G=sin(v)^2+" << lambda << "^2*cos(v)^2";
    return text.str();
}

/// Torus with a section of radius 1 + 0.15 cos(2u + v): no symmetry that would hide a wrong sign.
inline const std::string bumpy_embedding =
    "x=(2+(1+0.15*cos(2*u+v))*cos(v))*cos(u); y=(2+(1+0.15*cos(2*u+v))*cos(v))*sin(u); z=(1+0.15*cos(2*u+v))*sin(v)";
/// Not orthogonal, not conformal, positive definite.
inline const std::string skew_tensor =
    "E=2+0.3*cos(u-v)+0.2*sin(2*v); F=0.4*sin(u+0.5)*cos(v)+0.1; G=1.5+0.3*cos(u)*sin(v)+0.1*cos(2*u)";

inline geodesic::Point2 random_point(core::Random& random) { return {random.uniform(-4, 4), random.uniform(-4, 4)}; }

/// f'(0) by central differences of order 8: exact up to some 1e-11 of the size of f for functions of scale 1.
template <class Function>
auto derivative(const Function& f, double h = 0.02) {
    const auto difference = [&](int i) { return (f(i * h) - f(-i * h)).eval(); };
    return ((672 * difference(1) - 168 * difference(2) + 32 * difference(3) - 3 * difference(4)) / (840 * h)).eval();
}

/// E, F, G as a vector, for differences.
inline Eigen::Vector3d components(const geodesic::MetricTensor& g) { return {g.E, g.F, g.G}; }

/// The symbols Γ^u and Γ^v as one vector of six.
template <class Geometry>
Eigen::Matrix<double, 6, 1> christoffel_symbols(const Geometry& local) {
    Eigen::Matrix<double, 6, 1> symbols;
    symbols << local.christoffel_u[0], local.christoffel_u[1], local.christoffel_u[2], local.christoffel_v[0],
        local.christoffel_v[1], local.christoffel_v[2];
    return symbols;
}

inline geodesic::Point2 moved(const geodesic::Point2& x, int direction, double by) {
    geodesic::Point2 result = x;
    result[direction] += by;
    return result;
}

}  // namespace dsc::tests
