// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/curvature.h"

#include <cmath>
#include <numbers>

#include "surface/triangle.h"

namespace dsc::surface {

double Curvature::max_principal() const { return mean() + std::sqrt(std::max(0.0, mean() * mean() - gaussian)); }

CotangentTriangle cotangents(const Point3& centre, const Point3& p, const Point3& q) {
    const Vector3 cp = p - centre, cq = q - centre, pq = q - p;
    const double twice_area = cp.cross(cq).norm();
    if (!(twice_area > 0)) return {};
    const double dot_centre = cp.dot(cq), dot_p = -cp.dot(pq), dot_q = cq.dot(pq);
    const double cot_p = dot_p / twice_area, cot_q = dot_q / twice_area;
    const double mixed_area = dot_centre < 0           ? twice_area / 4
                              : dot_p < 0 || dot_q < 0 ? twice_area / 8
                                                       : (cp.squaredNorm() * cot_q + cq.squaredNorm() * cot_p) / 8;
    return {cot_p, cot_q, mixed_area, std::atan2(twice_area, dot_centre)};
}

Curvature curvature(const OneRing& ring) {
    Vector3 pull = Vector3::Zero();
    double area = 0, weights = 0, angles = 0;
    for (const RingTriangle& triangle : ring.triangles) {
        const CotangentTriangle t = cotangents(ring.centre, triangle.a, triangle.b);
        // The cotangent at one end weighs the edge to the other one.
        pull += t.cot_q * (triangle.a - ring.centre) + t.cot_p * (triangle.b - ring.centre);
        weights += std::abs(t.cot_p) + std::abs(t.cot_q);
        area += t.mixed_area;
        angles += t.angle;
    }
    if (!(area > 0)) return {Vector3::Zero(), 0, 0, 0};
    return {pull / (2 * area), (2 * std::numbers::pi - angles) / area, area, weights / (2 * area)};
}

}  // namespace dsc::surface
