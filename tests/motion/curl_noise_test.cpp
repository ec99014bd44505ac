// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/curl_noise.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <vector>

#include "core/errors.h"
#include "core/random.h"
#include "motion/runge_kutta.h"
#include "tests/motion/divergence.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::motion;

namespace {

template <int Dimension>
Vector<Dimension> random_point(core::Random& random, const CurlNoiseParameters<Dimension>& parameters) {
    Vector<Dimension> x = parameters.low;
    for (int k = 0; k < Dimension; ++k) x[k] += random.uniform() * (parameters.high - parameters.low)[k];
    return x;
}

/// The largest speed around x, by random steps that become shorter.
template <int Dimension>
double climbed(const VelocityField<Dimension>& field, const CurlNoiseParameters<Dimension>& parameters,
               Vector<Dimension> x, core::Random& random) {
    double height = field(x, 0).norm();
    for (double length = 0.02; length > 1e-6; length *= 0.98) {
        Vector<Dimension> next = x;
        for (double& coordinate : next) coordinate += length * random.uniform(-1, 1);
        next = next.cwiseMax(parameters.low).cwiseMin(parameters.high);
        const double there = field(next, 0).norm();
        if (there > height) x = next, height = there;
    }
    return height;
}

template <int Dimension>
void check(const CurlNoiseParameters<Dimension>& parameters) {
    core::Random random(tests::seed(1));
    const VelocityField<Dimension> field = curl_noise(parameters), same = curl_noise(parameters);
    for (int i = 0; i < 100; ++i) {
        const Vector<Dimension> x = random_point(random, parameters);
        CHECK(field(x, 0) == same(x, 5));
        // What the differences leave falls with their square.
        CHECK(std::abs(tests::divergence<Dimension>(field, x, 0, 1e-3)) < 0.1);
        CHECK(std::abs(tests::divergence<Dimension>(field, x, 0, 1e-4)) < 1e-3);
    }
    std::vector<Vector<Dimension>> places;
    for (int i = 0; i < 10'000; ++i) places.push_back(random_point(random, parameters));
    std::ranges::partial_sort(places, places.begin() + 50, std::greater<>(),
                              [&](const Vector<Dimension>& x) { return field(x, 0).norm(); });
    double largest = 0;
    for (std::size_t i = 0; i < 50; ++i) {
        largest = std::max(largest, climbed<Dimension>(field, parameters, places[i], random));
    }
    CHECK(largest == Approx(parameters.max_speed).epsilon(1e-5));
}

}  // namespace

TEST_CASE("curl noise has no divergence, and its speed reaches the largest one and stays below it") {
    check<3>({.seed = 1});
    check<3>({.low = {-1, 0, 2}, .high = {1, 1, 3}, .has_walls = true, .max_speed = 0.3, .seed = 2});
    check<2>({.max_speed = 2, .seed = 3});
    check<2>({.has_walls = true, .waves = 5, .max_frequency = 2, .seed = 4});
}

TEST_CASE("nothing crosses the walls, and what starts inside stays inside") {
    const CurlNoiseParameters<3> parameters{.low = {-1, 0, 2}, .high = {1, 1, 3}, .has_walls = true, .seed = 5};
    const VelocityField<3> field = curl_noise(parameters);
    core::Random random(tests::seed(2));
    for (int i = 0; i < 100; ++i) {
        for (int k = 0; k < 3; ++k) {
            Vector<3> x = random_point(random, parameters);
            x[k] = random.below(2) == 0 ? parameters.low[k] : parameters.high[k];
            CHECK(std::abs(field(x, 0)[k]) < 1e-14);
        }
    }
    const RungeKuttaFlow<3> flow(field);
    Vector<3> x = random_point(random, parameters);
    for (int step = 0; step < 2000; ++step) {
        x = flow.at(x, 0, 0.02);
        REQUIRE((x.array() >= parameters.low.array()).all());
        REQUIRE((x.array() <= parameters.high.array()).all());
    }
}

TEST_CASE("without walls the noise repeats itself by the box") {
    const VelocityField<3> field = curl_noise(CurlNoiseParameters<3>{.high = {1, 2, 1}, .seed = 6});
    core::Random random(tests::seed(3));
    for (int i = 0; i < 100; ++i) {
        const Vector<3> x(random.uniform(), random.uniform(), random.uniform());
        CHECK((field(x, 0) - field(x + Vector<3>(1, -2, 3), 0)).norm() < 1e-12);
    }
}

TEST_CASE("another seed gives another noise") {
    const VelocityField<2> a = curl_noise(CurlNoiseParameters<2>{.seed = 1});
    const VelocityField<2> b = curl_noise(CurlNoiseParameters<2>{.seed = 2});
    CHECK((a({0.3, 0.4}, 0) - b({0.3, 0.4}, 0)).norm() > 1e-3);
}

TEST_CASE("noise parameters out of their range are refused by name") {
    CHECK_THROWS_WITH((CurlNoiseParameters<2>{.low = {0, 0}, .high = {1, 0}}.validate()), Catch::StartsWith("high"));
    CHECK_THROWS_WITH(curl_noise(CurlNoiseParameters<3>{.waves = 0}), Catch::StartsWith("waves"));
    CHECK_THROWS_AS(curl_noise(CurlNoiseParameters<3>{.max_frequency = 0.5}), core::UsageError);
}
