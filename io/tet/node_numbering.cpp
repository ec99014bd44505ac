// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/tet/node_numbering.h"

#include <algorithm>

namespace dsc::io::tet {

namespace {

// Entries of the table per vertex up to which it is preferred.
constexpr std::uint64_t sparsest = 8;

}  // namespace

NodeNumbering::NodeNumbering(const std::vector<std::int64_t>& numbers) {
    if (numbers.empty()) return;
    const auto [least, greatest] = std::minmax_element(numbers.begin(), numbers.end());
    least_ = *least;
    // Unsigned, because the difference of two signed numbers may not be one.
    const std::uint64_t range = static_cast<std::uint64_t>(*greatest) - static_cast<std::uint64_t>(*least);
    if (range / sparsest < numbers.size()) {
        build_table(numbers, range);
    } else {
        build_sorted(numbers);
    }
}

void NodeNumbering::build_table(const std::vector<std::int64_t>& numbers, std::uint64_t range) {
    table_.assign(range + 1, none);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        std::uint32_t& entry = table_[static_cast<std::uint64_t>(numbers[i] - least_)];
        if (entry != none) repeated_ = numbers[i];
        entry = static_cast<std::uint32_t>(i);
    }
}

void NodeNumbering::build_sorted(const std::vector<std::int64_t>& numbers) {
    sorted_.reserve(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) sorted_.emplace_back(numbers[i], static_cast<std::uint32_t>(i));
    std::sort(sorted_.begin(), sorted_.end());
    const auto same = std::adjacent_find(sorted_.begin(), sorted_.end(),
                                         [](const auto& a, const auto& b) { return a.first == b.first; });
    if (same != sorted_.end()) repeated_ = same->first;
}

std::uint32_t NodeNumbering::vertex(std::int64_t number) const {
    if (!table_.empty()) {
        const std::uint64_t place = static_cast<std::uint64_t>(number) - static_cast<std::uint64_t>(least_);
        return place < table_.size() ? table_[place] : none;
    }
    const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{number, std::uint32_t{0}});
    return found != sorted_.end() && found->first == number ? found->second : none;
}

}  // namespace dsc::io::tet
