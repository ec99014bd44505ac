// SPDX-License-Identifier: GPL-3.0-or-later
// The run of the program fluid: steps until the time is over, each measured. Guarantee: a step that fails is tried
// again with half of its length, and what still fails ends the run with the last good state and the reason. The same
// bits for the same input.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/fluid/checkpoint.h"
#include "apps/fluid/series.h"
#include "apps/fluid/step_record.h"
#include "core/observer.h"

namespace dsc::fluid_app {

struct RunParameters {
    double until = 1;
    std::optional<double> dt;  ///< fixed; else as long as the limits allow
    std::optional<int> steps;  ///< at most
    int halvings = 6;          ///< of a step that fails
};

enum class RunEnd { done, vanished, stopped, cancelled };

struct RunResult {
    std::vector<StepRecord> steps;
    std::vector<Event> events;
    RunEnd end = RunEnd::done;
    std::string reason = "done";
    double seconds = 0;
};

/// From the last of `checkpoints`, if it has one, with what is in `result` and `series` up to there; else from `start`.
/// Returns the mesh at the end.
geometry::TetData run_fluid(const TrackedState& start, const TrackedParameters& parameters, const RunParameters& run,
                            Series& series, Checkpoints* checkpoints, core::Observer& observer, RunResult& result);

}  // namespace dsc::fluid_app
