// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic/geodesic_flow.h"

#include <gsl/gsl_integration.h>
#include <gsl/gsl_sf_ellint.h>

#include <functional>
#include <memory>
#include <vector>

#include "core/errors.h"
#include "geodesic/expression_metric.h"
#include "geodesic/torus.h"
#include "tests/geodesic/samples.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::geodesic;
using namespace dsc::tests;

namespace {

double quadrature(const std::function<double(double)>& f, double a, double b) {
    gsl_integration_workspace* workspace = gsl_integration_workspace_alloc(1000);
    gsl_function function{[](double x, void* p) { return (*static_cast<const std::function<double(double)>*>(p))(x); },
                          const_cast<std::function<double(double)>*>(&f)};
    double result = 0, error = 0;
    gsl_integration_qag(&function, a, b, 1e-13, 1e-13, 1000, GSL_INTEG_GAUSS61, workspace, &result, &error);
    gsl_integration_workspace_free(workspace);
    return result;
}

/// A geodesic of the torus of revolution that climbs from v = 0 for ever, by Clairaut's first integral
/// (R + cos v)² u' = c < R - 1.
struct ClairautGeodesic {
    double radius, lambda, c;

    double theta() const { return std::acos(c / (radius + 1)); }
    double rho(double v) const { return radius + std::cos(v); }
    /// dt/dv.
    double pace(double v) const {
        const double g = std::sin(v) * std::sin(v) + lambda * lambda * std::cos(v) * std::cos(v);
        return std::sqrt(g / (1 - c * c / (rho(v) * rho(v))));
    }
    double length_by_quadrature(double v) const {
        return quadrature([this](double w) { return pace(w); }, 0, v);
    }
    double u_by_quadrature(double v) const {
        return quadrature([this](double w) { return c * pace(w) / (rho(w) * rho(w)); }, 0, v);
    }
};

/// The same for lambda = 1 by Legendre's elliptic integrals. With tan(v/2) = √(C/D) tan φ:
///   dv / √(ρ² - c²) = 2 dφ / √(AD) / √(1 - k² sin² φ),  ρ = (R + 1)(1 - q sin² φ) / (1 - p sin² φ).
struct EllipticGeodesic {
    double A, C, D, p, q, k, factor, radius, c;

    EllipticGeodesic(double R, double clairaut) : radius(R), c(clairaut) {
        A = R - c + 1, C = R + c + 1, D = R + c - 1;
        const double B = R - c - 1;
        k = std::sqrt(1 - B * C / (A * D));
        factor = 2 / std::sqrt(A * D);
        p = 1 - C / D;
        q = 1 - (R - 1) * C / ((R + 1) * D);
    }
    double phi(double v) const {
        const double turns = std::round(v / (2 * pi));
        return std::atan(std::sqrt(D / C) * std::tan(v / 2 - pi * turns)) + pi * turns;
    }
    double F(double v) const { return gsl_sf_ellint_F(phi(v), k, GSL_PREC_DOUBLE); }
    /// ∫ dφ / (1 - n sin² φ) / √(1 - k² sin² φ).
    double third_kind(double v, double n) const { return gsl_sf_ellint_P(phi(v), k, -n, GSL_PREC_DOUBLE); }
    double length(double v) const { return factor * (radius + 1) * (q / p * F(v) + (1 - q / p) * third_kind(v, p)); }
    double u(double v) const { return factor * c / (radius + 1) * (p / q * F(v) + (1 - p / q) * third_kind(v, q)); }
};

std::vector<std::unique_ptr<Metric>> flow_metrics() {
    std::vector<std::unique_ptr<Metric>> metrics;
    metrics.push_back(std::make_unique<TorusOfRevolution>(2, 1));
    metrics.push_back(std::make_unique<TorusOfRevolution>(2, 2));
    metrics.push_back(std::make_unique<ExpressionEmbedding>(bumpy_embedding, torus_periods));
    metrics.push_back(std::make_unique<ExpressionMetric>(skew_tensor, torus_periods));
    return metrics;
}

}  // namespace

TEST_CASE("geodesics of the circular torus agree with elliptic integrals over length 10 and more") {
    const double radius = 2;
    for (const double c : {0.05, 0.4, 0.9, 0.99}) {
        const EllipticGeodesic elliptic(radius, c);
        const ClairautGeodesic clairaut{radius, 1, c};
        const TorusOfRevolution torus(radius, 1);
        GeodesicFlow flow(torus, {0, 0});
        for (const double v : {1.0, 2.5, 5.0, 10.5}) {
            INFO("c " << c << ", v " << v);
            // Two ways to the truth, which must agree among themselves.
            CHECK(elliptic.length(v) == Approx(clairaut.length_by_quadrature(v)).epsilon(1e-12));
            CHECK(elliptic.u(v) == Approx(clairaut.u_by_quadrature(v)).epsilon(1e-12));
            const GeodesicState state = flow.shoot(clairaut.theta(), elliptic.length(v));
            if (v > 10) CHECK(state.t > 10);
            CHECK(std::abs(state.x.x() - elliptic.u(v)) < 1e-10);
            CHECK(std::abs(state.x.y() - v) < 1e-10);
        }
    }
}

TEST_CASE("geodesics of elliptic tori agree with Clairaut's integral over length 10 and more") {
    for (const double lambda : {0.5, 2.0, 3.0})
        for (const double c : {0.1, 0.7}) {
            const ClairautGeodesic clairaut{2, lambda, c};
            const TorusOfRevolution torus(2, lambda);
            const ExpressionEmbedding embedding(torus_embedding(2, lambda), torus_periods);
            const double v = 14, expected_length = clairaut.length_by_quadrature(v);
            REQUIRE(expected_length > 10);
            for (const Metric* metric : {static_cast<const Metric*>(&torus), static_cast<const Metric*>(&embedding)}) {
                GeodesicFlow flow(*metric, {0, 0});
                const GeodesicState state = flow.shoot(clairaut.theta(), expected_length);
                CHECK(std::abs(state.x.x() - clairaut.u_by_quadrature(v)) < 1e-10);
                CHECK(std::abs(state.x.y() - v) < 1e-10);
            }
        }
}

TEST_CASE("unit speed, Clairaut's constant and the way back are kept over length 10") {
    core::Random random(tests::seed(9));
    for (const auto& metric : flow_metrics())
        for (int i = 0; i < 10; ++i) {
            GeodesicFlow flow(*metric, random_point(random));
            const double theta = random.uniform(-pi, pi);
            const GeodesicState state = flow.shoot(theta, 10);
            CHECK(metric->tensor(state.x).norm(state.velocity) == Approx(1).epsilon(1e-11));
            if (const auto* torus = dynamic_cast<const TorusOfRevolution*>(metric.get())) {
                const GeodesicState start = flow.start(theta);
                CHECK(torus->tensor(state.x).E * state.velocity.x() ==
                      Approx(torus->tensor(start.x).E * start.velocity.x()).margin(1e-11));
            }
            // In two pieces, and back again from the end.
            GeodesicState pieces = flow.shoot(theta, 3.7);
            flow.advance(pieces, 6.3);
            CHECK((pieces.x - state.x).norm() < 1e-9);
            GeodesicFlow back(*metric, state.x);
            const Frame frame(metric->tensor(state.x));
            const MetricTensor g = metric->tensor(state.x);
            const double backwards = std::atan2(-g.inner(state.velocity, frame.e2), -g.inner(state.velocity, frame.e1));
            const GeodesicState returned = back.shoot(backwards, 10);
            CHECK((returned.x - flow.origin()).norm() < 1e-8);
            // Reciprocity of the Jacobi field: j of the way back is j of the way there.
            CHECK(returned.j == Approx(state.j).epsilon(1e-8).margin(1e-8));
        }
}

TEST_CASE("the Jacobi field is the derivative of the exponential map, and j_theta that of j") {
    core::Random random(tests::seed(10));
    for (const auto& metric : flow_metrics())
        for (int i = 0; i < 10; ++i) {
            GeodesicFlow flow(*metric, random_point(random));
            const double theta = random.uniform(-pi, pi), t = random.uniform(0.5, 4);
            const GeodesicState state = flow.shoot(theta, t);
            const double step = 2e-3;
            const Vector2 field = derivative([&](double h) { return flow.shoot(theta + h, t).x; }, step);
            const MetricTensor g = metric->tensor(state.x);
            const double size = 1 + std::abs(state.j) + std::abs(state.j_theta);
            CHECK(std::abs(g.inner(field, g.rotated(state.velocity)) - state.j) < 1e-9 * size);
            CHECK(std::abs(g.inner(field, state.velocity)) < 1e-9 * size);
            CHECK((jacobi_field(*metric, state) - field).norm() < 1e-9 * size);
            const Eigen::Vector3d slopes = derivative(
                [&](double h) {
                    const GeodesicState moved_state = flow.shoot(theta + h, t);
                    return Eigen::Vector3d(moved_state.j, moved_state.j_t, moved_state.area);
                },
                step);
            CHECK(std::abs(slopes[0] - state.j_theta) < 1e-8 * size);
            CHECK(std::abs(slopes[1] - state.j_theta_t) < 1e-8 * (size + std::abs(state.j_theta_t)));
            CHECK(std::abs(slopes[2] - state.area_theta) < 1e-8 * (size + std::abs(state.area_theta)));
            const double h = 1e-3;
            const double j_t =
                derivative([&](double s) { return Eigen::Matrix<double, 1, 1>(flow.shoot(theta, t + s).j); }, h)(0);
            CHECK(std::abs(j_t - state.j_t) < 1e-8 * size);
        }
}

TEST_CASE("the area of a sector is the integral of j") {
    core::Random random(tests::seed(11));
    for (const auto& metric : flow_metrics())
        for (int i = 0; i < 3; ++i) {
            GeodesicFlow flow(*metric, random_point(random));
            const double theta = random.uniform(-pi, pi), t = 3;
            const double expected = quadrature([&](double s) { return flow.shoot(theta, s).j; }, 0, t);
            CHECK(flow.shoot(theta, t).area == Approx(expected).epsilon(1e-10));
        }
}

TEST_CASE("constant curvature: the Jacobi field and the area are known") {
    const ExpressionMetric sphere("E=1;F=0;G=sin(u)^2", {}), saddle("E=1;F=0;G=exp(2*u)", {}),
        plane("E=2;F=0.5;G=1", {});
    core::Random random(tests::seed(12));
    const auto check = [&](const Metric& metric, const Point2& origin, double t, double j, double j_t, double area) {
        GeodesicFlow flow(metric, origin);
        for (int i = 0; i < 20; ++i) {
            const GeodesicState state = flow.shoot(random.uniform(-pi, pi), t);
            CHECK(state.j == Approx(j).epsilon(1e-11));
            CHECK(state.j_t == Approx(j_t).epsilon(1e-11));
            CHECK(state.area == Approx(area).epsilon(1e-11));
            CHECK(std::abs(state.j_theta) < 1e-9);
        }
    };
    check(sphere, {pi / 2, 0}, 1, std::sin(1), std::cos(1), 1 - std::cos(1));
    check(saddle, {0.3, 0}, 1.5, std::sinh(1.5), std::cosh(1.5), std::cosh(1.5) - 1);
    check(plane, {0.3, 0}, 5, 5, 1, 12.5);
}

TEST_CASE("a geodesic that runs into a singular point of the metric is an error") {
    const ExpressionMetric half_plane("E=1;F=0;G=sqrt(u)", {});
    GeodesicFlow flow(half_plane, {0.5, 0});
    REQUIRE_THROWS_AS(flow.shoot(pi, 2), core::RunError);
}
