// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/number.h"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "core/random.h"
#include "tests/support/seed.h"

using namespace dsc::io;

TEST_CASE("every double is read back as the same bits") {
    dsc::core::Random random(dsc::tests::seed(5));
    for (int i = 0; i < 200000; ++i) {
        const double x = std::bit_cast<double>(random.below(std::numeric_limits<std::uint64_t>::max()));
        if (!std::isfinite(x)) continue;
        const auto back = parse_finite(number_text(x));
        REQUIRE((back && std::bit_cast<std::uint64_t>(*back) == std::bit_cast<std::uint64_t>(x)));
    }
}

TEST_CASE("numbers are short where they can be, and have the digits asked for") {
    CHECK(number_text(3) == "3");
    CHECK(number_text(0.1) == "0.1");
    CHECK(number_text(1.0 / 3, 5) == "0.33333");
    CHECK(number_text(std::nan("")) == "nan");
}

TEST_CASE("only finite numbers are accepted, and only whole texts") {
    CHECK(parse_finite("+2.5e-3") == 2.5e-3);
    CHECK(parse_finite("-1") == -1.0);
    for (const char* text : {"", "+", "-", "nan", "inf", "-inf", "1e999", "1x", " 1", "1 ", "+-1", "0x10", "1,5"}) {
        INFO(text);
        CHECK_FALSE(parse_finite(text));
    }
}
