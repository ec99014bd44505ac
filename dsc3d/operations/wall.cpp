// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/wall.h"

#include <cmath>

#include "core/errors.h"

namespace dsc::dsc3d {

SphereWall::SphereWall(const Point3& centre, double radius) : centre_(centre), radius_(radius) {
    if (!(radius > 0) || !std::isfinite(radius) || !centre.allFinite())
        throw core::UsageError("a spherical wall has to have a finite centre and a positive radius");
}

Eigen::Vector3d SphereWall::normal(const Point3& p) const {
    const Eigen::Vector3d out = p - centre_;
    const double distance = out.norm();
    return distance > 0 ? Eigen::Vector3d(out / distance) : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
}

}  // namespace dsc::dsc3d
