// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/max_min_step.h"

#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <limits>
#include <vector>

#include "core/random.h"
#include "tests/support/seed.h"

using namespace dsc::dsc3d;
using dsc::core::Random;
using dsc::geometry::QualityTerm;
using dsc::tests::seed;
using Eigen::Vector3d;

namespace {

double lowest_at(const std::vector<QualityTerm>& terms, const Vector3d& d) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const QualityTerm& term : terms) lowest = std::min(lowest, term.value + term.gradient.dot(d));
    return lowest;
}

double model(const std::vector<QualityTerm>& terms, double s, const Vector3d& d) {
    return lowest_at(terms, d) - d.squaredNorm() / (2 * s);
}

Vector3d random_vector(Random& random) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
    return {x, y, z};
}

// `rank`: of the space of gradients, as for a vertex inside, on a plane, on a line.
std::vector<QualityTerm> random_terms(std::size_t count, int rank, Random& random) {
    const Vector3d normal = random_vector(random).normalized(), line = random_vector(random).normalized();
    std::vector<QualityTerm> terms(count);
    for (QualityTerm& term : terms) {
        term.value = random.uniform(0, 0.3);
        term.gradient = random.uniform(0.1, 3) * random_vector(random);
        if (rank == 2) term.gradient -= normal.dot(term.gradient) * normal;
        if (rank == 1) term.gradient = line.dot(term.gradient) * line;
    }
    return terms;
}

// The multipliers are minimized over the unit simplex by projected coordinate pairs; their value bounds every step's
// value from above. Independent of the active set and slow.
double upper_bound(const std::vector<QualityTerm>& terms, double s) {
    const std::size_t n = terms.size();
    std::vector<double> l(n, 1.0 / static_cast<double>(n));
    Vector3d sum = Vector3d::Zero();
    for (std::size_t k = 0; k < n; ++k) sum += l[k] * terms[k].gradient;
    for (int sweep = 0; sweep < 1000000; ++sweep) {
        // Most violating pair: weight goes from the term with the largest derivative to that with the smallest.
        std::size_t up = 0, down = n;
        const auto slope = [&](std::size_t k) { return terms[k].value + s * terms[k].gradient.dot(sum); };
        for (std::size_t k = 0; k < n; ++k) {
            if (slope(k) < slope(up)) up = k;
            if (l[k] > 0 && (down == n || slope(k) > slope(down))) down = k;
        }
        const double violation = slope(down) - slope(up);
        if (violation < 1e-14) break;
        const Vector3d change = terms[up].gradient - terms[down].gradient;
        const double curvature = s * change.squaredNorm();
        const double share = curvature > 0 ? std::min(l[down], violation / curvature) : l[down];
        l[up] += share;
        l[down] -= share;
        sum += share * change;
    }
    double value = s * sum.squaredNorm() / 2;
    for (std::size_t k = 0; k < n; ++k) value += l[k] * terms[k].value;
    return value;
}

}  // namespace

TEST_CASE("no step has a better model than the one found: the duality gap is zero") {
    Random random(seed(1));
    for (const int rank : {3, 2, 1}) {
        for (int trial = 0; trial < 400; ++trial) {
            const std::size_t count = 1 + random.below(trial % 10 == 0 ? 80 : 12);
            const std::vector<QualityTerm> terms = random_terms(count, rank, random);
            const double s = std::pow(10.0, random.uniform(-4, 1));
            const MaxMinStep found = max_min_step(terms, s);
            INFO("rank " << rank << ", " << count << " terms, s = " << s);
            REQUIRE(found.predicted == Approx(lowest_at(terms, found.step)).margin(1e-14));
            const double value = model(terms, s, found.step), bound = upper_bound(terms, s);
            REQUIRE(value <= bound + 1e-10 * (1 + std::abs(bound)));
            REQUIRE(value >= bound - 1e-7 * (1 + std::abs(bound)));
        }
    }
}

TEST_CASE("no sampled step has a better model than the one found") {
    Random random(seed(2));
    for (int trial = 0; trial < 50; ++trial) {
        const std::vector<QualityTerm> terms = random_terms(1 + random.below(20), 3, random);
        const double s = 0.05;
        const MaxMinStep found = max_min_step(terms, s);
        const double value = model(terms, s, found.step);
        for (int sample = 0; sample < 2000; ++sample) {
            const double reach = std::pow(10.0, random.uniform(-6, 0));
            const Vector3d near = found.step + reach * random_vector(random);
            REQUIRE(model(terms, s, near) <= value + 1e-12);
        }
    }
}

TEST_CASE("one term is followed along its gradient") {
    const std::vector<QualityTerm> terms = {{0.2, Vector3d(1, -2, 3)}};
    const MaxMinStep found = max_min_step(terms, 0.1);
    CHECK((found.step - 0.1 * terms[0].gradient).norm() < 1e-14);
    CHECK(found.predicted == Approx(0.2 + 0.1 * 14));
}

TEST_CASE("where the terms pull against each other nothing is gained") {
    const std::vector<QualityTerm> opposite = {{0.2, Vector3d(1, 0, 0)}, {0.2, Vector3d(-2, 0, 0)}};
    CHECK(max_min_step(opposite, 1).step.norm() < 1e-12);
    std::vector<QualityTerm> simplex;
    for (const Vector3d& g : {Vector3d(1, 1, 1), Vector3d(1, -1, -1), Vector3d(-1, 1, -1), Vector3d(-1, -1, 1)})
        simplex.push_back({0.1, g});
    CHECK(max_min_step(simplex, 10).step.norm() < 1e-9);
}

TEST_CASE("terms that occur twice, or without a gradient, do no harm") {
    Random random(seed(3));
    for (int trial = 0; trial < 100; ++trial) {
        std::vector<QualityTerm> terms = random_terms(6, 3, random);
        const double s = 0.3;
        const double expected = model(terms, s, max_min_step(terms, s).step);
        const std::vector<QualityTerm> once = terms;
        terms.insert(terms.end(), once.begin(), once.end());
        CHECK(model(terms, s, max_min_step(terms, s).step) == Approx(expected).margin(1e-9));
        terms.push_back({-0.1, Vector3d::Zero()});
        CHECK(model(terms, s, max_min_step(terms, s).step) == Approx(-0.1).margin(1e-9));
    }
}
