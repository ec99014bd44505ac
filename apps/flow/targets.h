// SPDX-License-Identifier: GPL-3.0-or-later
// From the motion asked for to the targets of a step. Source: thesis 4.4.1. Guarantee: a rotation turns each vertex
// by the angle of the step; velocities are integrated by one Runge-Kutta step of order 4. Cost: linear
// in the mesh, but for curvature flow, which solves a sparse system over the interface.
#pragma once

#include "apps/flow/flow.h"
#include "apps/flow/options.h"

namespace dsc::flow {

/// `until`: time over which a rotation makes its angle, and an offset its distance. Throws core::InputError for
/// expressions that can't be read.
Targets motion_targets(const MotionOptions& motion, const Eigen::AlignedBox3d& domain, double until);

}  // namespace dsc::flow
