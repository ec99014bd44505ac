// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/predicates.h"

#include <catch2/catch.hpp>

#include "core/random.h"
#include "tests/support/seed.h"

using namespace dsc::geometry;

namespace {

Sign opposite(Sign s) { return static_cast<Sign>(-static_cast<int>(s)); }

// Points of a small grid, where degenerate positions are frequent, at a scale where products round.
Point2 random_grid_point(dsc::core::Random& random) {
    const auto coordinate = [&] { return (1.0 + static_cast<double>(random.below(5)) * 0x1.0p-50) / 3.0; };
    return {coordinate(), coordinate()};
}

}  // namespace

TEST_CASE("orientation is antisymmetric and cyclic, in degenerate positions too") {
    dsc::core::Random random(dsc::tests::seed(1));
    int zeros = 0;
    for (int i = 0; i < 20000; ++i) {
        const Point2 a = random_grid_point(random), b = random_grid_point(random), c = random_grid_point(random);
        const Sign sign = orientation(a, b, c);
        REQUIRE(orientation(b, c, a) == sign);
        REQUIRE(orientation(b, a, c) == opposite(sign));
        REQUIRE(detail::exact_orientation(a, b, c) == sign);
        zeros += sign == Sign::zero ? 1 : 0;
    }
    CHECK(zeros > 100);
}

TEST_CASE("orientation sees the last bit") {
    const Point2 a(12.0, 12.0), b(24.0, 24.0);
    const double x = 0.5;
    CHECK(orientation(Point2(x, x), a, b) == Sign::zero);
    CHECK(orientation(Point2(x, std::nextafter(x, 1.0)), a, b) == Sign::positive);
    CHECK(orientation(Point2(x, std::nextafter(x, 0.0)), a, b) == Sign::negative);
}

TEST_CASE("in_circle is symmetric under even permutations and exact on a circle") {
    dsc::core::Random random(dsc::tests::seed(2));
    const Point2 a(5, 0), b(3, 4), c(-4, 3);
    CHECK(in_circle(a, b, c, Point2(0, -5)) == Sign::zero);
    CHECK(in_circle(a, b, c, Point2(0, std::nextafter(-5, 0.0))) == Sign::positive);
    CHECK(in_circle(a, b, c, Point2(0, std::nextafter(-5, -6.0))) == Sign::negative);
    for (int i = 0; i < 20000; ++i) {
        Point2 p[4];
        for (Point2& point : p) point = random_grid_point(random);
        if (!is_counterclockwise(p[0], p[1], p[2])) continue;
        const Sign sign = in_circle(p[0], p[1], p[2], p[3]);
        REQUIRE(in_circle(p[1], p[2], p[0], p[3]) == sign);
        REQUIRE(detail::exact_in_circle(p[0], p[1], p[2], p[3]) == sign);
    }
}

TEST_CASE("the bound decides nearly always, and as the exact predicate does") {
    dsc::core::Random random(dsc::tests::seed(3));
    const auto point = [&] { return Point2(random.uniform(-1, 1), random.uniform(-1, 1)); };
    for (int i = 0; i < 5000; ++i) {
        const Point2 a = point(), b = point(), c = point(), d = point();
        REQUIRE(orientation(a, b, c) == detail::exact_orientation(a, b, c));
        if (is_counterclockwise(a, b, c)) REQUIRE(in_circle(a, b, c, d) == detail::exact_in_circle(a, b, c, d));
    }
}

TEST_CASE("orientation in space is antisymmetric and exact, in degenerate positions too") {
    dsc::core::Random random(dsc::tests::seed(4));
    const auto coordinate = [&] { return (1.0 + static_cast<double>(random.below(4)) * 0x1.0p-50) / 3.0; };
    const auto point = [&] {
        const double x = coordinate(), y = coordinate(), z = coordinate();
        return Point3(x, y, z);
    };
    int zeros = 0;
    for (int i = 0; i < 20000; ++i) {
        const Point3 a = point(), b = point(), c = point(), d = point();
        const Sign sign = orientation(a, b, c, d);
        REQUIRE(orientation(b, c, a, d) == sign);
        REQUIRE(orientation(b, a, c, d) == opposite(sign));
        REQUIRE(orientation(a, b, d, c) == opposite(sign));
        REQUIRE(detail::exact_orientation(a, b, c, d) == sign);
        zeros += sign == Sign::zero ? 1 : 0;
    }
    CHECK(zeros > 100);
    CHECK(orientation(Point3(0, 0, 0), Point3(1, 0, 0), Point3(0, 1, 0), Point3(0, 0, 1)) == Sign::positive);
    const Point3 a(12, 12, 12), b(24, 24, 24), c(12, 24, 18);
    CHECK(orientation(a, b, c, Point3(0.5, 0.5, 0.5)) == Sign::zero);
    CHECK(orientation(a, b, c, Point3(0.5, 0.5, std::nextafter(0.5, 1.0))) !=
          orientation(a, b, c, Point3(0.5, 0.5, std::nextafter(0.5, 0.0))));
}
