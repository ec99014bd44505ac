// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/time_steps.h"

#include <catch2/catch.hpp>

#include "core/errors.h"

using namespace dsc;
using namespace dsc::flow;

TEST_CASE("of step, end and number the third one follows from two, and defaults from the motion") {
    const MotionOptions rotation, enright = {.motion = Motion::enright, .period = 3};
    TimeSteps steps = time_steps({.dt = 0.25, .steps = 10}, rotation);
    CHECK(steps.count == 10);
    CHECK(steps.until == 2.5);
    steps = time_steps({.dt = 0.3, .until = 1}, rotation);
    CHECK(steps.count == 4);
    CHECK(steps.time(3) == Approx(0.9));
    CHECK(steps.time(4) == 1);
    steps = time_steps({.until = 2, .steps = 8}, rotation);
    CHECK(steps.dt == 0.25);
    steps = time_steps({.steps = 30}, enright);
    CHECK(steps.until == 3);
    CHECK(steps.dt == Approx(0.1));
    steps = time_steps({}, rotation);
    CHECK(steps.count == 50);
    CHECK(steps.time(50) == 1);
}

TEST_CASE("a step that divides the time only up to rounding gives no step more") {
    for (const int count : {3, 7, 10, 49, 360, 1000}) {
        const TimeSteps steps = time_steps({.dt = 1.0 / count, .until = 1}, {});
        CHECK(steps.count == count);
        for (int k = 0; k < count; ++k) REQUIRE(steps.time(k) < steps.time(k + 1));
        CHECK(steps.time(count) == 1);
    }
    CHECK_THROWS_AS(time_steps({.dt = 1e-300}, {}), core::UsageError);
    CHECK_THROWS_AS(time_steps({.dt = 1e308, .steps = 5}, {}), core::UsageError);
    const TimeSteps one = time_steps({.dt = 5, .until = 1}, {});
    CHECK(one.count == 1);
    CHECK(one.dt == 1);
}

TEST_CASE("a rotation by more than a full turn in a step is refused: its path would not be followed") {
    CHECK(time_steps({.steps = 10}, {.angle = -3600}).count == 10);
    CHECK_THROWS_WITH(time_steps({.steps = 10}, {.angle = 3601}), Catch::Contains("--angle"));
    CHECK_THROWS_AS(time_steps({}, {.angle = 1e12}), core::UsageError);
    CHECK_THROWS_AS(time_steps({.dt = 0.5, .until = 0.9}, {.angle = 720}), core::UsageError);
    CHECK(time_steps({.steps = 10}, {.motion = Motion::shear, .angle = 1e12}).count == 10);
}
