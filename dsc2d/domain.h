// SPDX-License-Identifier: GPL-3.0-or-later
// The domain of a 2D complex: a planar box, a flat torus (any lattice), or a cylinder (periodic in one direction).
//
// All coordinates and lattice vectors lie on a dyadic grid of spacing quantum() = 2^(e-46), 2^e being the size of the
// domain rounded up to a power of two. Inside is_in_reach() (64 domain sizes) sums and differences of coordinates and
// translations by lattice vectors are therefore exact in double precision, and the exact orientation of a face does not
// depend on the corner or on the period it is computed in.
//
// Source: thesis 5.2.1 ("torus topology"), 5.2.4. Cost: a value of about 100 bytes; every query is constant.
#pragma once

#include <Eigen/Core>

#include "geometry/predicates.h"

namespace dsc::dsc2d {

using geometry::Point2;
using LatticeVector = Eigen::Vector2i;

class Domain {
public:
    /// The rectangle between two corners; throws core::UsageError unless lower < upper in both coordinates.
    static Domain box(const Point2& lower, const Point2& upper);
    /// The plane modulo the lattice whose basis are the columns of `periods`; throws core::UsageError unless their
    /// determinant is positive.
    static Domain torus(const Eigen::Matrix2d& periods, const Point2& origin = Point2::Zero());
    /// The strip origin + s period + t extent, t in [0, 1], periodic in s; throws core::UsageError unless
    /// det(period, extent) > 0.
    static Domain cylinder(const Point2& period, const Point2& extent, const Point2& origin = Point2::Zero());

    /// The domain is the parallelogram origin() + s basis().col(0) + t basis().col(1), s and t in [0, 1].
    const Point2& origin() const { return origin_; }
    const Eigen::Matrix2d& basis() const { return basis_; }
    /// True when the domain repeats itself along column 0 or 1 of the basis.
    bool is_periodic(int direction) const { return direction == 0 ? is_periodic_0_ : is_periodic_1_; }
    bool has_boundary() const { return !is_periodic_0_ || !is_periodic_1_; }
    double area() const;

    /// Cover translation of a lattice vector; the components of non-periodic directions must be zero.
    Point2 translation(const LatticeVector& cell) const {
        if (cell.x() == 0 && cell.y() == 0) return Point2::Zero();
        return {basis_(0, 0) * cell.x() + basis_(0, 1) * cell.y(), basis_(1, 0) * cell.x() + basis_(1, 1) * cell.y()};
    }

    double quantum() const { return quantum_; }
    /// Nearest grid point; precondition: is_in_reach(p).
    Point2 snapped(const Point2& p) const {
        return {(p.x() + rounder_) - rounder_, (p.y() + rounder_) - rounder_};
    }
    bool is_in_reach(const Point2& p) const { return p.cwiseAbs().maxCoeff() <= reach_; }

private:
    Domain(const Point2& origin, const Eigen::Matrix2d& basis, bool is_periodic_0, bool is_periodic_1);

    Point2 origin_;
    Eigen::Matrix2d basis_;
    double quantum_;
    double rounder_;
    double reach_;
    bool is_periodic_0_;
    bool is_periodic_1_;
};

}  // namespace dsc::dsc2d
