// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/snapshot_times.h"

#include <cstdint>

#include "core/assert.h"

namespace dsc::flow {

bool is_snapshot(int step, int steps, int count) {
    if (count <= 0) return false;
    if (count > steps) return true;
    if (step == 0 || step == steps) return true;
    if (count <= 2) return false;
    // Step k is one when a multiple of steps / (count - 1) lies in (k - 1, k].
    const std::int64_t parts = count - 1;
    return step * parts / steps != (step - 1) * parts / steps;
}

bool SnapshotTimes::take(int step) {
    if (!is_snapshot(step, steps_, count_)) return false;
    DSC_ASSERT(step > last_);
    last_ = step;
    return true;
}

bool SnapshotTimes::take_last(int step) {
    if (count_ <= 0 || step == last_) return false;
    last_ = step;
    return true;
}

}  // namespace dsc::flow
