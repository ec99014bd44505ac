// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/polygon_check.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/random.h"
#include "geometry/triangle.h"
#include "tests/support/seed.h"

using namespace dsc::geometry;
using Polygon = std::vector<Point2>;

namespace {

const Polygon square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

std::optional<SideMeeting> meeting(const std::vector<Polygon>& polygons) { return first_meeting(polygons); }

Polygon moved(Polygon polygon, const Point2& way) {
    for (Point2& p : polygon) p += way;
    return polygon;
}

}  // namespace

TEST_CASE("simple polygons apart from each other don't meet, whatever their order and orientation") {
    CHECK_FALSE(meeting({square}));
    CHECK_FALSE(meeting({Polygon(square.rbegin(), square.rend())}));
    CHECK_FALSE(meeting({square, moved(square, {1.5, 0}), {{0.2, 0.2}, {0.4, 0.2}, {0.3, 0.9}}}));
    const Polygon with_straight_corner = {{0, 0}, {0.5, 0}, {1, 0}, {1, 1}};
    CHECK_FALSE(meeting({with_straight_corner}));
}

TEST_CASE("sides that cross are found with their place") {
    const auto bow = meeting({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}});
    REQUIRE(bow);
    CHECK(bow->first.side == 0);
    CHECK(bow->second.side == 2);
    CHECK((bow->place - Point2(0.5, 0.5)).norm() < 1e-15);
    const auto two = meeting({square, moved(square, {0.5, 0.25})});
    REQUIRE(two);
    CHECK(two->first.polygon == 0);
    CHECK(two->first.side == 1);
    CHECK(two->second.polygon == 1);
    CHECK(two->place == Point2(1, 0.25));
}

TEST_CASE("polygons that only touch do meet") {
    CHECK(meeting({square, moved(square, {1, 0})}));             // a whole side
    CHECK(meeting({square, moved(square, {1, 1})}));             // a corner
    CHECK(meeting({square, {{1, 0.5}, {2, 0}, {2, 1}}}));        // a corner on a side
    CHECK(meeting({{{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}}));  // its own side
    CHECK(meeting({{{0, 0}, {1, 0}, {1, 0}, {1, 1}}}));          // a side of no length
    CHECK(meeting({{{0, 0}, {2, 0}, {1, 0}, {1, 1}}}));          // a side that folds back
    CHECK(meeting({{{0, 0}, {1, 0}, {2, 0}}}));                  // no area
}

TEST_CASE("the sweep finds what all pairs of sides say") {
    dsc::core::Random random(dsc::tests::seed(5));
    int crossing = 0;
    for (int round = 0; round < 300; ++round) {
        Polygon polygon;
        for (int i = 0; i < 7; ++i) {
            const double angle = 2 * std::numbers::pi * i / 7,
                         radius = random.uniform(0.2, 1) * (round % 2 == 0 ? 1 : -1);
            polygon.push_back(Point2(std::cos(angle), std::sin(angle)) * radius +
                              0.4 * Point2(random.uniform(-1, 1), random.uniform(-1, 1)));
        }
        bool is_met = false;
        for (std::size_t i = 0; i < 7; ++i)
            for (std::size_t j = i + 2; j < 7; ++j) {
                if ((j + 1) % 7 == i) continue;
                const Point2 &a = polygon[i], &b = polygon[i + 1], &c = polygon[j], &d = polygon[(j + 1) % 7];
                is_met = is_met ||
                         (orientation(a, b, c) != orientation(a, b, d) && orientation(c, d, a) != orientation(c, d, b));
            }
        REQUIRE(meeting({polygon}).has_value() == is_met);
        crossing += is_met ? 1 : 0;
    }
    CHECK(crossing > 20);
    CHECK(crossing < 280);
}

TEST_CASE("area and inside of a polygon") {
    CHECK(signed_area(square) == 1);
    CHECK(signed_area(Polygon(square.rbegin(), square.rend())) == -1);
    const Polygon notched = {{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}};
    CHECK(contains(notched, {1, 1}));
    CHECK(contains(notched, {3, 1}));
    CHECK_FALSE(contains(notched, {2, 2}));
    CHECK_FALSE(contains(notched, {5, 1}));
    CHECK_FALSE(contains(notched, {-1, 4}));
}
