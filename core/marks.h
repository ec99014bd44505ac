// SPDX-License-Identifier: GPL-3.0-or-later
// A set of handles that is emptied at once: to visit each element of a mesh one time. Cost: constant for each call, but
// for growth and for one call of clear() in four billion.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace dsc::core {

template <class Handle>
class Marks {
public:
    void clear() {
        if (++epoch_ != 0) return;
        std::fill(stamp_.begin(), stamp_.end(), 0u);  // the counter came round: old stamps could be taken for new ones
        epoch_ = 1;
    }

    /// True when the handle was not in the set yet.
    bool add(Handle handle) {
        if (handle.index() >= stamp_.size()) stamp_.resize(handle.index() + handle.index() / 8 + 16, 0u);
        std::uint32_t& stamp = stamp_[handle.index()];
        if (stamp == epoch_) return false;
        stamp = epoch_;
        return true;
    }

    bool has(Handle handle) const { return handle.index() < stamp_.size() && stamp_[handle.index()] == epoch_; }

private:
    std::vector<std::uint32_t> stamp_;
    std::uint32_t epoch_ = 1;
};

}  // namespace dsc::core
