// SPDX-License-Identifier: GPL-3.0-or-later
// A flow in the plane up to a step, from which it goes on bit for bit: see apps/common/checkpoints.h. Handles stay what
// they are: contacts go on, and steps depend on checkpoints in this only, that a vertex that was kept from moving is
// given as many substeps again before it counts as touching what is in its way.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "apps/common/checkpoints.h"
#include "apps/flow/checkpoint.h"
#include "apps/flow/planar/held_contacts.h"
#include "apps/flow/planar/initial_complex.h"
#include "apps/flow/planar/report.h"
#include "apps/flow/planar/snapshots.h"
#include "dsc2d/complex_arrays.h"

namespace dsc::flow::planar {

/// What the steps that follow depend on, beside the options.
struct RunState {
    int step = 0;
    double seconds = 0;  ///< of the run so far
    Eigen::AlignedBox2d domain;
    EdgeLimits edges;
    dsc2d::ComplexArrays complex;
    UnchangedEdges::State unchanged;
    std::vector<HeldContact> contacts;
};

template <class Visitor, core::ConstOrNot<RunState> Value>
void fields(Visitor& visitor, Value& run) {
    auto& [step, seconds, domain, edges, complex, unchanged, contacts] = run;
    visitor(step, seconds, domain, edges, complex, unchanged, contacts);
}

using SavedRun = apps::SavedRun<RunState, StepRecord, EventOf<2>, Snapshots::Frame>;
using Checkpoints = apps::Checkpoints<SavedRun>;

}  // namespace dsc::flow::planar
