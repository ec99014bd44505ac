// SPDX-License-Identifier: GPL-3.0-or-later
// Disjoint sets of the numbers 0 .. count - 1, each known by its least member.
// Guarantee: the result does not depend on the order of the calls. Cost: nearly constant per call, by path halving.
//
//     core::DisjointSets parts(tets);
//     for (auto [t, u] : neighbours) parts.unite(t, u);
//     if (parts.find(t) == t) ++count;   // once for each set
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace dsc::core {

class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
    }

    /// The least member of the set of i.
    std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void unite(std::uint32_t i, std::uint32_t j) {
        i = find(i), j = find(j);
        parent_[std::max(i, j)] = std::min(i, j);
    }

private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace dsc::core
