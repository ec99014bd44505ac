// SPDX-License-Identifier: GPL-3.0-or-later
// The members of the counts of a step, for all that goes through them: see core/fields.h.
#pragma once

#include "core/fields.h"
#include "motion/step_report.h"

namespace dsc::motion {

template <class Visitor, core::ConstOrNot<StepCounts> Value>
void fields(Visitor& visitor, Value& counts) {
    auto& [moves, blocked, flips, collapses, edge_splits, face_splits, smoothings, topology_changes] = counts;
    visitor(moves, blocked, flips, collapses, edge_splits, face_splits, smoothings, topology_changes);
}

}  // namespace dsc::motion
