// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/quadratic_patch.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <cmath>

namespace dsc::reconstruct {

namespace {

// A unit vector perpendicular to n.
Vector3 perpendicular(const Vector3& n) {
    Eigen::Index least = 0;
    n.cwiseAbs().minCoeff(&least);
    return n.cross(Vector3::Unit(least)).normalized();
}

}  // namespace

QuadraticPatch::QuadraticPatch(const Point3& origin, const Vector3& normal, double reach)
    : origin_(origin), normal_(normal), u_(perpendicular(normal)), v_(normal.cross(u_)), reach_(reach) {}

void QuadraticPatch::add(const Point3& p) {
    const Vector3 way = (p - origin_) / reach_;
    const double s = way.dot(u_), t = way.dot(v_);
    const double weight = std::exp(-2 * way.squaredNorm());
    Vector6 row;
    row << 1, s, t, s * s, s * t, t * t;
    const Matrix6 product = weight * row * row.transpose();
    matrix_ += product;
    squares_ += weight * product;
    right_ += weight * way.dot(normal_) * row;
    weights_ += weight;
    ++points_;
}

void QuadraticPatch::stiffen(double slope, double curvature) {
    for (int k = 1; k < 3; ++k) matrix_(k, k) += slope * weights_;
    for (int k = 3; k < 6; ++k) matrix_(k, k) += curvature * weights_;
}

void QuadraticPatch::solve() { patch_ = matrix_.ldlt().solve(right_); }

double QuadraticPatch::standard_error() const {
    const Vector6 influence = matrix_.ldlt().solve(Vector6::Unit(0));
    return std::sqrt(influence.dot(squares_ * influence));
}

}  // namespace dsc::reconstruct
