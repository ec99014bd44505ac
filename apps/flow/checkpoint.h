// SPDX-License-Identifier: GPL-3.0-or-later
// A flow up to a step, as a file from which it goes on bit for bit.
// Steps depend on more than the mesh: on the order of handles, on what was tried before, on random numbers. The run
// therefore makes its mesh and its deformer again from the state below each time it comes to a checkpoint, whether it
// is read back or not: then an undisturbed run and one that goes on pass through the same states. Guarantee: the file
// is replaced whole or not at all; numbers are kept exactly; a damaged file is refused. Cost: linear in the mesh, the
// records and the snapshots so far; writing takes a twentieth of the time at most.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "apps/flow/report.h"
#include "apps/flow/snapshots.h"
#include "core/stopwatch.h"
#include "geometry/tet_data.h"
#include "io/json.h"

namespace dsc::flow {

/// What the steps that follow depend on, beside the options.
struct RunState {
    int step = 0;
    double seconds = 0;  ///< of the run so far
    geometry::TetData tets;
    std::vector<double> edge_lengths;  ///< wanted at the vertices
    UnchangedTriangles::State unchanged;
};

struct SavedRun {
    io::Json options;  ///< on the command line it was started with
    RunState state;
    FlowResult result;  ///< up to the state, without its times
    std::vector<Snapshots::Frame> frames;
};

std::filesystem::path checkpoint_path(const std::filesystem::path& folder);

/// Of `result` and `snapshots` what is not later than the state. Throws core::InputError and core::RunError when the
/// file can't be written.
void write_checkpoint(const std::filesystem::path& path, const io::Json& options, const RunState& state,
                      const FlowResult& result, const Snapshots& snapshots);

/// Throws core::InputError when there is no checkpoint, or it is damaged, or of another version of the program.
SavedRun read_checkpoint(const std::filesystem::path& path);

/// The checkpoints of one run, which replace each other.
class Checkpoints {
public:
    /// `interval`: steps from one to the next, > 0. `options`: of the command line, to be kept.
    Checkpoints(std::filesystem::path path, io::Json options, int interval);

    /// The last one; none before the first.
    const std::optional<RunState>& state() const { return state_; }
    /// That of the file from which the run goes on.
    void restore(RunState state);

    /// Whether the run has to make itself again before the step after this one.
    bool is_due(int step) const;
    /// Takes the state of the run. Writes it when that does not cost too much time, or there is none in the file yet.
    void take(RunState state, const FlowResult& result, const Snapshots& snapshots);
    /// Writes the last one unless that is done: at the end, and when a run is interrupted.
    void save(const FlowResult& result, const Snapshots& snapshots);

private:
    std::filesystem::path path_;
    io::Json options_;
    int interval_;
    std::optional<RunState> state_;
    bool is_saved_ = false;
    std::optional<core::Stopwatch> since_saved_;
    double seconds_to_save_ = 0;
};

}  // namespace dsc::flow
