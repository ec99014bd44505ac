// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/fields.h"

#include <catch2/catch.hpp>
#include <numbers>

#include "core/errors.h"
#include "core/random.h"
#include "motion/runge_kutta.h"
#include "tests/motion/divergence.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::motion;

namespace {

template <int Dimension>
Vector<Dimension> random_point(core::Random& random) {
    Vector<Dimension> x;
    for (double& coordinate : x) coordinate = random.uniform();
    return x;
}

template <int Dimension>
void check_no_divergence(const VelocityField<Dimension>& field) {
    core::Random random(tests::seed(1));
    for (int i = 0; i < 100; ++i) {
        const Vector<Dimension> x = random_point<Dimension>(random);
        const double t = random.uniform();
        // What the differences leave falls with their square.
        for (const double h : {1e-2, 1e-3, 1e-4}) {
            CHECK(std::abs(tests::divergence<Dimension>(field, x, t, h)) < 300 * h * h + 1e-11);
        }
    }
}

template <int Dimension>
void check_walls(const VelocityField<Dimension>& field) {
    core::Random random(tests::seed(2));
    for (int i = 0; i < 100; ++i) {
        for (int k = 0; k < Dimension; ++k) {
            Vector<Dimension> x = random_point<Dimension>(random);
            x[k] = static_cast<double>(random.below(2));
            CHECK(std::abs(field(x, 0)[k]) < 1e-15);
        }
    }
}

template <int Dimension>
void check_reversal(const VelocityField<Dimension>& field, double period) {
    core::Random random(tests::seed(3));
    const RungeKuttaFlow<Dimension> flow(field);
    double largest = 0;
    for (int i = 0; i < 20; ++i) {
        const Vector<Dimension> start = random_point<Dimension>(random);
        const double t = random.uniform(0, period);
        CHECK((field(start, t) + field(start, period - t)).norm() < 1e-14);
        CHECK((field(start, t) - field(start, t + 2 * period)).norm() < 1e-14);
        Vector<Dimension> x = start;
        const int steps = 400;
        for (int step = 0; step < steps; ++step) {
            x = flow.at(x, period * step / steps, period * (step + 1) / steps);
            largest = std::max(largest, (x - start).norm());
        }
        CHECK((x - start).norm() < 1e-6);
    }
    CHECK(largest > 0.3);
}

}  // namespace

TEST_CASE("the standard fields have no divergence") {
    check_no_divergence<3>(enright_deformation(3));
    check_no_divergence<2>(vortex_in_square({}));
    check_no_divergence<3>(vortex_in_cube(2));
    check_no_divergence<3>(shear_field(Vector<3>(1, 0, 2), Vector<3>(0, 1, 0)));
    check_no_divergence<2>(shear_field(Vector<2>(1, 1), Vector<2>(1, -1)));
}

TEST_CASE("nothing crosses the walls of the unit box") {
    check_walls<3>(enright_deformation({}));
    check_walls<2>(vortex_in_square({}));
}

TEST_CASE("after a period everything is back") {
    check_reversal<3>(enright_deformation(3), 3);
    check_reversal<2>(vortex_in_square(2), 2);
    check_reversal<3>(vortex_in_cube(2), 2);
}

TEST_CASE("values of the fields are those of their formulas") {
    const Vector<3> p(0.25, 0.25, 0.25);
    CHECK((enright_deformation({})(p, 7) - Vector<3>(1, -0.5, -0.5)).norm() < 1e-15);
    CHECK((enright_deformation(3)(p, 1) - 0.5 * Vector<3>(1, -0.5, -0.5)).norm() < 1e-15);
    CHECK((vortex_in_square({})(Vector<2>(0.5, 0.25), 0) - Vector<2>(1, 0)).norm() < 1e-15);
    CHECK(vortex_in_cube({})(Vector<3>(0.5, 0.25, 0.3), 0).z() == 0);
    CHECK(translation_field<2>({1, 2})(Vector<2>(5, 6), 7) == Vector<2>(1, 2));
    CHECK(shear_field(Vector<2>(3, 0), Vector<2>(0, 2))(Vector<2>(5, 7), 0) == Vector<2>(42, 0));
    CHECK(shear_field(Vector<2>(3, 0), Vector<2>(0, 2), Vector<2>(4, 6))(Vector<2>(5, 7), 0) == Vector<2>(6, 0));
}

TEST_CASE("periods that are not positive and slanted shears are refused") {
    CHECK_THROWS_AS(enright_deformation(0), core::UsageError);
    CHECK_THROWS_AS(vortex_in_square(-1), core::UsageError);
    CHECK_THROWS_AS(vortex_in_cube(NAN), core::UsageError);
    CHECK_THROWS_AS(shear_field(Vector<2>(1, 0), Vector<2>(1, 1)), core::UsageError);
}
