// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/vertex_quadric.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "surface/triangle.h"

namespace dsc::surface {

VertexQuadric vertex_quadric(const OneRing& ring) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    Vector3 normals = Vector3::Zero();
    double weights = 0;
    for (const RingTriangle& triangle : ring.triangles) {
        const Vector3 normal = unit_normal(ring.centre, triangle.a, triangle.b);
        if (normal.isZero(0)) continue;
        const double angle = angle_between(triangle.a - ring.centre, triangle.b - ring.centre);
        sum += angle * normal * normal.transpose();
        normals += angle * normal;
        weights += angle;
    }
    if (!(weights > 0)) return {};
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(Eigen::Matrix3d(sum / weights));
    return {solver.eigenvalues().reverse(), solver.eigenvectors().rowwise().reverse(), normals / weights};
}

int VertexQuadric::rank(double feature_angle) const {
    if (!(values[0] > 0)) return 0;
    const double half = radians(feature_angle) / 2;
    const double ratio = std::tan(half) * std::tan(half);
    if (values[2] > ratio * values[0]) return 3;
    const bool is_smooth = values[1] <= ratio * values[0] && std::abs(mean_normal.dot(vector(0))) >= std::cos(half);
    return is_smooth ? 1 : 2;
}

}  // namespace dsc::surface
