// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/picture/chart_box.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "core/random.h"
#include "tests/support/seed.h"

using dsc::core::Random;
using dsc::cutlocus::ChartBox;
using dsc::cutlocus::Polyline;
using dsc::cutlocus::round_step;
using dsc::cutlocus::thinned;
using dsc::geodesic::Point2;

namespace {

double length(const Polyline& line) {
    double sum = 0;
    for (std::size_t i = 1; i < line.size(); ++i)
        if (line[i].allFinite() && line[i - 1].allFinite()) sum += (line[i] - line[i - 1]).norm();
    return sum;
}

Polyline random_walk(Random& random, int steps, double step) {
    Polyline line{{0, 0}};
    for (int i = 0; i < steps; ++i)
        line.push_back(line.back() + step * Point2(random.uniform() - 0.35, random.uniform() - 0.4));
    return line;
}

}  // namespace

TEST_CASE("cutting a line at the seams keeps its length and stays in the box") {
    Random random(dsc::tests::seed(1));
    const ChartBox box({1.0, 2.0}, {0.1, -0.2}, {});
    for (int repetition = 0; repetition < 50; ++repetition) {
        const Polyline line = random_walk(random, 80, 0.2);
        double total = 0;
        for (const Polyline& piece : box.pieces(line)) {
            total += length(piece);
            for (const Point2& x : piece) {
                CHECK(((x - box.lower()).array() > -1e-5).all());
                CHECK(((box.upper() - x).array() > -1e-5).all());
            }
        }
        CHECK(total == Approx(length(line)).epsilon(1e-4));
        CHECK(length(box.wrapped(line)) == Approx(length(line)).epsilon(1e-12));
        for (const Point2& x : box.wrapped(line)) {
            if (!x.allFinite()) continue;
            CHECK(((x - box.lower()).array() > -1e-12).all());
            CHECK(((box.upper() - x).array() > -1e-12).all());
        }
    }
}

TEST_CASE("what lies on a seam is seen on both sides of it") {
    const ChartBox box({2.0, 2.0}, {0, 0}, {});
    CHECK(box.places({1, 0.3}).size() == 2);
    CHECK(box.places({1 - 1e-13, 1 + 1e-13}).size() == 4);
    CHECK(box.places({5.2, 0.3}).size() == 1);
    const Polyline noisy{{1 + 1e-12, -0.5}, {1 - 1e-12, 0}, {1 + 1e-12, 0.5}};
    const auto pieces = box.pieces(noisy);
    REQUIRE(pieces.size() == 2);
    for (const Polyline& piece : pieces) CHECK(length(piece) == Approx(1));
}

TEST_CASE("where the chart is not periodic the box holds the lines") {
    const std::vector<Polyline> lines{{{-3, 5}, {7, 6}}};
    const ChartBox box({2.0, {}}, {0, 0}, lines);
    CHECK(box.lower().x() == -1);
    CHECK(box.upper().x() == 1);
    CHECK(box.lower().y() < 5);
    CHECK(box.upper().y() > 6);
    CHECK(box.upper().y() < 6.2);
}

TEST_CASE("a thinned line stays within the tolerance and its segments short") {
    Polyline arc;
    for (int i = 0; i <= 1000; ++i) arc.push_back({100 * std::cos(0.003 * i), 100 * std::sin(0.003 * i)});
    const Polyline thin = thinned(arc, 0.2, 30);
    CHECK(thin.size() < 40);
    CHECK(thin.front() == arc.front());
    CHECK(thin.back() == arc.back());
    for (std::size_t i = 1; i < thin.size(); ++i) {
        CHECK((thin[i] - thin[i - 1]).norm() <= 30);
        CHECK(((thin[i] + thin[i - 1]) / 2).norm() > 99.8 - 1e-3);
    }
    const Polyline straight = thinned(Polyline{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}}, 0.1, 2);
    CHECK(straight.size() == 3);
}

TEST_CASE("steps are round and not smaller than asked for") {
    CHECK(round_step(0.42) == Approx(0.5));
    CHECK(round_step(0.5) == Approx(0.5));
    CHECK(round_step(0.21) == Approx(0.25));
    CHECK(round_step(7) == Approx(10));
    CHECK(round_step(1.2e-5) == Approx(2e-5));
}
