// SPDX-License-Identifier: GPL-3.0-or-later
// The checkpoints of a run, from which it goes on bit for bit.
// Steps depend on more than what a file can hold: on what was tried before, on random numbers. The run therefore makes
// itself again from its state each time it comes to a checkpoint, whether it is read back or not: then an undisturbed
// run and one that goes on pass through the same states. Guarantee: a file is replaced whole or not at all. Cost:
// linear in the state and in the history so far; writing takes a twentieth of the time at most.
//
//     if (checkpoints.is_due(step)) {
//         checkpoints.take(state(), {records, events, frames});
//         make_again(*checkpoints.state());
//     }
#pragma once

#include <algorithm>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "apps/common/checkpoint_file.h"
#include "core/assert.h"
#include "core/fields.h"
#include "core/stopwatch.h"
#include "io/json.h"

namespace dsc::apps {

/// A run up to a step. `RunState` is what the steps that follow depend on, beside the options; it has a member `step`.
/// Records, events and frames are what the run has left behind.
template <class RunState, class StepRecord, class RunEvent, class SeriesFrame>
struct SavedRun {
    using State = RunState;
    using Record = StepRecord;
    using Event = RunEvent;
    using Frame = SeriesFrame;

    State state;
    std::vector<Record> steps;
    std::vector<Event> events;
    std::vector<Frame> frames;
};

template <class Visitor, class State, class Record, class Event, class Frame>
void fields(Visitor& visitor, SavedRun<State, Record, Event, Frame>& run) {
    auto& [state, steps, events, frames] = run;
    visitor(state, steps, events, frames);
}

/// Those of one run, which replace each other.
template <class Saved>
class Checkpoints {
public:
    using State = typename Saved::State;
    /// What a run has left behind, which grows at its ends.
    struct History {
        std::span<const typename Saved::Record> steps;
        std::span<const typename Saved::Event> events;
        std::span<const typename Saved::Frame> frames;
    };

    /// `interval`: steps from one to the next; 0: there are none. `options`: of the command line, to be kept.
    Checkpoints(std::filesystem::path path, const CheckpointKind& kind, io::Json options, int interval)
        : path_(std::move(path)), kind_(kind), options_(std::move(options)), interval_(interval) {}

    /// The last one; none before the first.
    const std::optional<State>& state() const { return state_; }

    /// That of the file from which the run goes on.
    void restore(State state) {
        state_ = std::move(state);
        is_saved_ = true;
        since_saved_.emplace();
    }

    /// Whether the run has to make itself again before the step after this one.
    bool is_due(int step) const { return interval_ > 0 && step % interval_ == 0 && !(state_ && state_->step == step); }

    /// Takes the state of the run. Writes it when that does not cost too much time, or there is none in the file yet.
    void take(State state, const History& history) {
        state_ = std::move(state);
        record_count_ = history.steps.size();
        event_count_ = history.events.size();
        frame_count_ = history.frames.size();
        is_saved_ = false;
        if (!since_saved_ || since_saved_->seconds() > least_pause * seconds_to_save_) save(history);
    }

    /// Writes the last one, with the history up to there, unless that is done: at the end, and when a run is
    /// interrupted.
    void save(const History& history) {
        if (is_saved_ || !state_) return;
        const core::Stopwatch watch;
        const auto steps = history.steps.first(record_count_);
        const auto events = history.events.first(event_count_);
        const auto frames = history.frames.first(frame_count_);
        motion::FieldWriter run;
        run(*state_, steps, events, frames);
        write_checkpoint(path_, kind_, options_, run);
        seconds_to_save_ = watch.seconds();
        is_saved_ = true;
        since_saved_.emplace();
    }

private:
    static constexpr double least_pause = 20;  // between two savings, in times that one takes

    std::filesystem::path path_;
    CheckpointKind kind_;
    io::Json options_;
    int interval_;
    std::optional<State> state_;
    std::size_t record_count_ = 0, event_count_ = 0, frame_count_ = 0;
    bool is_saved_ = false;
    std::optional<core::Stopwatch> since_saved_;
    double seconds_to_save_ = 0;
};

}  // namespace dsc::apps
