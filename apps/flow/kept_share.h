// SPDX-License-Identifier: GPL-3.0-or-later
// How much of a first state is still there. Cost: linear.
#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

namespace dsc::flow {

/// The share of `first` that is in `now`, 1 of nothing. Precondition: both ascend.
template <class Key>
double kept_share(const std::vector<Key>& first, const std::vector<Key>& now) {
    if (first.empty()) return 1;
    std::vector<Key> kept;
    std::ranges::set_intersection(first, now, std::back_inserter(kept));
    return static_cast<double>(kept.size()) / static_cast<double>(first.size());
}

}  // namespace dsc::flow
