// SPDX-License-Identifier: GPL-3.0-or-later
// A fluid up to a step, from which it goes on bit for bit: see apps/common/checkpoints.h.
#pragma once

#include "apps/common/checkpoints.h"
#include "apps/fluid/series.h"
#include "apps/fluid/step_record.h"
#include "geometry/data_fields.h"

namespace dsc::fluid_app {

inline constexpr apps::CheckpointKind checkpoint_kind{"fluid", 2};

template <class Visitor, core::ConstOrNot<TrackedState> Value>
void fields(Visitor& visitor, Value& state) {
    auto& [tets, velocities, pressures, parts, kept_volumes, edge_lengths] = state;
    visitor(tets, velocities, pressures, parts, kept_volumes, edge_lengths);
}

/// What the steps that follow depend on, beside the options.
struct RunState {
    int step = 0;
    double time = 0;
    double seconds = 0;      ///< of the run so far
    double edge_length = 0;  ///< of the surface at the start
    TrackedState fluid;
};

template <class Visitor, core::ConstOrNot<RunState> Value>
void fields(Visitor& visitor, Value& run) {
    auto& [step, time, seconds, edge_length, fluid] = run;
    visitor(step, time, seconds, edge_length, fluid);
}

using SavedRun = apps::SavedRun<RunState, StepRecord, Event, Frame>;
using Checkpoints = apps::Checkpoints<SavedRun>;

}  // namespace dsc::fluid_app
