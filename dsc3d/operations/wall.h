// SPDX-License-Identifier: GPL-3.0-or-later
// A curved wall of the domain: where its vertices are put when they slide, or when an edge on it is halved. Flat walls
// need none: FlatSurface finds them. Source: not in the thesis; Misztal et al., "Multiphase flow of immiscible fluids
// on unstructured moving meshes" (2012), moves contact lines on fixed solids. Guarantee: const calls may come from
// several threads. Cost: one projection.
//
//     const auto vessel = std::make_shared<SphereWall>(Point3(0, 0, 0), 0.5);
//     Deformer deformer(mesh, {.edge_length = 0.02}, listener, {vessel});
#pragma once

#include <memory>
#include <vector>

#include "geometry/predicates.h"

namespace dsc::dsc3d {

using geometry::Point3;

class Wall {
public:
    virtual ~Wall() = default;

    /// The place on the wall that is nearest to p: p itself up to rounding when it lies on the wall.
    virtual Point3 nearest(const Point3& p) const = 0;
    /// Of unit length, at the place nearest to p; to either side.
    virtual Eigen::Vector3d normal(const Point3& p) const = 0;
};

using Walls = std::vector<std::shared_ptr<const Wall>>;

class SphereWall final : public Wall {
public:
    /// Throws core::UsageError when the radius is not positive.
    SphereWall(const Point3& centre, double radius);

    const Point3& centre() const { return centre_; }
    double radius() const { return radius_; }
    /// Of the centre any place of the sphere.
    Point3 nearest(const Point3& p) const override { return centre_ + radius_ * normal(p); }
    Eigen::Vector3d normal(const Point3& p) const override;

private:
    Point3 centre_;
    double radius_;
};

}  // namespace dsc::dsc3d
