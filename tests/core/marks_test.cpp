// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/marks.h"

#include <catch2/catch.hpp>
#include <set>

#include "core/handles.h"
#include "core/random.h"
#include "tests/support/seed.h"

using namespace dsc;
using core::VertexId;

TEST_CASE("marks are a set: the same as the standard one after every call") {
    core::Random random(tests::seed(1));
    core::Marks<VertexId> marks;
    std::set<VertexId> expected;
    for (int call = 0; call < 20000; ++call) {
        const VertexId v(static_cast<std::uint32_t>(random.below(300)));
        if (random.below(100) == 0) {
            marks.clear();
            expected.clear();
        }
        if (random.below(2) == 0) REQUIRE(marks.add(v) == expected.insert(v).second);
        REQUIRE(marks.has(v) == (expected.count(v) != 0));
    }
}

TEST_CASE("new marks are empty, also for handles that none of them has reached") {
    core::Marks<VertexId> marks;
    CHECK_FALSE(marks.has(VertexId(0)));
    CHECK_FALSE(marks.has(VertexId(1000000)));
    CHECK(marks.add(VertexId(7)));
    // The room that was made beyond the handle is empty too.
    for (std::uint32_t i = 0; i < 100; ++i) CHECK(marks.has(VertexId(i)) == (i == 7));
}
