// SPDX-License-Identifier: GPL-3.0-or-later
// A Riemannian metric on a chart (u, v): the seam between a surface, however it is given, and everything that needs
// its geodesics. Thesis 5.1.2 and 5.4.2.
// Guarantee: queries are const, thread-safe and deterministic. Cost: one virtual call per query.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <optional>

namespace dsc::geodesic {

using Point2 = Eigen::Vector2d;
using Vector2 = Eigen::Vector2d;
using Point3 = Eigen::Vector3d;
using LatticeVector = Eigen::Vector2i;

/// First fundamental form E du² + 2F du dv + G dv².
struct MetricTensor {
    double E = 1, F = 0, G = 1;

    double determinant() const { return E * G - F * F; }
    double inner(const Vector2& a, const Vector2& b) const {
        return E * a.x() * b.x() + F * (a.x() * b.y() + a.y() * b.x()) + G * a.y() * b.y();
    }
    double norm(const Vector2& a) const;
    /// `a` turned by +90° (from ∂u towards ∂v) in this metric; same length.
    Vector2 rotated(const Vector2& a) const;
};

/// What the geodesic equation (5.3) and the Jacobi equation need at a point.
struct LocalGeometry {
    MetricTensor tensor;
    std::array<double, 3> christoffel_u{};  ///< Γ^u_uu, Γ^u_uv, Γ^u_vv
    std::array<double, 3> christoffel_v{};  ///< Γ^v_uu, Γ^v_uv, Γ^v_vv
    double curvature = 0;                   ///< Gaussian curvature K
    Vector2 curvature_gradient{0, 0};       ///< (∂K/∂u, ∂K/∂v)
};

/// What Newton's method on the geodesic equation needs at a point: the connection and its first derivatives.
struct ConnectionJet {
    MetricTensor tensor;
    std::array<double, 3> christoffel_u{};          ///< as in LocalGeometry
    std::array<double, 3> christoffel_v{};          ///< as in LocalGeometry
    std::array<Vector2, 3> christoffel_u_gradient;  ///< (∂/∂u, ∂/∂v) of each component of christoffel_u
    std::array<Vector2, 3> christoffel_v_gradient;  ///< (∂/∂u, ∂/∂v) of each component of christoffel_v
};

/// Periods of the chart in u and v; a direction without a period is unbounded.
struct ChartPeriods {
    std::optional<double> u, v;

    /// The translation of the chart that belongs to `lattice`; a component without a period must be 0.
    Vector2 translation(const LatticeVector& lattice) const;
    /// `point` brought to [-period/2, period/2) in each periodic direction.
    Point2 wrapped(Point2 point) const;
    bool is_torus() const { return u && v; }
};

class Metric {
public:
    explicit Metric(ChartPeriods periods) : periods_(periods) {}
    virtual ~Metric() = default;

    virtual MetricTensor tensor(const Point2& x) const = 0;
    virtual LocalGeometry local_geometry(const Point2& x) const = 0;
    virtual ConnectionJet connection_jet(const Point2& x) const = 0;
    /// The point in space, for surfaces that are given by an embedding.
    virtual std::optional<Point3> position(const Point2& x) const;

    const ChartPeriods& periods() const { return periods_; }

private:
    ChartPeriods periods_;
};

/// Orthonormal frame at a point: the first vector along ∂u, the second +90° from it. Directions are angles in it.
struct Frame {
    Vector2 e1, e2;

    explicit Frame(const MetricTensor& tensor);
    Vector2 direction(double theta) const { return std::cos(theta) * e1 + std::sin(theta) * e2; }
};

/// Area of the fundamental domain of a doubly periodic metric: trapezoidal rule, doubled until two successive values
/// agree to `tolerance` (relative); spectral for analytic metrics.
/// Throws core::RunError if 4096² points don't reach it. Precondition: periods().is_torus().
double total_area(const Metric& metric, double tolerance = 1e-12);

}  // namespace dsc::geodesic
