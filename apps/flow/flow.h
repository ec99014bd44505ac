// SPDX-License-Identifier: GPL-3.0-or-later
// The run of the program flow: steps of motion and deformation, each measured, until the time is over.
// Guarantee: after every step the mesh is valid, whatever the end; motion that was not made is in the records. The same
// bits for the same input, on any number of threads.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "apps/flow/checkpoint.h"
#include "apps/flow/report.h"
#include "apps/flow/snapshots.h"
#include "core/observer.h"
#include "dsc3d/deform/deformer.h"
#include "dsc3d/mesh.h"

namespace dsc::flow {

/// The motion of one step.
struct StepMotion {
    std::vector<std::optional<Point3>> targets;  ///< indexed by vertex, missing ones stay
    dsc3d::Deformer::Path path;                  ///< to the targets; empty: straight
    /// Wanted at vertices of the interface from here on; missing ones stay.
    std::vector<std::optional<double>> edge_lengths = {};
};

/// The motion from `time` to time + dt.
using Targets = std::function<StepMotion(const dsc3d::Mesh& mesh, double time, double dt)>;

/// Steps from the start to the end of `result.time` and fills the rest of `result`. Ends early when the observer asks
/// for it, no interface is left, or there are no targets, or one is not finite: then the mesh is in its last good
/// state, and the result says why. With checkpoints, mesh and deformer are made again from each of them; when these
/// have a state already, the run goes on from it: the mesh has to be that of the state, and result and snapshots what
/// has come up to there. `walls`: the curved ones of the domain.
void run_flow(dsc3d::Mesh& mesh, const dsc3d::DeformParameters& parameters, const Targets& targets,
              Snapshots& snapshots, core::Observer& observer, FlowResult& result, Checkpoints* checkpoints = nullptr,
              const dsc3d::Walls& walls = {});

}  // namespace dsc::flow
