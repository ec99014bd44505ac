// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/face_offsetting.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"
#include "core/require.h"
#include "surface/triangle.h"

namespace dsc::surface {

namespace {

template <class Distance>
Vector3 displacement(const OneRing& ring, const Distance& distance, const OffsetParameters& parameters) {
    const VertexQuadric quadric = vertex_quadric(ring);
    Vector3 right = Vector3::Zero();
    double weights = 0, largest = 0;
    for (std::size_t i = 0; i < ring.triangles.size(); ++i) {
        const RingTriangle& t = ring.triangles[i];
        const Vector3 normal = unit_normal(ring.centre, t.a, t.b);
        if (normal.isZero(0)) continue;
        const double angle = angle_between(t.a - ring.centre, t.b - ring.centre);
        right += angle * distance(i) * normal;
        weights += angle;
        largest = std::max(largest, std::abs(distance(i)));
    }
    if (!(weights > 0)) return Vector3::Zero();
    right /= weights;

    Vector3 step = Vector3::Zero();
    const int rank = quadric.rank(parameters.feature_angle);
    for (int k = 0; k < rank; ++k) step += quadric.vector(k) * (quadric.vector(k).dot(right) / quadric.values[k]);
    const double length = step.norm(), longest = parameters.max_stretch * largest;
    return length > longest ? Vector3(step * (longest / length)) : step;
}

}  // namespace

void OffsetParameters::validate() const {
    core::require(feature_angle > 0 && feature_angle < 90, "feature_angle", "in (0, 90)");
    core::require(max_stretch >= 1, "max_stretch", "at least 1");
}

Vector3 offset_displacement(const OneRing& ring, std::span<const double> distances,
                            const OffsetParameters& parameters) {
    DSC_ASSERT(distances.size() == ring.triangles.size());
    return displacement(
        ring, [&](std::size_t i) { return distances[i]; }, parameters);
}

Vector3 offset_displacement(const OneRing& ring, double distance, const OffsetParameters& parameters) {
    return displacement(
        ring, [&](std::size_t) { return distance; }, parameters);
}

}  // namespace dsc::surface
