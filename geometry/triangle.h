// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of a planar triangle: area, angles, heights, quality. Rounded arithmetic: for decisions of validity use
// geometry/predicates.h. Cost: constant, no allocation.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "geometry/predicates.h"

namespace dsc::geometry {

inline double cross(const Point2& u, const Point2& v) { return u.x() * v.y() - u.y() * v.x(); }

/// Area, positive when a, b, c turn counterclockwise [length^2].
inline double signed_area(const Point2& a, const Point2& b, const Point2& c) { return 0.5 * cross(b - a, c - a); }

/// Angle between two directions, in [0, pi]; neither may be zero [rad].
inline double angle_between(const Point2& u, const Point2& v) { return std::atan2(std::abs(cross(u, v)), u.dot(v)); }

/// Smallest angle of the triangle [rad].
inline double min_angle(const Point2& a, const Point2& b, const Point2& c) {
    const Point2 ab = b - a, bc = c - b, ca = a - c;
    const double lab = ab.squaredNorm(), lbc = bc.squaredNorm(), lca = ca.squaredNorm();
    if (lab <= lbc && lab <= lca) return angle_between(-bc, ca);
    if (lbc <= lca) return angle_between(ab, -ca);
    return angle_between(bc, -ab);
}

/// Largest angle of the triangle [rad].
inline double max_angle(const Point2& a, const Point2& b, const Point2& c) {
    const Point2 ab = b - a, bc = c - b, ca = a - c;
    const double lab = ab.squaredNorm(), lbc = bc.squaredNorm(), lca = ca.squaredNorm();
    if (lab >= lbc && lab >= lca) return angle_between(-bc, ca);
    if (lbc >= lca) return angle_between(ab, -ca);
    return angle_between(bc, -ab);
}

/// 4 sqrt(3) area over the sum of squared edge lengths: 1 for an equilateral triangle, 0 for a flat one, negative for
/// an inverted one.
inline double mean_ratio(const Point2& a, const Point2& b, const Point2& c) {
    const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
    return squares > 0.0 ? 2.0 * std::sqrt(3.0) * cross(b - a, c - a) / squares : 0.0;
}

/// Parameter in [0, 1] of the point of the segment from a to b that is closest to p; a and b must differ.
inline double closest_parameter(const Point2& p, const Point2& a, const Point2& b) {
    const Point2 ab = b - a;
    return std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
}

}  // namespace dsc::geometry
