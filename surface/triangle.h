// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of a triangle in space. Cost: constant, no allocation.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "surface/one_ring.h"

namespace dsc::surface {

/// Normal, as long as the triangle is large.
inline Vector3 area_vector(const Point3& a, const Point3& b, const Point3& c) { return 0.5 * (b - a).cross(c - a); }

/// Angle between two directions, in [0, pi], with full accuracy at both ends; 0 when one of them is zero [rad].
inline double angle_between(const Vector3& u, const Vector3& v) { return std::atan2(u.cross(v).norm(), u.dot(v)); }

/// Smallest angle of the triangle [rad].
inline double min_angle(const Point3& a, const Point3& b, const Point3& c) {
    const Vector3 ab = b - a, bc = c - b, ca = a - c;
    return std::min({angle_between(ab, -ca), angle_between(bc, -ab), angle_between(ca, -bc)});
}

inline double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// The ratio of the height over the longest edge to that edge below which a triangle has no normal worth its name.
inline constexpr double flattest = 1e-8;

/// Unit normal; zero when the triangle is too flat to have one.
inline Vector3 unit_normal(const Point3& a, const Point3& b, const Point3& c) {
    const Vector3 ab = b - a, ac = c - a;
    const Vector3 normal = ab.cross(ac);
    const double longest = std::max({ab.squaredNorm(), ac.squaredNorm(), (c - b).squaredNorm()});
    const double twice_area = normal.norm();
    return twice_area > flattest * longest ? Vector3(normal / twice_area) : Vector3(Vector3::Zero());
}

}  // namespace dsc::surface
