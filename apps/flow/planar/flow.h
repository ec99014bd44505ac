// SPDX-License-Identifier: GPL-3.0-or-later
// The run of the program flow in the plane: steps of motion and deformation, each measured, until the time is over.
// Guarantee: after every step the complex is valid, whatever the end; motion that was not made is in the records. The
// same bits for the same input.
#pragma once

#include "apps/flow/planar/checkpoint.h"
#include "apps/flow/planar/report.h"
#include "apps/flow/planar/snapshots.h"
#include "apps/flow/planar/targets.h"
#include "core/observer.h"
#include "dsc2d/complex.h"
#include "dsc2d/deform/parameters.h"

namespace dsc::flow::planar {

/// Fills `result`, whose domain and time are given. Ends early when the observer asks for it, no interface is left, or
/// a target is not finite or leads out of the box: then the complex is in its last good state, and the result says why.
/// With checkpoints, complex and deformer are made again from each of them; when these have a state already, the run
/// goes on from it: the complex has to be that of the state, and result and snapshots what has come up to there; limits
/// for the edges of the interface are a precondition then.
void run_flow(dsc2d::Complex& complex, const dsc2d::Parameters& parameters, const Targets& targets,
              Snapshots& snapshots, core::Observer& observer, FlowResult& result, Checkpoints* checkpoints = nullptr);

}  // namespace dsc::flow::planar
