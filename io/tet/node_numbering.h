// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices by the numbers that a file gives them: in any order, with gaps.
// Cost: a table where the numbers are dense enough, else a binary search; memory follows the count of the numbers, not
// their size.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace dsc::io::tet {

class NodeNumbering {
public:
    /// `numbers[i]` is the number of vertex i.
    explicit NodeNumbering(const std::vector<std::int64_t>& numbers);

    /// A number that two vertices have.
    std::optional<std::int64_t> repeated() const { return repeated_; }
    /// The vertex with this number, or `none`.
    std::uint32_t vertex(std::int64_t number) const;

    static constexpr std::uint32_t none = ~std::uint32_t{0};

private:
    void build_table(const std::vector<std::int64_t>& numbers, std::uint64_t range);
    void build_sorted(const std::vector<std::int64_t>& numbers);

    std::int64_t least_ = 0;
    std::vector<std::uint32_t> table_;  // by number - least_
    std::vector<std::pair<std::int64_t, std::uint32_t>> sorted_;
    std::optional<std::int64_t> repeated_;
};

}  // namespace dsc::io::tet
