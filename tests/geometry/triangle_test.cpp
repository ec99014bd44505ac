// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/triangle.h"

#include <catch2/catch.hpp>
#include <numbers>

#include "core/random.h"
#include "tests/support/seed.h"

using namespace dsc::geometry;
using std::numbers::pi;

TEST_CASE("measures of known triangles") {
    const Point2 a(0, 0), b(1, 0), c(0, 1), apex(0.5, 0.5 * std::sqrt(3.0));
    CHECK(signed_area(a, b, c) == 0.5);
    CHECK(signed_area(a, c, b) == -0.5);
    CHECK(min_angle(a, b, c) == Approx(pi / 4));
    CHECK(max_angle(a, b, c) == Approx(pi / 2));
    CHECK(mean_ratio(a, b, apex) == Approx(1.0));
    CHECK(mean_ratio(a, b, Point2(2, 0)) == 0.0);
    CHECK(mean_ratio(a, apex, b) == Approx(-1.0));
    CHECK(closest_parameter(Point2(0.25, 7), a, b) == 0.25);
    CHECK(closest_parameter(Point2(-1, 1), a, b) == 0.0);
    CHECK(closest_parameter(Point2(3, 1), a, b) == 1.0);
}

TEST_CASE("the smallest and largest angle bound the third, and all sum to pi") {
    dsc::core::Random random(dsc::tests::seed(4));
    for (int i = 0; i < 2000; ++i) {
        const auto point = [&] { return Point2(random.uniform(), random.uniform()); };
        const Point2 a = point(), b = point(), c = point();
        const double angles[3] = {angle_between(b - a, c - a), angle_between(c - b, a - b),
                                  angle_between(a - c, b - c)};
        REQUIRE(angles[0] + angles[1] + angles[2] == Approx(pi));
        REQUIRE(min_angle(a, b, c) == Approx(std::min({angles[0], angles[1], angles[2]})).margin(1e-12));
        REQUIRE(max_angle(a, b, c) == Approx(std::max({angles[0], angles[1], angles[2]})));
    }
}
