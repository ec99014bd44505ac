// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/edge_collapse.h"

#include <algorithm>
#include <cmath>

#include "core/require.h"
#include "surface/triangle.h"

namespace dsc::surface {

namespace {

/// The middle of the edge, moved by as little as keeps the volume between the two rings and any place inside.
std::optional<Point3> volume_keeping_middle(const OneRing& a, const OneRing& b) {
    const Point3 middle = (a.centre + b.centre) / 2;
    // Six times the volume between the middle and the triangles of both rings, and its gradient.
    Vector3 gradient = Vector3::Zero();
    double volume = 0;
    const auto add = [&](const Point3& p, const RingTriangle& t) {
        const Vector3 normal = (t.a - p).cross(t.b - p);
        gradient += normal;
        volume += normal.dot(p - middle);
    };
    for (const RingTriangle& t : a.triangles) add(a.centre, t);
    for (const RingTriangle& t : b.triangles) {
        if (!t.has(a.centre)) add(b.centre, t);
    }
    const double square = gradient.squaredNorm();
    if (!(square > 0)) return {};
    const Vector3 step = gradient * (volume / square);
    if (step.norm() > 0.5 * (b.centre - a.centre).norm()) return {};  // rings folded onto themselves
    return middle + step;
}

class Collapse {
public:
    Collapse(const OneRing& a, const OneRing& b, const CollapseParameters& parameters)
        : a_(a), b_(b), max_turn_(radians(parameters.max_turn)), min_angle_(radians(parameters.min_angle)) {
        for_each_left([&](const Point3& centre, const RingTriangle& t) {
            min_angle_ = std::min(min_angle_, min_angle(centre, t.a, t.b));
        });
    }

    /// The largest turn of a triangle when both ends go to `place` [rad]; none when that is too much.
    std::optional<double> turn(const Point3& place) const {
        double largest = 0;
        bool is_good = true;
        for_each_left([&](const Point3& centre, const RingTriangle& t) {
            const Vector3 before = unit_normal(centre, t.a, t.b), after = unit_normal(place, t.a, t.b);
            if (after.isZero(0) || min_angle(place, t.a, t.b) < min_angle_) is_good = false;
            if (!before.isZero(0)) largest = std::max(largest, angle_between(before, after));
        });
        return is_good && largest <= max_turn_ ? std::optional(largest) : std::nullopt;
    }

    /// The end at which less turns.
    std::optional<Point3> better_end() const {
        const std::optional<double> at_a = turn(a_.centre), at_b = turn(b_.centre);
        if (at_a && (!at_b || *at_a <= *at_b)) return a_.centre;
        return at_b ? std::optional(b_.centre) : std::nullopt;
    }

    std::optional<Point3> if_good(const std::optional<Point3>& place) const {
        return place && turn(*place) ? place : std::nullopt;
    }

private:
    /// The triangles that have one of the ends only.
    template <class Visit>
    void for_each_left(const Visit& visit) const {
        for (const RingTriangle& t : a_.triangles) {
            if (!t.has(b_.centre)) visit(a_.centre, t);
        }
        for (const RingTriangle& t : b_.triangles) {
            if (!t.has(a_.centre)) visit(b_.centre, t);
        }
    }

    const OneRing& a_;
    const OneRing& b_;
    double max_turn_;
    double min_angle_;
};

VertexFeature feature(const OneRing& ring, double feature_angle) {
    return vertex_feature(ring, vertex_quadric(ring), feature_angle);
}

}  // namespace

void CollapseParameters::validate() const {
    core::require(feature_angle > 0 && feature_angle < 90, "feature_angle", "in (0, 90)");
    core::require(max_turn > 0 && max_turn < 90, "max_turn", "in (0, 90)");
    core::require(min_angle >= 0 && min_angle < 60, "min_angle", "in [0, 60)");
}

std::optional<Point3> collapsed_position(const OneRing& a, VertexFeature feature_a, const OneRing& b,
                                         VertexFeature feature_b, bool is_feature_edge,
                                         const CollapseParameters& parameters) {
    const VertexFeature lower = std::min(feature_a, feature_b);
    if (lower == VertexFeature::corner) return {};
    // A vertex of a ridge may leave its place along the ridge only.
    if (lower == VertexFeature::ridge && !is_feature_edge) return {};
    const Collapse collapse(a, b, parameters);
    if (feature_a != feature_b) return collapse.if_good(feature_a > feature_b ? a.centre : b.centre);
    if (feature_a == VertexFeature::ridge) return collapse.better_end();
    return collapse.if_good(volume_keeping_middle(a, b));
}

std::optional<Point3> collapsed_position(const OneRing& a, const OneRing& b, const CollapseParameters& parameters) {
    return collapsed_position(a, feature(a, parameters.feature_angle), b, feature(b, parameters.feature_angle),
                              is_feature_edge(a, b.centre, parameters.feature_angle), parameters);
}

Point3 dominant_position(const OneRing& a, const OneRing& b, const CollapseParameters& parameters) {
    const VertexFeature feature_a = feature(a, parameters.feature_angle);
    const VertexFeature feature_b = feature(b, parameters.feature_angle);
    if (feature_a == feature_b) return (a.centre + b.centre) / 2;
    return feature_a > feature_b ? a.centre : b.centre;
}

}  // namespace dsc::surface
