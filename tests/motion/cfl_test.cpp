// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/cfl.h"

#include <array>
#include <catch2/catch.hpp>

using namespace dsc::motion;

TEST_CASE("the step is as long as the fastest vertex allows") {
    const std::array<Vector<3>, 3> velocities{Vector<3>(1, 0, 0), Vector<3>(0, 3, 4), Vector<3>::Zero()};
    const std::array<double, 3> lengths{0.1, 1, 1e-9};
    const std::array<double, 1> one{0.1};
    CHECK(cfl_step<3>(velocities, lengths, 0.5, 10) == Approx(0.05));
    CHECK(cfl_step<3>(velocities, one, 0.5, 10) == Approx(0.01));
    CHECK(cfl_step<3>(velocities, lengths, 0.5, 0.02) == 0.02);
}

TEST_CASE("what rests or is not there does not limit the step") {
    const std::array<Vector<2>, 1> rest{Vector<2>::Zero()};
    const std::array<double, 1> one{0.1};
    CHECK(cfl_step<2>(rest, one, 0.5, 7) == 7);
    CHECK(cfl_step<2>({}, one, 0.5, 7) == 7);
}
