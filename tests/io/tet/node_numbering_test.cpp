// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/tet/node_numbering.h"

#include <catch2/catch.hpp>
#include <limits>
#include <map>

#include "core/random.h"
#include "tests/support/seed.h"

using dsc::io::tet::NodeNumbering;

TEST_CASE("every number leads to its vertex, dense or sparse") {
    dsc::core::Random random(dsc::tests::seed(21));
    for (const std::int64_t range : {600LL, 100'000LL, 4'000'000'000'000'000'000LL}) {
        std::map<std::int64_t, std::uint32_t> truth;
        std::vector<std::int64_t> numbers;
        while (numbers.size() < 500) {
            const auto number = static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(range))) - range / 2;
            if (truth.emplace(number, numbers.size()).second) numbers.push_back(number);
        }
        const NodeNumbering numbering(numbers);
        CHECK_FALSE(numbering.repeated());
        for (const auto& [number, vertex] : truth) {
            CHECK(numbering.vertex(number) == vertex);
            if (!truth.contains(number + 1)) CHECK(numbering.vertex(number + 1) == NodeNumbering::none);
        }
        CHECK(numbering.vertex(range) == NodeNumbering::none);
        numbers.push_back(numbers[17]);
        CHECK(NodeNumbering(numbers).repeated() == numbers[17]);
    }
}

TEST_CASE("the extremes are numbers too") {
    constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();
    constexpr std::int64_t greatest = std::numeric_limits<std::int64_t>::max();
    const NodeNumbering numbering({greatest, least});
    CHECK(numbering.vertex(greatest) == 0);
    CHECK(numbering.vertex(least) == 1);
    CHECK(numbering.vertex(0) == NodeNumbering::none);
    CHECK(NodeNumbering({}).vertex(0) == NodeNumbering::none);
}
