// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/errors.h"

#include <catch2/catch.hpp>
#include <string>

using namespace dsc::core;

TEST_CASE("an input error reads as one line: source, place, problem, cure") {
    const InputError full("points.csv", "line 7", "\"abc\" is not a number", "write u,v");
    CHECK(std::string(full.what()) == "points.csv: line 7: \"abc\" is not a number; write u,v");
    CHECK(full.source() == "points.csv");
    CHECK(full.place() == "line 7");
    CHECK(std::string(InputError("a", "", "is empty", "").what()) == "a: is empty");
}

TEST_CASE("all exceptions of the toolkit are errors") {
    CHECK_THROWS_AS(throw UsageError("x"), Error);
    CHECK_THROWS_AS(throw InputError("a", "b", "c", "d"), Error);
    CHECK_THROWS_AS(throw RunError("x"), Error);
    CHECK_THROWS_AS(throw Cancelled(), Error);
}
