// SPDX-License-Identifier: GPL-3.0-or-later
// The run of the program flow: steps of motion and deformation, each measured, until the time is over.
// Guarantee: after every step the mesh is valid, whatever the end; motion that was not made is in the records. The same
// bits for the same input, on any number of threads.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "apps/flow/report.h"
#include "apps/flow/snapshots.h"
#include "core/observer.h"
#include "dsc3d/deform/deformer.h"
#include "dsc3d/mesh.h"

namespace dsc::flow {

/// Where vertices of the interface have to be at time + dt: indexed by vertex, missing ones stay.
using Targets = std::function<std::vector<std::optional<Point3>>(const dsc3d::Mesh& mesh, double time, double dt)>;

/// Steps from `result.steps.back()` on (or from the start, when there is none) and fills the rest of `result`. Ends
/// early when the observer asks for it, no interface is left, or there are no targets, or one is not finite: then the
/// mesh is in its last good state, and the result says why.
void run_flow(dsc3d::Mesh& mesh, dsc3d::Deformer& deformer, const Targets& targets, Snapshots& snapshots,
              core::Observer& observer, FlowResult& result);

}  // namespace dsc::flow
