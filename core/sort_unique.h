// SPDX-License-Identifier: GPL-3.0-or-later
// A list made a set: ascending, each value once. Cost: n log n.
#pragma once

#include <algorithm>
#include <vector>

namespace dsc::core {

template <class Value>
void sort_unique(std::vector<Value>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace dsc::core
