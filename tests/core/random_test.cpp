// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"

#include <catch2/catch.hpp>
#include <cstdlib>

#include "tests/support/seed.h"

using dsc::core::Random;

TEST_CASE("random numbers are the same on every platform for the same seed") {
    Random random(42);
    // The 64-bit Mersenne twister is fixed by the C++ standard; these are its first values for this seed.
    std::mt19937_64 reference(42);
    for (int i = 0; i < 100; ++i)
        CHECK(random.uniform() == static_cast<double>(reference() >> 11) / 9007199254740992.0);
}

TEST_CASE("random numbers stay in their range") {
    Random random(dsc::tests::seed(7));
    for (int i = 0; i < 10000; ++i) {
        const double x = random.uniform(-2.0, 3.0);
        REQUIRE((x >= -2.0 && x < 3.0));
        REQUIRE(random.below(5) < 5);
    }
}

TEST_CASE("every value of a small range occurs about equally often") {
    Random random(dsc::tests::seed(3));
    int count[6] = {};
    for (int i = 0; i < 60000; ++i) ++count[random.below(6)];
    for (const int n : count) CHECK(std::abs(n - 10000) < 500);
}
