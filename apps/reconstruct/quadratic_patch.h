// SPDX-License-Identifier: GPL-3.0-or-later
// The patch z = a + bu + cv + du^2 + euv + fv^2 over a plane, by weighted least squares.
// Source: Levin (2004), "Mesh-independent surface interpolation"; standard error of its height as of any linear
// estimate. Guarantee: the same bits for the same points in the same order. Cost: some 50 ns per point.
#pragma once

#include <Eigen/Core>

#include "geometry/predicates.h"

namespace dsc::reconstruct {

using geometry::Point3;
using Vector3 = Eigen::Vector3d;

class QuadraticPatch {
public:
    /// Over the plane through `origin` with the unit normal `normal`; `reach`, the unit of length inside, is how far
    /// away the points are; > 0.
    QuadraticPatch(const Point3& origin, const Vector3& normal, double reach);

    /// Points count exp(-2 d^2) at distance d in units of the reach.
    void add(const Point3& p);
    int points() const { return points_; }
    /// Slopes and curvatures cost what as many points off by `slope` and `curvature` would: few or noisy points then
    /// make a plane rather than a wild patch. Once all points are there; >= 0.
    void stiffen(double slope, double curvature);
    /// The patch of the points. Precondition: at least 3 points, or stiffness.
    void solve();

    /// Where the patch is above the origin.
    Point3 point() const { return origin_ + reach_ * patch_[0] * normal_; }
    Vector3 normal() const { return (normal_ - patch_[1] * u_ - patch_[2] * v_).normalized(); }
    /// Standard error of point() along the normal, for points that are off by 1 on average and independent.
    double standard_error() const;

private:
    using Vector6 = Eigen::Matrix<double, 6, 1>;
    using Matrix6 = Eigen::Matrix<double, 6, 6>;

    Point3 origin_;
    Vector3 normal_, u_, v_;
    double reach_;
    int points_ = 0;
    double weights_ = 0;
    Matrix6 matrix_ = Matrix6::Zero(), squares_ = Matrix6::Zero();  ///< moments by weight and by squared weight
    Vector6 right_ = Vector6::Zero(), patch_ = Vector6::Zero();
};

}  // namespace dsc::reconstruct
