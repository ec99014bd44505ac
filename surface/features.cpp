// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/features.h"

#include <algorithm>

#include "surface/triangle.h"

namespace dsc::surface {

namespace {

/// The edges at the centre that are features; of the first two the directions.
struct FeatureEdges {
    int count = 0;
    Vector3 first = Vector3::Zero();
    Vector3 second = Vector3::Zero();
};

class FeatureFinder {
public:
    FeatureFinder(const OneRing& ring, double feature_angle) : ring_(ring), angle_(radians(feature_angle)) {}

    FeatureEdges feature_edges() const {
        FeatureEdges edges;
        for (std::size_t i = 0; i < ring_.triangles.size(); ++i) {
            for (const Point3& end : {ring_.triangles[i].a, ring_.triangles[i].b}) {
                if (!is_in_earlier_triangle(end, i) && is_feature(end)) add(edges, end - ring_.centre);
            }
        }
        return edges;
    }

private:
    static bool has(const RingTriangle& triangle, const Point3& end) { return triangle.a == end || triangle.b == end; }

    static void add(FeatureEdges& edges, const Vector3& direction) {
        if (edges.count == 0) edges.first = direction;
        if (edges.count == 1) edges.second = direction;
        ++edges.count;
    }

    bool is_in_earlier_triangle(const Point3& end, std::size_t i) const {
        return std::ranges::any_of(ring_.triangles.first(i), [&](const RingTriangle& t) { return has(t, end); });
    }

    bool is_feature(const Point3& end) const {
        int count = 0;
        Vector3 normals[2];
        for (const RingTriangle& triangle : ring_.triangles) {
            if (!has(triangle, end)) continue;
            if (++count > 2) return true;
            // Turned so that the edge goes the same way round in both, whatever their orientation.
            const Vector3 normal = unit_normal(ring_.centre, triangle.a, triangle.b);
            normals[count - 1] = (triangle.a == end) == (count == 1) ? normal : Vector3(-normal);
        }
        return count != 2 || angle_between(normals[0], normals[1]) > angle_;
    }

    const OneRing& ring_;
    double angle_;
};

}  // namespace

double bend(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    return angle_between(unit_normal(a, b, c), unit_normal(b, a, d)) / radians(1);
}

bool is_feature_edge(const Point3& a, const Point3& b, const Point3& c, const Point3& d, double feature_angle) {
    return bend(a, b, c, d) > feature_angle;
}

VertexFeature vertex_feature(const OneRing& ring, const VertexQuadric& quadric, double feature_angle) {
    const int rank = quadric.rank(feature_angle);
    if (rank == 3) return VertexFeature::corner;
    const FeatureEdges edges = FeatureFinder(ring, feature_angle).feature_edges();
    if (edges.count >= 3) return VertexFeature::corner;
    if (edges.count == 2) {
        const bool is_straight = angle_between(edges.first, -edges.second) <= radians(feature_angle);
        return is_straight ? VertexFeature::ridge : VertexFeature::corner;
    }
    return rank == 2 ? VertexFeature::ridge : VertexFeature::smooth;
}

}  // namespace dsc::surface
