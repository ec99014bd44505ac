// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/curve/edge_offsetting.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "core/errors.h"

namespace dsc::dsc2d {

void OffsetParameters::validate() const {
    if (!(feature_angle > 0 && feature_angle < 90)) throw core::UsageError("feature_angle: has to be in (0, 90)");
    if (!(max_stretch >= 1)) throw core::UsageError("max_stretch: has to be at least 1");
}

std::vector<Point2> offset_displacements(const Interface& interface, double distance,
                                         const OffsetParameters& parameters) {
    parameters.validate();
    struct Quadric {
        Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
        Point2 right = Point2::Zero();
    };
    std::vector<Quadric> quadrics(interface.vertices.size());
    for (const InterfaceSegment& s : interface.segments) {
        const Point2 normal = Point2(s.vector.y(), -s.vector.x()).normalized();
        for (const std::uint32_t v : {s.a, s.b}) {
            quadrics[v].matrix += normal * normal.transpose();
            quadrics[v].right += distance * normal;
        }
    }
    // The eigenvalues of two normals at an angle have the ratio of the squared tangent of its half.
    const double half = parameters.feature_angle / 2 * std::numbers::pi / 180;
    const double cutoff = std::tan(half) * std::tan(half);
    const double longest = parameters.max_stretch * std::abs(distance);
    std::vector<Point2> steps;
    steps.reserve(quadrics.size());
    for (const Quadric& quadric : quadrics) {
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(quadric.matrix);
        Point2 step = Point2::Zero();
        for (int k = 0; k < 2; ++k) {
            if (!(eigen.eigenvalues()[k] > cutoff * eigen.eigenvalues()[1])) continue;
            const Point2 direction = eigen.eigenvectors().col(k);
            step += direction * (direction.dot(quadric.right) / eigen.eigenvalues()[k]);
        }
        const double length = step.norm();
        steps.push_back(length > longest ? Point2(step * (longest / length)) : step);
    }
    return steps;
}

}  // namespace dsc::dsc2d
