// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/disjoint_sets.h"

#include <catch2/catch.hpp>

#include "core/random.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::core;

TEST_CASE("sets are known by their least members, whatever the order in which they were united") {
    Random random(tests::seed(1));
    const std::uint32_t count = 200;
    std::vector<std::uint32_t> least(count);  // by relabelling, the slow way
    for (std::uint32_t i = 0; i < count; ++i) least[i] = i;
    DisjointSets sets(count);
    for (int k = 0; k < 150; ++k) {
        const auto a = static_cast<std::uint32_t>(random.below(count)),
                   b = static_cast<std::uint32_t>(random.below(count));
        sets.unite(a, b);
        const std::uint32_t low = std::min(least[a], least[b]), high = std::max(least[a], least[b]);
        for (std::uint32_t& member : least)
            if (member == high) member = low;
        for (std::uint32_t i = 0; i < count; ++i) REQUIRE(sets.find(i) == least[i]);
    }
}
