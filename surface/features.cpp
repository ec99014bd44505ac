// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/features.h"

#include <algorithm>
#include <array>

#include "surface/triangle.h"

namespace dsc::surface {

namespace {

/// The edges at the centre that are features; of the first two the directions.
struct FeatureEdges {
    int count = 0;
    Vector3 first = Vector3::Zero();
    Vector3 second = Vector3::Zero();
};

/// Each neighbour at a feature edge, once.
template <class Visit>
void for_each_feature_end(const OneRing& ring, double feature_angle, const Visit& visit) {
    for (std::size_t i = 0; i < ring.triangles.size(); ++i) {
        for (const Point3& end : {ring.triangles[i].a, ring.triangles[i].b}) {
            const bool is_known =
                std::ranges::any_of(ring.triangles.first(i), [&](const auto& t) { return t.has(end); });
            if (!is_known && is_feature_edge(ring, end, feature_angle)) visit(end);
        }
    }
}

FeatureEdges feature_edges(const OneRing& ring, double feature_angle) {
    FeatureEdges edges;
    for_each_feature_end(ring, feature_angle, [&](const Point3& end) {
        if (edges.count == 0) edges.first = end - ring.centre;
        if (edges.count == 1) edges.second = end - ring.centre;
        ++edges.count;
    });
    return edges;
}

}  // namespace

double bend(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    return angle_between(unit_normal(a, b, c), unit_normal(b, a, d)) / radians(1);
}

bool is_feature_edge(const Point3& a, const Point3& b, const Point3& c, const Point3& d, double feature_angle) {
    return bend(a, b, c, d) > feature_angle;
}

bool is_feature_edge(const OneRing& ring, const Point3& end, double feature_angle) {
    int count = 0;
    std::array<Vector3, 2> normals;
    for (const RingTriangle& triangle : ring.triangles) {
        if (!triangle.has(end)) continue;
        if (++count > 2) return true;
        // Turned so that the edge goes the same way round in both, whatever their orientation.
        const Vector3 normal = unit_normal(ring.centre, triangle.a, triangle.b);
        normals[static_cast<std::size_t>(count - 1)] = (triangle.a == end) == (count == 1) ? normal : Vector3(-normal);
    }
    return count != 2 || angle_between(normals[0], normals[1]) > radians(feature_angle);
}

std::optional<Point3> other_feature_end(const OneRing& ring, const Point3& end, double feature_angle) {
    std::optional<Point3> other;
    int count = 0;
    for_each_feature_end(ring, feature_angle, [&](const Point3& candidate) {
        if (candidate == end) return;
        other = candidate;
        ++count;
    });
    return count == 1 ? other : std::nullopt;
}

VertexFeature vertex_feature(const OneRing& ring, const VertexQuadric& quadric, double feature_angle) {
    const int rank = quadric.rank(feature_angle);
    if (rank == 3) return VertexFeature::corner;
    const FeatureEdges edges = feature_edges(ring, feature_angle);
    if (edges.count >= 3) return VertexFeature::corner;
    if (edges.count == 2) {
        const bool is_straight = angle_between(edges.first, -edges.second) <= radians(feature_angle);
        return is_straight ? VertexFeature::ridge : VertexFeature::corner;
    }
    return rank == 2 ? VertexFeature::ridge : VertexFeature::smooth;
}

}  // namespace dsc::surface
