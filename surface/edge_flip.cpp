// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/edge_flip.h"

#include <algorithm>
#include <cmath>

#include "core/require.h"
#include "surface/features.h"
#include "surface/triangle.h"

namespace dsc::surface {

namespace {

double longest_edge(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    return std::sqrt(std::max({(b - a).squaredNorm(), (c - a).squaredNorm(), (d - a).squaredNorm(),
                               (c - b).squaredNorm(), (d - b).squaredNorm(), (d - c).squaredNorm()}));
}

double volume(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    return std::abs((b - a).cross(c - a).dot(d - a)) / 6;
}

/// Distance of the lines ab and cd; 0 when they are parallel.
double distance_of_diagonals(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    const double area = (b - a).cross(d - c).norm();
    return area > 0 ? 6 * volume(a, b, c, d) / area : 0;
}

/// Both new triangles face the way the two old ones do together.
bool keeps_orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    const Vector3 normal = area_vector(a, b, c) + area_vector(b, a, d);
    return area_vector(a, d, c).dot(normal) > 0 && area_vector(d, b, c).dot(normal) > 0;
}

}  // namespace

void FlipParameters::validate() const {
    core::require(feature_angle > 0 && feature_angle < 90, "feature_angle", "in (0, 90)");
    core::require(max_volume >= 0 && max_volume <= 0.11, "max_volume", "in [0, 0.11]");
    core::require(coplanar_distance >= 0, "coplanar_distance", "at least 0");
    core::require(min_gain >= 0, "min_gain", "at least 0");
}

double flatness(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    const double longest = longest_edge(a, b, c, d);
    return longest > 0 ? volume(a, b, c, d) / (longest * longest * longest) : 0;
}

std::optional<double> flip_gain(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                                const FlipParameters& parameters) {
    const double before = std::min(min_angle(a, b, c), min_angle(b, a, d));
    const double after = std::min(min_angle(a, d, c), min_angle(d, b, c));
    const double gain = (after - before) / radians(1);
    if (!(gain > parameters.min_gain) || !keeps_orientation(a, b, c, d)) return {};
    if (flatness(a, b, c, d) > parameters.max_volume) return {};
    const bool is_coplanar =
        distance_of_diagonals(a, b, c, d) <= parameters.coplanar_distance * longest_edge(a, b, c, d);
    if (!is_coplanar && is_feature_edge(a, b, c, d, parameters.feature_angle)) return {};
    return gain;
}

}  // namespace dsc::surface
