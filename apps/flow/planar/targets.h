// SPDX-License-Identifier: GPL-3.0-or-later
// From the motion asked for to the targets of a step in the plane. Source: thesis 4.4.1. Guarantee: a rotation turns
// each vertex by the angle of the step; velocities are integrated by one Runge-Kutta step of order 4; curvature flow
// and offsets as dsc2d/curve says. Cost: linear in the mesh.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "apps/flow/planar/options.h"
#include "dsc2d/complex.h"

namespace dsc::flow::planar {

/// Where vertices of the interface have to be at time + dt: indexed by vertex, missing ones stay.
using Targets =
    std::function<std::vector<std::optional<Point2>>(const dsc2d::Complex& complex, double time, double dt)>;

/// `until`: time over which a rotation makes its angle, and an offset its distance. Throws core::InputError for
/// expressions that can't be read.
Targets motion_targets(const MotionOptions& motion, const Eigen::AlignedBox2d& domain, double edge_length,
                       double until);

}  // namespace dsc::flow::planar
