// SPDX-License-Identifier: GPL-3.0-or-later
// The solid around a scene: the sides of a box, or a hollow sphere. Where it is, which way its walls face, and what the
// deformation has to know of them. Cost of a call: constant.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "apps/fluid/scene.h"
#include "dsc3d/operations/wall.h"
#include "fluid/free_coordinates.h"

namespace dsc::fluid_app {

class Container {
public:
    explicit Container(const Scene& scene);

    /// Up to rounding.
    bool contains(const Point3& p) const;
    /// For every wall that the vertex is on, one contact at rest: two at an edge of a box, three at its corners.
    void add_contacts(std::uint32_t vertex, const Point3& p, std::vector<fluid::WallContact<3>>& contacts) const;
    /// For every wall that the vertex, which is on none, would go through within dt at this velocity: a contact that
    /// stops it there.
    void add_arrivals(std::uint32_t vertex, const Point3& p, const Point3& velocity, double dt,
                      std::vector<fluid::WallContact<3>>& contacts) const;
    /// Where something that moves along the walls from the inside comes to be: a tangent of a curved one leads out.
    Point3 kept_inside(const Point3& p) const;
    /// The curved ones.
    dsc3d::Walls walls() const;

private:
    // take(number, distance, outward normal)
    template <class Take>
    void for_each_wall(const Point3& p, Take&& take) const;

    Eigen::AlignedBox3d box_;
    std::shared_ptr<const dsc3d::SphereWall> sphere_;  ///< instead of the box, if any
    double tolerance_;                                 ///< distance at which a place is on a wall
};

}  // namespace dsc::fluid_app
