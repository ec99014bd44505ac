// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/rigid.h"

#include <catch2/catch.hpp>
#include <numbers>

#include "core/random.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::motion;

TEST_CASE("a full turn leads back, in any number of steps") {
    core::Random random(tests::seed(1));
    for (const int steps : {1, 7, 50, 360}) {
        const Vector<3> axis(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1));
        const Rotation<3> in_space(
            {.about = {0.3, 0.4, 0.5}, .axis = axis, .angular_velocity = 2 * std::numbers::pi / steps});
        const Rotation<2> in_plane({.about = {0.3, 0.4}, .angular_velocity = 2 * std::numbers::pi / steps});
        const Vector<3> start(random.uniform(), random.uniform(), random.uniform());
        Vector<3> x = start;
        Vector<2> y = start.head<2>();
        for (int i = 0; i < steps; ++i) {
            x = in_space.at(x, i, i + 1);
            y = in_plane.at(y, i, i + 1);
        }
        CHECK((x - start).norm() < 1e-15 * (10 + steps));
        CHECK((y - start.head<2>()).norm() < 1e-15 * (10 + steps));
    }
}

TEST_CASE("a quarter turn about an axis is known") {
    const Rotation<3> turn({.about = {1, 0, 0}, .axis = {0, 0, 5}, .angular_velocity = std::numbers::pi / 2});
    CHECK((turn.at({2, 0, 3}, 0, 1) - Vector<3>(1, 1, 3)).norm() < 1e-15);
    CHECK((turn.at({2, 0, 3}, 1, 0) - Vector<3>(1, -1, 3)).norm() < 1e-15);
    CHECK((turn.at({1, 0, 7}, 0, 0.3) - Vector<3>(1, 0, 7)).norm() == 0);
    const Rotation<2> plane({.about = {1, 0}, .angular_velocity = std::numbers::pi / 2});
    CHECK((plane.at({2, 0}, 0, 1) - Vector<2>(1, 1)).norm() < 1e-15);
}

TEST_CASE("substeps of a rotation lie on the arc") {
    const Rotation<3> turn({.axis = {1, 2, 3}, .angular_velocity = 2});
    const Vector<3> start(1, -1, 0.5), axis = Vector<3>(1, 2, 3).normalized();
    const double radius = axis.cross(start).norm();
    for (double t = 0; t <= 1; t += 0.125) {
        const Vector<3> x = turn.at(start, 0, t);
        CHECK(axis.cross(x).norm() == Approx(radius).epsilon(1e-14));
        CHECK(axis.dot(x) == Approx(axis.dot(start)).epsilon(1e-14));
        CHECK((turn.at(x, t, 1) - turn.at(start, 0, 1)).norm() < 1e-14);
    }
}

TEST_CASE("the velocity of a rotation is the derivative of its path") {
    const Rotation<3> in_space({.about = {0.1, 0.2, 0.3}, .axis = {1, 2, 3}, .angular_velocity = -2});
    const Rotation<2> in_plane({.about = {0.1, 0.2}, .angular_velocity = -2});
    const double h = 1e-5;
    const Vector<3> x(1, 0, 2);
    const Vector<2> y(1, 0);
    const Vector<3> difference = (in_space.at(x, 0, h) - in_space.at(x, 0, -h)) / (2 * h);
    CHECK((in_space.velocity(x) - difference).norm() < 1e-8);
    const Vector<2> difference_2d = (in_plane.at(y, 0, h) - in_plane.at(y, 0, -h)) / (2 * h);
    CHECK((in_plane.velocity_field()(y, 7) - difference_2d).norm() < 1e-8);
}

TEST_CASE("a translation is exact, and a rotation has to have an axis") {
    const Translation<3> flow({0.25, -0.5, 1});
    CHECK(flow.at({1, 1, 1}, 2, 4) == Vector<3>(1.5, 0, 3));
    CHECK_THROWS_AS(Rotation<3>({.axis = {0, 0, 0}}), core::UsageError);
    CHECK_THROWS_AS(Rotation<3>({.axis = {NAN, 0, 0}}), core::UsageError);
}
