// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/gluing.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <numbers>

#include "core/random.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::cutlocus;

namespace {

using std::numbers::pi;

/// Directions across the sides of a regular polygon of 2 `sides` sides whose opposite sides are glued by translations:
/// `per_side` pairs on each, evenly spread over the side's angle.
std::vector<DirectionPair> polygon_pairs(int sides, int per_side) {
    std::vector<DirectionPair> pairs;
    const double width = pi / sides;
    for (int side = 0; side < sides; ++side)
        for (int i = 0; i < per_side; ++i) {
            const double offset = width * ((i + 0.5) / per_side - 0.5), middle = side * width;
            pairs.push_back({middle + offset, middle + pi - offset, 1, {0, 0}});
        }
    return pairs;
}

/// How many closed walks there are of each length.
std::map<std::size_t, int> closed_walks(const Gluing& gluing) {
    std::map<std::size_t, int> counts;
    for (const Gluing::Walk& walk : gluing.walks())
        if (walk.is_closed) ++counts[walk.gaps.size()];
    return counts;
}

void shuffle(std::vector<DirectionPair>& pairs, core::Random& random) {
    for (std::size_t i = pairs.size(); i > 1; --i) std::swap(pairs[i - 1], pairs[random.below(i)]);
    for (DirectionPair& pair : pairs)
        if (random.below(2) == 1) std::swap(pair.theta1, pair.theta2);
}

}  // namespace

TEST_CASE("a square glued to a torus has one vertex of degree 4") {
    const int n = GENERATE(1, 2, 7);
    const Gluing gluing(polygon_pairs(2, n), {});
    CHECK(gluing.euler_characteristic() == 0);
    const auto counts = closed_walks(gluing);
    CHECK(counts.at(4) == 1);
    CHECK(counts.size() == (n == 1 ? 1 : 2));
    if (n > 1) CHECK(counts.at(2) == 2 * (n - 1));
}

TEST_CASE("a hexagon glued to a torus has two vertices of degree 3") {
    const int n = GENERATE(1, 2, 7);
    const Gluing gluing(polygon_pairs(3, n), {});
    CHECK(gluing.euler_characteristic() == 0);
    const auto counts = closed_walks(gluing);
    CHECK(counts.at(3) == 2);
    if (n > 1) CHECK(counts.at(2) == 3 * (n - 1));
}

TEST_CASE("an octagon whose opposite sides are glued is a surface of genus 2") {
    CHECK(Gluing(polygon_pairs(4, 3), {}).euler_characteristic() == -2);
}

TEST_CASE("a circle folded along a diameter is a sphere, its cut locus an arc with two ends") {
    std::vector<DirectionPair> pairs;
    for (int i = 1; i < 10; ++i) pairs.push_back({0.3 * i, -0.3 * i, 1, {0, 0}});
    const Gluing gluing(pairs, {});
    CHECK(gluing.euler_characteristic() == 2);
    const auto counts = closed_walks(gluing);
    CHECK(counts.at(1) == 2);
    CHECK(counts.at(2) == 8);
    CHECK(counts.size() == 2);
}

TEST_CASE("a gap is inside an arc exactly if its walk has two gaps") {
    const Gluing gluing(polygon_pairs(3, 5), {});
    for (const Gluing::Walk& walk : gluing.walks())
        for (const int gap : walk.gaps) CHECK(gluing.is_inside_arc(gap) == (walk.gaps.size() == 2));
}

TEST_CASE("free directions open the gaps at the ends of an arc that leaves the disc") {
    std::vector<DirectionPair> pairs;  // of a flat cylinder
    for (int i = -4; i <= 4; ++i) pairs.push_back({0.2 * i, pi - 0.2 * i, 1, {1, 0}});
    const std::vector<double> free{pi / 2, -pi / 2, pi / 2 + 0.1};
    const Gluing gluing(pairs, free);
    int open_gaps = 0, open_walks = 0;
    for (int gap = 0; gap < gluing.size(); ++gap) {
        open_gaps += gluing.is_open(gap) ? 1 : 0;
        if (gluing.is_open(gap)) CHECK_FALSE(gluing.is_inside_arc(gap));
    }
    for (const Gluing::Walk& walk : gluing.walks()) {
        CHECK(walk.gaps.size() == 2);
        CHECK(walk.is_closed == !gluing.is_open(walk.gaps.front()));
        CHECK(walk.is_closed == !gluing.is_open(walk.gaps.back()));
        open_walks += walk.is_closed ? 0 : 1;
    }
    CHECK(open_gaps == 2);
    CHECK(open_walks == 2);
}

TEST_CASE("walks depend neither on the order of the pairs nor on that of their directions") {
    core::Random random(tests::seed(1));
    for (int sides = 1; sides <= 5; ++sides) {
        std::vector<DirectionPair> pairs = polygon_pairs(sides, 4);
        const Gluing before(pairs, {});
        shuffle(pairs, random);
        const Gluing after(pairs, {});
        CHECK(closed_walks(before) == closed_walks(after));
        CHECK(before.euler_characteristic() == after.euler_characteristic());
    }
}

TEST_CASE("any pairing whatever makes walks that visit every gap once, and a closed orientable surface") {
    core::Random random(tests::seed(2));
    for (int round = 0; round < 200; ++round) {
        std::vector<DirectionPair> pairs(1 + random.below(12));
        for (DirectionPair& pair : pairs) pair = {random.uniform(-10, 10), random.uniform(-10, 10), 1, {0, 0}};
        const Gluing gluing(pairs, {});
        std::vector<int> visits(static_cast<std::size_t>(gluing.size()), 0);
        for (const Gluing::Walk& walk : gluing.walks())
            for (const int gap : walk.gaps) ++visits[static_cast<std::size_t>(gap)];
        CHECK(std::all_of(visits.begin(), visits.end(), [](int count) { return count == 1; }));
        CHECK(gluing.euler_characteristic() <= 2);
        CHECK(gluing.euler_characteristic() % 2 == 0);
        for (int k = 0; k < gluing.size(); ++k) CHECK(gluing.partner(gluing.partner(k)) == k);
    }
}

TEST_CASE("wrapped_angle brings every angle to [0, 2 pi)") {
    core::Random random(tests::seed(3));
    for (int i = 0; i < 1000; ++i) {
        const double angle = random.uniform(-50, 50), wrapped = wrapped_angle(angle);
        CHECK((wrapped >= 0 && wrapped < 2 * pi));
        CHECK(std::abs(std::remainder(angle - wrapped, 2 * pi)) < 1e-13);
    }
    CHECK(wrapped_angle(-1e-300) == 0);
    CHECK(wrapped_angle(2 * pi) == 0);
}
