// SPDX-License-Identifier: GPL-3.0-or-later
// A run's state in a file, from which it goes on bit for bit. Guarantee: the run makes itself again from each state it
// takes, so that a run that goes on makes the same steps; a file is whole or absent, and one that is damaged is
// refused.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "apps/fluid/series.h"
#include "apps/fluid/step_record.h"
#include "io/json.h"

namespace dsc::fluid_app {

struct RunState {
    int step = 0;
    double time = 0;
    double seconds = 0;
    TrackedState fluid;
};

struct SavedRun {
    io::Json options;
    double edge_length = 0;  ///< of the surface at the start
    RunState state;
    std::vector<StepRecord> steps;
    std::vector<Event> events;
    std::vector<Frame> frames;
};

std::filesystem::path checkpoint_path(const std::filesystem::path& folder);

/// Throws core::InputError when there is no checkpoint, or it is damaged, or of another version of the program.
SavedRun read_checkpoint(const std::filesystem::path& path);

class Checkpoints {
public:
    /// `interval`: steps from one to the next, > 0. `options`: of the command line, to be kept.
    Checkpoints(std::filesystem::path path, io::Json options, double edge_length, int interval);

    const std::optional<RunState>& state() const { return state_; }
    void restore(RunState state) { state_ = std::move(state); }
    bool is_due(int step) const { return step % interval_ == 0 && !(state_ && state_->step == step); }
    /// Takes the state and writes it.
    void take(RunState state, const std::vector<StepRecord>& steps, const std::vector<Event>& events,
              const std::vector<Frame>& frames);

private:
    std::filesystem::path path_;
    io::Json options_;
    double edge_length_;
    int interval_;
    std::optional<RunState> state_;
};

}  // namespace dsc::fluid_app
