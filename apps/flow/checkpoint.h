// SPDX-License-Identifier: GPL-3.0-or-later
// A flow in space up to a step, from which it goes on bit for bit: see apps/common/checkpoints.h. About 5 microseconds
// per tetrahedron.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "apps/common/checkpoints.h"
#include "apps/flow/report.h"
#include "apps/flow/snapshots.h"
#include "geometry/data_fields.h"
#include "geometry/tet_data.h"

namespace dsc::flow {

/// The checkpoints of a flow in the plane are of the same kind: the options tell them apart.
inline constexpr apps::CheckpointKind checkpoint_kind{"flow", 2};

/// What the steps that follow depend on, beside the options.
struct RunState {
    int step = 0;
    double seconds = 0;  ///< of the run so far
    Eigen::AlignedBox3d domain;
    double edge_length = 0;  ///< of the interface at the start
    geometry::TetData tets;
    std::vector<double> edge_lengths;  ///< wanted at the vertices
    UnchangedTriangles::State unchanged;
};

template <class Visitor, core::ConstOrNot<RunState> Value>
void fields(Visitor& visitor, Value& run) {
    auto& [step, seconds, domain, edge_length, tets, edge_lengths, unchanged] = run;
    visitor(step, seconds, domain, edge_length, tets, edge_lengths, unchanged);
}

using SavedRun = apps::SavedRun<RunState, StepRecord, EventOf<3>, Snapshots::Frame>;
using Checkpoints = apps::Checkpoints<SavedRun>;

}  // namespace dsc::flow
