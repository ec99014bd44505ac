// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/common/number_list.h"

#include <catch2/catch.hpp>

#include "core/errors.h"

using namespace dsc;
using namespace dsc::apps;

TEST_CASE("a list of numbers is read whole or refused with the option's name") {
    CHECK(parsed_numbers("--size", "1") == std::vector<double>{1});
    CHECK(parsed_numbers("--size", "1,-2e3,.5") == std::vector<double>{1, -2000, 0.5});
    for (const char* text : {"", ",", "1,", ",1", "1,,2", "1;2", "nan", "inf,1", "1,x"}) {
        CAPTURE(text);
        CHECK_THROWS_WITH(parsed_numbers("--size", text), Catch::Contains("--size") && Catch::Contains(text));
    }
}

TEST_CASE("a point has as many numbers as the space has dimensions") {
    CHECK(parsed_point<2>("--about", "1,2") == Eigen::Vector2d(1, 2));
    CHECK(parsed_point<3>("--about", "1,2,3") == Eigen::Vector3d(1, 2, 3));
    CHECK_THROWS_AS(parsed_point<2>("--about", "1,2,3"), core::UsageError);
    CHECK_THROWS_AS(parsed_point<3>("--about", "1,2"), core::UsageError);
}
