// SPDX-License-Identifier: GPL-3.0-or-later
// From --resume to the run that goes on: its options are those of its checkpoint.
#pragma once

#include <utility>

#include "apps/flow/options.h"
#include "io/json.h"

namespace dsc::flow {

/// The options the run was started with, but for where its results go and what is printed meanwhile: those are of the
/// command that resumes. Throws core::UsageError when anything else on that command line is not as at the start.
Options resumed_options(const io::Json& at_start, const Options& resuming);

/// Gives a run that goes on what it has left behind, in space or in the plane.
template <class Saved, class Result, class Snapshots, class Checkpoints>
void take_over(Saved saved, Result& result, Snapshots& snapshots, Checkpoints& checkpoints) {
    result.steps = std::move(saved.steps);
    result.events = std::move(saved.events);
    result.seconds = saved.state.seconds;
    for (auto& frame : saved.frames) snapshots.restore(std::move(frame));
    checkpoints.restore(std::move(saved.state));
}

}  // namespace dsc::flow
