// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/runge_kutta.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/random.h"
#include "motion/rigid.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::motion;

namespace {

/// x' = x cos t - y, y' = x + y cos t: a rotation by t, stretched by exp(sin t).
Vector<2> spiral(const Vector<2>& p, double t) { return {p.x() * std::cos(t) - p.y(), p.x() + p.y() * std::cos(t)}; }
Vector<2> exact_spiral(double t) { return std::exp(std::sin(t)) * Vector<2>(std::cos(t), std::sin(t)); }

double error(int order, int steps) {
    const RungeKuttaFlow<2> flow(spiral, order);
    const double h = 2.0 / steps;
    Vector<2> x(1, 0);
    for (int i = 0; i < steps; ++i) x = flow.at(x, h * i, h * (i + 1));
    return (x - exact_spiral(2)).norm();
}

}  // namespace

TEST_CASE("errors fall with the order of the method, in an equation that depends on time") {
    for (int order = 1; order <= 4; ++order) {
        const double measured = std::log2(error(order, 200) / error(order, 400));
        CHECK(measured == Approx(order).margin(0.1));
    }
}

TEST_CASE("a constant velocity has no error but that of one sum") {
    core::Random random(tests::seed(1));
    for (int i = 0; i < 1000; ++i) {
        const Vector<3> v(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        const Vector<3> x(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        const double t = random.uniform(-1, 1), dt = random.uniform(0, 1);
        for (int order = 1; order <= 4; ++order) {
            const RungeKuttaFlow<3> flow([&](const Vector<3>&, double) { return v; }, order);
            CHECK(flow.at(x, t, t + dt) == x + (t + dt - t) * v);
        }
    }
}

TEST_CASE("the path of a step starts at its start, bends with the flow and ends at its target") {
    const Rotation<2> exact({.about = {0.5, 0}, .angular_velocity = 1});
    const RungeKuttaFlow<2> flow(exact.velocity_field(), 4);
    const Vector<2> start(1, 0);
    CHECK(flow.at(start, 3, 3) == start);
    for (const double t : {0.1, 0.2, 0.4}) {
        CHECK((flow.at(start, 3, 3 + t) - exact.at(start, 3, 3 + t)).norm() < 0.5 * std::pow(t, 5) / 100);
    }
    // Backwards too.
    CHECK((flow.at(flow.at(start, 3, 3.1), 3.1, 3) - start).norm() < 1e-7);
}

TEST_CASE("orders other than 1 to 4 are refused") {
    CHECK_THROWS_AS(RungeKuttaFlow<2>(spiral, 0), core::UsageError);
    CHECK_THROWS_AS(RungeKuttaFlow<2>(spiral, 5), core::UsageError);
}
