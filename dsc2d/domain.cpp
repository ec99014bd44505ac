// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/domain.h"

#include <algorithm>
#include <cmath>

#include "core/errors.h"
#include "geometry/triangle.h"

namespace dsc::dsc2d {

namespace {

constexpr int grid_bits = 46;
constexpr double reach_in_sizes = 64.0;

}  // namespace

Domain::Domain(const Point2& origin, const Eigen::Matrix2d& basis, bool is_periodic_0, bool is_periodic_1)
    : origin_(origin), basis_(basis), is_periodic_0_(is_periodic_0), is_periodic_1_(is_periodic_1) {
    if (!origin.allFinite() || !basis.allFinite()) throw core::UsageError("domain: not finite");
    if (!(geometry::cross(basis.col(0), basis.col(1)) > 0.0))
        throw core::UsageError("domain: the two basis vectors must have a positive determinant");
    const double extent = std::max({origin.cwiseAbs().maxCoeff(), (origin + basis.col(0)).cwiseAbs().maxCoeff(),
                                    (origin + basis.col(1)).cwiseAbs().maxCoeff(), basis.cwiseAbs().maxCoeff(),
                                    (origin + basis.col(0) + basis.col(1)).cwiseAbs().maxCoeff()});
    int exponent = 0;
    std::frexp(extent, &exponent);
    quantum_ = std::ldexp(1.0, exponent - grid_bits);
    rounder_ = std::ldexp(1.5, exponent - grid_bits + 52);
    reach_ = reach_in_sizes * std::ldexp(1.0, exponent - 1);
    origin_ = snapped(origin);
    basis_.col(0) = snapped(basis.col(0));
    basis_.col(1) = snapped(basis.col(1));
}

Domain Domain::box(const Point2& lower, const Point2& upper) {
    if (!(lower.x() < upper.x() && lower.y() < upper.y()))
        throw core::UsageError("domain: the lower corner of a box must lie below and left of its upper corner");
    Eigen::Matrix2d sides = Eigen::Matrix2d::Zero();
    sides.diagonal() = upper - lower;
    return {lower, sides, false, false};
}

Domain Domain::torus(const Eigen::Matrix2d& periods, const Point2& origin) { return {origin, periods, true, true}; }

Domain Domain::cylinder(const Point2& period, const Point2& extent, const Point2& origin) {
    Eigen::Matrix2d basis;
    basis << period, extent;
    return {origin, basis, true, false};
}

double Domain::area() const { return geometry::cross(basis_.col(0), basis_.col(1)); }

}  // namespace dsc::dsc2d
