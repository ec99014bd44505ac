// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/edge_length.h"

#include <catch2/catch.hpp>

using namespace dsc::surface;

TEST_CASE("edges are judged by the mean of the lengths wanted at their ends") {
    CHECK(relative_length(3, 1, 2) == 2);
    CHECK(is_too_long(1.5, {}));
    CHECK_FALSE(is_too_long(1, {}));
    CHECK(is_too_short(0.3, {}));
    CHECK_FALSE(is_too_short(1, {}));
}

TEST_CASE("the halves of a long edge may never be too short") {
    CHECK_NOTHROW(EdgeLengthParameters{}.validate());
    CHECK_NOTHROW(EdgeLengthParameters{.split_above = 1.4, .collapse_below = 0.7}.validate());
    CHECK_THROWS_WITH((EdgeLengthParameters{.split_above = 1.4, .collapse_below = 0.71}.validate()),
                      Catch::StartsWith("collapse_below"));
    CHECK_THROWS_WITH(EdgeLengthParameters{.split_above = 0}.validate(), Catch::StartsWith("split_above"));
}
