// SPDX-License-Identifier: GPL-3.0-or-later
// From --dt, --until and --steps to the steps of a run. Guarantee: times are computed from the number of the step, so
// that they don't drift and a resumed run has the same ones; the last step ends at `until` exactly.
#pragma once

#include "apps/flow/options.h"

namespace dsc::flow {

struct TimeSteps {
    double dt = 0;  ///< of every step but the last one, which may be shorter
    double until = 0;
    int count = 0;

    double time(int step) const { return step >= count ? until : dt * step; }
};

/// What was not given follows from what was, and from the motion: rotation, offset and translation end at time 1,
/// enright and vortex after one period, curvature flow and expressions at 1; 50 steps. Throws core::UsageError for more
/// than 10^7 steps, and for rotations by more than a full turn in one.
TimeSteps time_steps(const TimeOptions& options, const MotionOptions& motion);

}  // namespace dsc::flow
