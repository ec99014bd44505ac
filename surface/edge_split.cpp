// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/edge_split.h"

#include "core/require.h"
#include "surface/features.h"
#include "surface/triangle.h"

namespace dsc::surface {

namespace {

// What the end of a cubic adds to the middle of its chord, by its tangent there: an eighth of the tangent, as long as
// the chord, minus the chord.
Vector3 bulge(const OneRing& ring, const Point3& end, double feature_angle) {
    const Vector3 chord = end - ring.centre;
    const VertexQuadric quadric = vertex_quadric(ring);
    switch (vertex_feature(ring, quadric, feature_angle)) {
        case VertexFeature::smooth: {
            const Vector3 normal = quadric.mean_normal.normalized();
            return -chord.dot(normal) / 8 * normal;
        }
        case VertexFeature::ridge: {
            const std::optional<Point3> before = other_feature_end(ring, end, feature_angle);
            if (!before || !is_feature_edge(ring, end, feature_angle)) return Vector3::Zero();
            return ((end - *before).normalized() * chord.norm() - chord) / 8;
        }
        case VertexFeature::corner: break;
    }
    return Vector3::Zero();
}

}  // namespace

void SplitParameters::validate() const {
    core::require(feature_angle > 0 && feature_angle < 90, "feature_angle", "in (0, 90)");
}

Point3 split_position(const OneRing& a, const OneRing& b, const SplitParameters& parameters) {
    return 0.5 * (a.centre + b.centre) + bulge(a, b.centre, parameters.feature_angle) +
           bulge(b, a.centre, parameters.feature_angle);
}

}  // namespace dsc::surface
