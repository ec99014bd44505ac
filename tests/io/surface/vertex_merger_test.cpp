// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface/vertex_merger.h"

#include <array>
#include <catch2/catch.hpp>
#include <map>

#include "core/random.h"
#include "tests/support/seed.h"

using namespace dsc;

TEST_CASE("places are numbered as they come, equal ones once, as a map does it") {
    core::Random random(tests::seed(81));
    io::surface::VertexMerger merger;
    std::map<std::array<double, 3>, std::uint32_t> numbers;
    bool is_same = true;
    for (int i = 0; i < 20000; ++i) {
        std::array<double, 3> p{};
        for (double& x : p) x = static_cast<double>(random.below(20)) - 10;
        const auto next = static_cast<std::uint32_t>(numbers.size());
        const std::uint32_t expected = numbers.try_emplace(p, next).first->second;
        for (double& x : p) x *= random.below(2) == 0 || x != 0 ? 1 : -1;  // 0 or -0
        is_same = is_same && merger.number({p[0], p[1], p[2]}) == expected;
    }
    CHECK(is_same);
    CHECK(merger.places().size() == numbers.size());
}
