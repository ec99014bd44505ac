// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/domain.h"

#include <catch2/catch.hpp>
#include <numbers>

#include "core/errors.h"
#include "core/random.h"
#include "tests/support/seed.h"

using namespace dsc::dsc2d;
using std::numbers::pi;

TEST_CASE("translations by the lattice are exact anywhere in reach") {
    Eigen::Matrix2d periods;
    periods << 2 * pi, pi, 0.1, pi * std::sqrt(3.0);
    const Domain domain = Domain::torus(periods, Point2(-1.0 / 3.0, 0.7));
    dsc::core::Random random(dsc::tests::seed(5));
    for (int i = 0; i < 2000; ++i) {
        const Point2 p = domain.snapped(Point2(random.uniform(-50, 50), random.uniform(-50, 50)));
        const LatticeVector k(static_cast<int>(random.below(15)) - 7, static_cast<int>(random.below(15)) - 7);
        const Point2 moved = p + domain.translation(k);
        REQUIRE(moved - domain.translation(k) == p);
        REQUIRE(domain.snapped(moved) == moved);
        REQUIRE((domain.snapped(p) - p).isZero(0.0));
    }
}

TEST_CASE("rounding to the grid is below one quantum") {
    const Domain domain = Domain::box({0, 0}, {1, 2});
    CHECK(domain.quantum() < 1e-13);
    dsc::core::Random random(dsc::tests::seed(6));
    for (int i = 0; i < 1000; ++i) {
        const Point2 p(random.uniform(), random.uniform());
        REQUIRE((domain.snapped(p) - p).cwiseAbs().maxCoeff() <= 0.5 * domain.quantum());
    }
}

TEST_CASE("a domain knows its kind") {
    CHECK_FALSE(Domain::torus(Eigen::Matrix2d::Identity()).has_boundary());
    CHECK(Domain::box({0, 0}, {1, 1}).has_boundary());
    const Domain cylinder = Domain::cylinder({2, 0}, {0, 3});
    CHECK(cylinder.is_periodic(0));
    CHECK_FALSE(cylinder.is_periodic(1));
    CHECK(cylinder.area() == Approx(6.0));
}

TEST_CASE("impossible domains are refused") {
    using dsc::core::UsageError;
    CHECK_THROWS_AS(Domain::box({0, 0}, {1, 0}), UsageError);
    CHECK_THROWS_AS(Domain::torus(-Eigen::Matrix2d::Identity() + 2 * Eigen::Matrix2d::Identity().col(0) *
                                                                      Eigen::Matrix2d::Identity().row(0)),
                    UsageError);
    CHECK_THROWS_AS(Domain::cylinder({1, 0}, {2, 0}), UsageError);
    CHECK_THROWS_AS(Domain::cylinder({1, 0}, {0, std::nan("")}), UsageError);
}
