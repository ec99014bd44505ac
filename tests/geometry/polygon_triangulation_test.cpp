// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/polygon_triangulation.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "core/random.h"
#include "tests/support/seed.h"
#include "tests/support/triangulations.h"

using dsc::geometry::PolygonTriangulation;
using namespace dsc::tests;

namespace {

using Weights = std::map<std::array<int, 3>, double>;

Weights random_weights(int n, dsc::core::Random& random) {
    Weights weights;
    for (int i = 0; i < n; ++i)
        for (int j = i + 1; j < n; ++j)
            for (int k = j + 1; k < n; ++k) weights[{i, j, k}] = random.uniform(-0.3, 1);
    return weights;
}

double worst(const Triangulation& triangulation, const Weights& weights) {
    double value = infinity;
    for (const auto& triangle : triangulation) value = std::min(value, weights.at(triangle));
    return value;
}

Triangulation triangles_of(const PolygonTriangulation<8>& best) {
    Triangulation triangles;
    best.for_each_triangle([&](int i, int j, int k) { triangles.push_back({i, j, k}); });
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

}  // namespace

TEST_CASE("the enumeration has as many triangulations as Catalan counts") {
    const std::array expected = {1, 1, 2, 5, 14, 42, 132};
    for (int n = 2; n <= 8; ++n) {
        std::set<Triangulation> distinct;
        for (Triangulation t : triangulations(n)) {
            CHECK(t.size() == static_cast<std::size_t>(n - 2));
            std::sort(t.begin(), t.end());
            distinct.insert(t);
        }
        CHECK(distinct.size() == static_cast<std::size_t>(expected[static_cast<std::size_t>(n - 2)]));
    }
}

TEST_CASE("the triangulation found is the best of all") {
    dsc::core::Random random(seed(1));
    int impossible = 0;
    for (int n = 3; n <= 8; ++n) {
        std::set<Triangulation> all;
        for (Triangulation t : triangulations(n)) {
            std::sort(t.begin(), t.end());
            all.insert(t);
        }
        for (int trial = 0; trial < 200; ++trial) {
            const Weights weights = random_weights(n, random);
            double best_of_all = -infinity;
            for (const Triangulation& t : all) best_of_all = std::max(best_of_all, worst(t, weights));
            const double threshold = trial % 2 == 0 ? -infinity : random.uniform(-0.3, 0.6);
            const PolygonTriangulation<8> best(n, threshold, [&](int i, int j, int k) {
                return weights.at({i, j, k});
            });
            REQUIRE(best.is_possible() == (best_of_all > threshold));
            if (!best.is_possible()) {
                ++impossible;
                continue;
            }
            REQUIRE(best.value() == best_of_all);
            const Triangulation found = triangles_of(best);
            REQUIRE(all.count(found) == 1);
            REQUIRE(worst(found, weights) == best_of_all);
        }
    }
    CHECK(impossible > 50);
}

TEST_CASE("the threshold itself is not good enough") {
    const auto weight = [](int, int, int) { return 0.25; };
    CHECK_FALSE(PolygonTriangulation<8>(6, 0.25, weight).is_possible());
    CHECK(PolygonTriangulation<8>(6, 0.2499, weight).is_possible());
}

TEST_CASE("a polygon of two vertices is nothing, of any quality") {
    const PolygonTriangulation<8> best(2, 0, [](int, int, int) { return -1.0; });
    CHECK(best.is_possible());
    CHECK(best.value() == infinity);
    CHECK(triangles_of(best).empty());
}
