// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/tetrahedron_quality.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/random.h"
#include "tests/support/seed.h"

using namespace dsc::geometry;

namespace {

constexpr std::array measures = {QualityMeasure::minimum_sine, QualityMeasure::minimum_biased_sine,
                                 QualityMeasure::volume_length, QualityMeasure::radius_ratio};
using Corners = std::array<Point3, 4>;

Corners random_positive(dsc::core::Random& random) {
    const auto point = [&] {
        const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
        return Point3(x, y, z);
    };
    Corners p = {point(), point(), point(), point()};
    if (!is_positive(p[0], p[1], p[2], p[3])) std::swap(p[0], p[1]);
    return p;
}

double quality_of(QualityMeasure measure, const Corners& p) { return quality(measure, p[0], p[1], p[2], p[3]); }

}  // namespace

TEST_CASE("the regular tetrahedron has the known angles and the best ratios") {
    const Corners p = {Point3(1, 1, 1), Point3(-1, 1, -1), Point3(1, -1, -1), Point3(-1, -1, 1)};
    REQUIRE(is_positive(p[0], p[1], p[2], p[3]));
    for (const double angle : dihedral_angles(p[0], p[1], p[2], p[3])) CHECK(angle == Approx(std::acos(1.0 / 3)));
    CHECK(quality_of(QualityMeasure::minimum_sine, p) == Approx(std::sqrt(8.0) / 3));
    CHECK(quality_of(QualityMeasure::minimum_biased_sine, p) == Approx(std::sqrt(8.0) / 3));
    CHECK(quality_of(QualityMeasure::volume_length, p) == Approx(1));
    CHECK(quality_of(QualityMeasure::radius_ratio, p) == Approx(1));
}

TEST_CASE("the sine measures are the least sines of the dihedral angles") {
    dsc::core::Random random(dsc::tests::seed(1));
    for (int i = 0; i < 1000; ++i) {
        const Corners p = random_positive(random);
        double sine = 1, biased = 1;
        for (const double angle : dihedral_angles(p[0], p[1], p[2], p[3])) {
            sine = std::min(sine, std::sin(angle));
            biased = std::min(biased, std::sin(angle) * (angle > std::numbers::pi / 2 ? obtuse_bias : 1));
        }
        REQUIRE(quality_of(QualityMeasure::minimum_sine, p) == Approx(sine).epsilon(1e-9));
        REQUIRE(quality_of(QualityMeasure::minimum_biased_sine, p) == Approx(biased).epsilon(1e-9));
    }
}

TEST_CASE("a quality does not depend on scale, place, rotation, or an even order of the vertices") {
    dsc::core::Random random(dsc::tests::seed(2));
    for (const QualityMeasure measure : measures) {
        for (int i = 0; i < 200; ++i) {
            const Corners p = random_positive(random);
            const double q = quality_of(measure, p);
            REQUIRE(q > 0);
            const Eigen::AngleAxisd turn(random.uniform(0, 6), Point3(1, 2, 3).normalized());
            Corners moved;
            for (int k = 0; k < 4; ++k) moved[k] = 1e-3 * (turn * p[k]) + Point3(0.1, 0.2, 0.3);
            REQUIRE(quality_of(measure, moved) == Approx(q).epsilon(1e-8));
            REQUIRE(quality(measure, p[1], p[2], p[0], p[3]) == Approx(q).epsilon(1e-10));
            REQUIRE(quality(measure, p[1], p[0], p[3], p[2]) == Approx(q).epsilon(1e-10));
            REQUIRE(quality(measure, p[1], p[0], p[2], p[3]) == Approx(-q).epsilon(1e-10));
        }
        CHECK(quality(measure, Point3(0, 0, 0), Point3(1, 0, 0), Point3(0, 1, 0), Point3(1, 1, 0)) == 0);
        CHECK(quality(measure, Point3(0, 0, 0), Point3(0, 0, 0), Point3(0, 0, 0), Point3(0, 0, 0)) == 0);
    }
}

TEST_CASE("a unit of length that is very small or very large changes no bit of a quality") {
    dsc::core::Random random(dsc::tests::seed(4));
    for (int i = 0; i < 100; ++i) {
        const Corners p = random_positive(random);
        for (const double unit : {0x1p-300, 0x1p-200, 0x1p-100, 0x1p100, 0x1p200, 0x1p300}) {
            const Corners q = {unit * p[0], unit * p[1], unit * p[2], unit * p[3]};
            for (const QualityMeasure measure : measures) {
                CHECK(quality_of(measure, q) == quality_of(measure, p));
                std::array<QualityTerm, 6> terms, scaled;
                const int count = quality_terms(measure, p[0], p[1], p[2], p[3], terms);
                REQUIRE(quality_terms(measure, q[0], q[1], q[2], q[3], scaled) == count);
                for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
                    CHECK(scaled[k].value == terms[k].value);
                    CHECK(unit * scaled[k].gradient == terms[k].gradient);
                }
            }
        }
    }
}

TEST_CASE("the quality is the least of its terms, and their gradients are those of differences") {
    dsc::core::Random random(dsc::tests::seed(3));
    const double h = 1e-6;
    for (const QualityMeasure measure : measures) {
        for (int i = 0; i < 300; ++i) {
            const Corners p = random_positive(random);
            if (quality_of(measure, p) < 0.05) continue;
            std::array<QualityTerm, 6> terms, forward, backward;
            const int count = quality_terms(measure, p[0], p[1], p[2], p[3], terms);
            double least = terms[0].value;
            for (int k = 0; k < count; ++k) least = std::min(least, terms[k].value);
            REQUIRE(quality_of(measure, p) == Approx(least).epsilon(1e-12));
            for (int axis = 0; axis < 3; ++axis) {
                const Point3 step = h * Point3::Unit(axis);
                quality_terms(measure, p[0] + step, p[1], p[2], p[3], forward);
                quality_terms(measure, p[0] - step, p[1], p[2], p[3], backward);
                for (int k = 0; k < count; ++k) {
                    if (std::abs(forward[k].value - backward[k].value) > 0.1) continue;  // past the right angle
                    const double difference = (forward[k].value - backward[k].value) / (2 * h);
                    REQUIRE(terms[k].gradient[axis] == Approx(difference).epsilon(1e-5).margin(1e-5));
                }
            }
        }
    }
}
