// SPDX-License-Identifier: GPL-3.0-or-later
// Exact signs of the determinants that decide whether a triangulation or a tetrahedralization is valid and whether a
// triangulation is Delaunay.
// Source: static error bounds of Shewchuk (1997), "Adaptive Precision Floating-Point Arithmetic and Fast Robust
// Geometric Predicates"; signs that the bound can't decide come from CGAL's exact kernel, behind the .cpp wall.
// Guarantee: the sign is that of the real determinant of the doubles given (no overflow or underflow of products).
// Cost: about 3 ns (orientation in the plane) and 10 ns (the others) when the bound decides, microseconds when it
// doesn't.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>

namespace dsc::geometry {

using Point2 = Eigen::Vector2d;
using Point3 = Eigen::Vector3d;

enum class Sign : std::int8_t { negative = -1, zero = 0, positive = 1 };

namespace detail {
Sign exact_orientation(const Point2& a, const Point2& b, const Point2& c);
Sign exact_in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
Sign exact_orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

inline constexpr double half_ulp = 0x1.0p-53;
inline constexpr double orientation_bound = (3.0 + 16.0 * half_ulp) * half_ulp;
inline constexpr double in_circle_bound = (10.0 + 96.0 * half_ulp) * half_ulp;
inline constexpr double orientation_3d_bound = (7.0 + 56.0 * half_ulp) * half_ulp;
}  // namespace detail

/// Positive when a, b, c turn counterclockwise.
inline Sign orientation(const Point2& a, const Point2& b, const Point2& c) {
    const double left = (a.x() - c.x()) * (b.y() - c.y());
    const double right = (a.y() - c.y()) * (b.x() - c.x());
    const double determinant = left - right;
    const double bound = detail::orientation_bound * (std::abs(left) + std::abs(right));
    if (determinant > bound) return Sign::positive;
    if (determinant < -bound) return Sign::negative;
    return detail::exact_orientation(a, b, c);
}

inline bool is_counterclockwise(const Point2& a, const Point2& b, const Point2& c) {
    return orientation(a, b, c) == Sign::positive;
}

/// Positive when d lies inside the circle through a, b, c; precondition: a, b, c counterclockwise.
inline Sign in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    const Point2 p = a - d, q = b - d, r = c - d;
    const double qr_left = q.x() * r.y(), qr_right = r.x() * q.y();
    const double rp_left = r.x() * p.y(), rp_right = p.x() * r.y();
    const double pq_left = p.x() * q.y(), pq_right = q.x() * p.y();
    const double pp = p.squaredNorm(), qq = q.squaredNorm(), rr = r.squaredNorm();
    const double determinant = pp * (qr_left - qr_right) + qq * (rp_left - rp_right) + rr * (pq_left - pq_right);
    const double permanent = pp * (std::abs(qr_left) + std::abs(qr_right)) +
                             qq * (std::abs(rp_left) + std::abs(rp_right)) +
                             rr * (std::abs(pq_left) + std::abs(pq_right));
    const double bound = detail::in_circle_bound * permanent;
    if (determinant > bound) return Sign::positive;
    if (determinant < -bound) return Sign::negative;
    return detail::exact_in_circle(a, b, c, d);
}

/// Positive when b - a, c - a, d - a are right-handed.
inline Sign orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    const Point3 p = b - a, q = c - a, r = d - a;
    const double qr_left = q.x() * r.y(), qr_right = q.y() * r.x();
    const double rp_left = r.x() * p.y(), rp_right = r.y() * p.x();
    const double pq_left = p.x() * q.y(), pq_right = p.y() * q.x();
    const double determinant =
        p.z() * (qr_left - qr_right) + q.z() * (rp_left - rp_right) + r.z() * (pq_left - pq_right);
    const double permanent = std::abs(p.z()) * (std::abs(qr_left) + std::abs(qr_right)) +
                             std::abs(q.z()) * (std::abs(rp_left) + std::abs(rp_right)) +
                             std::abs(r.z()) * (std::abs(pq_left) + std::abs(pq_right));
    const double bound = detail::orientation_3d_bound * permanent;
    if (determinant > bound) return Sign::positive;
    if (determinant < -bound) return Sign::negative;
    return detail::exact_orientation(a, b, c, d);
}

inline bool is_positive(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    return orientation(a, b, c, d) == Sign::positive;
}

}  // namespace dsc::geometry
