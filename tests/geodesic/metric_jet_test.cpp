// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic/metric_jet.h"

#include <Eigen/LU>
#include <memory>
#include <vector>

#include "geodesic/expression_metric.h"
#include "geodesic/torus.h"
#include "tests/geodesic/samples.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::geodesic;
using namespace dsc::tests;

namespace {

std::vector<std::unique_ptr<Metric>> sample_metrics() {
    std::vector<std::unique_ptr<Metric>> metrics;
    metrics.push_back(std::make_unique<TorusOfRevolution>(2, 1));
    metrics.push_back(std::make_unique<TorusOfRevolution>(-2.5, 0.6));
    metrics.push_back(std::make_unique<ExpressionEmbedding>(torus_embedding(2, 2), torus_periods));
    metrics.push_back(std::make_unique<ExpressionEmbedding>(bumpy_embedding, torus_periods));
    metrics.push_back(std::make_unique<ExpressionMetric>(skew_tensor, torus_periods));
    metrics.push_back(
        std::make_unique<ExpressionMetric>("E=exp(0.4*(cos(u)+cos(v)));F=0;G=exp(0.4*(cos(u)+cos(v)))", torus_periods));
    return metrics;
}

double difference(const LocalGeometry& a, const LocalGeometry& b) {
    return std::max({(components(a.tensor) - components(b.tensor)).lpNorm<Eigen::Infinity>(),
                     (christoffel_symbols(a) - christoffel_symbols(b)).lpNorm<Eigen::Infinity>(),
                     std::abs(a.curvature - b.curvature),
                     (a.curvature_gradient - b.curvature_gradient).lpNorm<Eigen::Infinity>()});
}

/// Γ from differences of the tensor alone.
Eigen::Matrix<double, 6, 1> symbols_from_differences(const Metric& metric, const Point2& x) {
    Eigen::Vector3d slope[2];
    for (int i = 0; i < 2; ++i)
        slope[i] = derivative([&](double h) { return components(metric.tensor(moved(x, i, h))); });
    const auto& [u, v] = slope;
    Eigen::Matrix2d g;
    const MetricTensor tensor = metric.tensor(x);
    g << tensor.E, tensor.F, tensor.F, tensor.G;
    Eigen::Matrix<double, 2, 3> first_kind;
    first_kind << u[0] / 2, v[0] / 2, v[1] - u[2] / 2, u[1] - v[0] / 2, u[2] / 2, v[2] / 2;
    const Eigen::Matrix<double, 2, 3> second_kind = g.inverse() * first_kind;
    Eigen::Matrix<double, 6, 1> symbols;
    symbols << second_kind.row(0).transpose(), second_kind.row(1).transpose();
    return symbols;
}

/// K from the connection by Gauss' formula:
/// E K = ∂_v Γ^v_uu - ∂_u Γ^v_uv + Γ^u_uu Γ^v_uv + Γ^v_uu Γ^v_vv - Γ^u_uv Γ^v_uu - (Γ^v_uv)².
double curvature_from_connection(const Metric& metric, const Point2& x) {
    const ConnectionJet jet = metric.connection_jet(x);
    const auto& a = jet.christoffel_u;
    const auto& b = jet.christoffel_v;
    const double e_times_k = jet.christoffel_v_gradient[0].y() - jet.christoffel_v_gradient[1].x() + a[0] * b[1] +
                             b[0] * b[2] - a[1] * b[0] - b[1] * b[1];
    return e_times_k / jet.tensor.E;
}

}  // namespace

TEST_CASE("embedding, tensor and closed formula of a torus agree") {
    core::Random random(tests::seed(2));
    for (const auto& [radius, lambda] : {std::pair{2.0, 1.0}, {2.0, 2.0}, {1.25, 0.5}, {3.0, 3.0}}) {
        const TorusOfRevolution torus(radius, lambda);
        const ExpressionEmbedding embedding(torus_embedding(radius, lambda), torus_periods);
        const ExpressionMetric tensor(torus_tensor(radius, lambda), torus_periods);
        for (int i = 0; i < 500; ++i) {
            const Point2 x = random_point(random);
            const LocalGeometry local = torus.local_geometry(x);
            // The margin is 1e-12 of the largest number at stake: K' reaches some hundred where a section is flat.
            const double size = 1 + std::abs(local.curvature) + local.curvature_gradient.norm() + local.tensor.E;
            REQUIRE(difference(local, embedding.local_geometry(x)) < 1e-12 * size);
            REQUIRE(difference(local, tensor.local_geometry(x)) < 1e-12 * size);
            REQUIRE((*torus.position(x) - *embedding.position(x)).norm() < 1e-14 * radius);
        }
    }
}

TEST_CASE("Christoffel symbols agree with differences of the tensor") {
    core::Random random(tests::seed(3));
    for (const auto& metric : sample_metrics())
        for (int i = 0; i < 50; ++i) {
            const Point2 x = random_point(random);
            const auto expected = symbols_from_differences(*metric, x);
            REQUIRE((christoffel_symbols(metric->local_geometry(x)) - expected).norm() < 1e-9 * (1 + expected.norm()));
        }
}

TEST_CASE("curvature agrees with the curvature tensor and its gradient with differences") {
    core::Random random(tests::seed(4));
    for (const auto& metric : sample_metrics())
        for (int i = 0; i < 50; ++i) {
            const Point2 x = random_point(random);
            const LocalGeometry local = metric->local_geometry(x);
            REQUIRE(local.curvature == Approx(curvature_from_connection(*metric, x)).epsilon(1e-11).margin(1e-11));
            for (int direction = 0; direction < 2; ++direction) {
                const double slope = derivative(
                    [&](double h) {
                        return Eigen::Matrix<double, 1, 1>(metric->local_geometry(moved(x, direction, h)).curvature);
                    },
                    0.005)(0);
                REQUIRE(local.curvature_gradient[direction] == Approx(slope).epsilon(1e-8).margin(1e-8));
            }
        }
}

TEST_CASE("the connection jet agrees with the local geometry and its gradients with differences") {
    core::Random random(tests::seed(5));
    for (const auto& metric : sample_metrics())
        for (int i = 0; i < 50; ++i) {
            const Point2 x = random_point(random);
            const ConnectionJet jet = metric->connection_jet(x);
            const LocalGeometry local = metric->local_geometry(x);
            REQUIRE((christoffel_symbols(jet) - christoffel_symbols(local)).norm() <
                    1e-13 * (1 + christoffel_symbols(local).norm()));
            REQUIRE((components(jet.tensor) - components(local.tensor)).norm() <
                    1e-13 * components(local.tensor).norm());
            for (int direction = 0; direction < 2; ++direction) {
                const auto slope = derivative(
                    [&](double h) { return christoffel_symbols(metric->local_geometry(moved(x, direction, h))); },
                    0.005);
                for (std::size_t k = 0; k < 3; ++k) {
                    REQUIRE(jet.christoffel_u_gradient[k][direction] ==
                            Approx(slope(static_cast<Eigen::Index>(k))).epsilon(1e-8).margin(1e-8));
                    REQUIRE(jet.christoffel_v_gradient[k][direction] ==
                            Approx(slope(static_cast<Eigen::Index>(k) + 3)).epsilon(1e-8).margin(1e-8));
                }
            }
        }
}

TEST_CASE("Gauss-Bonnet: the total curvature of a torus is 0") {
    for (const auto& metric : sample_metrics()) {
        // The trapezoidal rule is spectral on periodic analytic functions.
        const int count = 192;
        double total = 0, absolute = 0;
        for (int i = 0; i < count; ++i)
            for (int k = 0; k < count; ++k) {
                const LocalGeometry local = metric->local_geometry({2 * pi * i / count, 2 * pi * k / count});
                const double share = local.curvature * std::sqrt(local.tensor.determinant());
                total += share;
                absolute += std::abs(share);
            }
        CHECK(std::abs(total) < 1e-12 * absolute);
    }
}

TEST_CASE("surfaces of constant curvature") {
    core::Random random(tests::seed(6));
    const auto check_constant = [&](const Metric& metric, double curvature, double low, double high) {
        for (int i = 0; i < 200; ++i) {
            const LocalGeometry local = metric.local_geometry({random.uniform(low, high), random.uniform(-3, 3)});
            REQUIRE(local.curvature == Approx(curvature).epsilon(1e-12).margin(1e-12));
            REQUIRE(local.curvature_gradient.norm() < 2e-10);
        }
    };
    check_constant(ExpressionMetric("E=1;F=0;G=sin(u)^2", {}), 1, 0.3, 2.8);
    check_constant(ExpressionMetric("E=1;F=0;G=exp(2*u)", {}), -1, -1, 1);
    check_constant(ExpressionEmbedding("x=3*sin(u)*cos(v);y=3*sin(u)*sin(v);z=3*cos(u)", {}), 1.0 / 9, 0.3, 2.8);
    check_constant(ExpressionEmbedding("x=cos(v)/cosh(u);y=sin(v)/cosh(u);z=u-tanh(u)", {}), -1, 0.5, 2);
    check_constant(ExpressionMetric("E=1;F=0.5;G=1", {}), 0, -5, 5);
    // A plane in skewed polar coordinates: flat, with all six symbols in play.
    check_constant(ExpressionEmbedding("x=u*cos(v+u/2);y=u*sin(v+u/2);z=0", {}), 0, 0.5, 3);
}

TEST_CASE("surfaces with known Christoffel symbols") {
    const ExpressionMetric sphere("E=1;F=0;G=sin(u)^2", {});
    const LocalGeometry local = sphere.local_geometry({0.7, 0.1});
    Eigen::Matrix<double, 6, 1> expected;
    expected << 0, 0, -std::sin(0.7) * std::cos(0.7), 0, std::cos(0.7) / std::sin(0.7), 0;
    CHECK((christoffel_symbols(local) - expected).norm() < 1e-15);
}
