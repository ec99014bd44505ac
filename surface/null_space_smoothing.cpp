// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/null_space_smoothing.h"

#include <algorithm>
#include <limits>

#include "core/require.h"
#include "surface/triangle.h"

namespace dsc::surface {

namespace {

constexpr double least_rise = 1e-3;  // of the smallest angle, relative: steps that gain less are not worth a change

constexpr double least_area = 1e-6;  // of the sum of area vectors [sum of areas]

/// Distance of `step` from the half-line along `edge`.
double distance_to_ray(const Vector3& step, const Vector3& edge) {
    const double share = std::max(0.0, step.dot(edge) / edge.squaredNorm());
    return (step - share * edge).norm();
}

/// Distance of `step` from the infinite sector between p and q.
double distance_to_sector(const Vector3& step, const Vector3& p, const Vector3& q) {
    const Vector3 normal = p.cross(q);
    const double to_rays = std::min(distance_to_ray(step, p), distance_to_ray(step, q));
    const bool is_over = step.cross(q).dot(normal) >= 0 && p.cross(step).dot(normal) >= 0 && !normal.isZero(0);
    return is_over ? std::min(to_rays, std::abs(step.dot(normal)) / normal.norm()) : to_rays;
}

/// Distance of the centre after `step` from the ring, whose triangles are prolonged.
double distance_to_ring(const OneRing& ring, const Vector3& step) {
    double least = std::numeric_limits<double>::infinity();
    for (const RingTriangle& t : ring.triangles) {
        least = std::min(least, distance_to_sector(step, t.a - ring.centre, t.b - ring.centre));
    }
    return least;
}

bool turns_over(const OneRing& ring, const Point3& centre) {
    return std::ranges::any_of(ring.triangles, [&](const RingTriangle& t) {
        return area_vector(centre, t.a, t.b).dot(area_vector(ring.centre, t.a, t.b)) <= 0;
    });
}

}  // namespace

void SmoothingParameters::validate() const {
    core::require(feature_angle > 0 && feature_angle < 90, "feature_angle", "in (0, 90)");
    core::require(freedom >= 0, "freedom", "at least 0");
    core::require(good_angle >= 0 && good_angle <= 60, "good_angle", "in [0, 60]");
}

double min_angle_at(const OneRing& ring, const Point3& centre) {
    double least = std::numeric_limits<double>::infinity();
    for (const RingTriangle& t : ring.triangles) least = std::min(least, min_angle(centre, t.a, t.b));
    return least;
}

Vector3 null_space_displacement(const OneRing& ring, const VertexQuadric& quadric, VertexFeature feature,
                                const SmoothingParameters& parameters) {
    if (feature == VertexFeature::corner) return Vector3::Zero();
    Vector3 sum = Vector3::Zero(), areas = Vector3::Zero();
    double area = 0, edges = 0;
    for (const RingTriangle& t : ring.triangles) {
        const Vector3 vector = area_vector(ring.centre, t.a, t.b);
        const double weight = vector.norm();
        sum += weight * ((t.a - ring.centre) + (t.b - ring.centre)) / 3;
        areas += vector;
        area += weight;
        edges += ((t.a - ring.centre).norm() + (t.b - ring.centre).norm()) / 2;
    }
    if (!(area > 0)) return Vector3::Zero();

    const Vector3 wanted = sum / area;
    Vector3 step = wanted;
    if (feature == VertexFeature::ridge) step = quadric.vector(2) * quadric.vector(2).dot(wanted);
    // Area vectors of opposite sheets may cancel and leave no direction but that of rounding.
    if (areas.norm() > least_area * area) step -= areas * (areas.dot(step) / areas.squaredNorm());
    // The distance grows linearly on the way, because the prolonged ring is a cone.
    const double limit = parameters.freedom * edges / static_cast<double>(ring.triangles.size());
    const double distance = distance_to_ring(ring, step);
    return distance > limit ? Vector3(step * (limit / distance)) : step;
}

std::optional<Point3> smoothed_position(const OneRing& ring, const SmoothingParameters& parameters) {
    const double before = min_angle_at(ring, ring.centre);
    if (ring.triangles.empty() || before >= radians(parameters.good_angle)) return {};
    const VertexQuadric quadric = vertex_quadric(ring);
    const VertexFeature feature = vertex_feature(ring, quadric, parameters.feature_angle);
    const Vector3 step = null_space_displacement(ring, quadric, feature, parameters);
    if (step.isZero(0)) return {};
    for (const double share : {1.0, 0.5, 0.25}) {
        const Point3 place = ring.centre + share * step;
        if (min_angle_at(ring, place) > (1 + least_rise) * before && !turns_over(ring, place)) return place;
    }
    return {};
}

}  // namespace dsc::surface
