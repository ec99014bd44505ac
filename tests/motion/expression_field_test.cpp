// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/expression_field.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <thread>

#include "core/errors.h"
#include "core/random.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::motion;

namespace {

std::string message(const std::string& text) {
    try {
        expression_field<3>(text);
    } catch (const core::InputError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST_CASE("expressions mean what they say") {
    const double x = 0.3, y = -1.7, z = 2.5, t = 0.9;
    struct Case {
        std::string text;
        double expected;
    };
    const std::vector<Case> cases{
        {"1.5e-3", 1.5e-3},
        {"-x^2", -x * x},
        {"2^3^2", 512},
        {"x - y - z", x - y - z},
        {"x / y * z", x / y * z},
        {"sin(pi*x)*cos(t)", std::sin(std::numbers::pi * x) * std::cos(t)},
        {"log(z) + log10(z)", std::log(z) + std::log10(z)},
        {"exp(1) - e", 0},
        {"sqrt(abs(y))", std::sqrt(1.7)},
        {"max(x, y) + min(x, z)", x + x},
        {"atan2(y, x)", std::atan2(y, x)},
        {"x > 0 ? z : -z", z},
        {"x >= 0 && y != 0", 1},
    };
    for (const auto& [text, expected] : cases) {
        INFO(text);
        CHECK(expression_field<3>("(" + text + ", 0, 0)")({x, y, z}, t).x() == Approx(expected).margin(1e-15));
        CHECK(expression_field<3>("0, " + text + ", 0")({x, y, z}, t).y() == Approx(expected).margin(1e-15));
    }
}

TEST_CASE("a rotation by expressions is a rotation, in 2D and 3D, with or without parentheses") {
    core::Random random(tests::seed(1));
    const auto bare = expression_field<3>("-y, x, 0");
    const auto wrapped = expression_field<3>("  ( -y , x, 0 ) ");
    const auto inner = expression_field<3>("(-y), (x), (0)");
    const auto plane = expression_field<2>("(-y, x)");
    for (int i = 0; i < 100; ++i) {
        const Vector<3> p(random.uniform(), random.uniform(), random.uniform());
        const Vector<3> expected(-p.y(), p.x(), 0);
        CHECK(bare(p, 0) == expected);
        CHECK(wrapped(p, 1) == expected);
        CHECK(inner(p, 2) == expected);
        CHECK(plane(p.head<2>(), 3) == expected.head<2>());
    }
}

TEST_CASE("complaints name the column") {
    CHECK(message("(-y, x)") ==
          "--velocity: column 2: has 2 components where 3 are needed; write (X, Y, Z), for example "
          "(-y, x, 0)");
    CHECK_THAT(message(""), Catch::Contains("has 1 components"));
    CHECK_THAT(message("(-y, x, w)"), Catch::StartsWith("--velocity: column 9: unknown name at 'w'"));
    CHECK_THAT(message("(-y, x*, 0)"), Catch::StartsWith("--velocity: column "));
    CHECK_THAT(message("(-y, , 0)"), Catch::Contains("column 5: the expression is empty"));
    CHECK_THAT(message("(-y, x), 0)"), Catch::Contains("column 11: this ')' has no '('"));
    CHECK_THAT(message("-y, (x, 0"), Catch::Contains("a '(' is not closed"));
    CHECK_THAT(message("x = 3, 0, 0"), Catch::Contains("column 3: unexpected '='"));
    CHECK_THAT(message("sin(), 0, 0"), Catch::StartsWith("--velocity: column "));
    CHECK_THAT(message("x y, 0, 0"), Catch::StartsWith("--velocity: column "));
    CHECK_THAT(message("\"text\", 0, 0"), Catch::StartsWith("--velocity: column "));
    CHECK_THAT(message("(x, y), 0, 0"), Catch::StartsWith("--velocity: column "));
    CHECK_THAT(message(std::string(20'000, '1')), Catch::Contains("too long"));
    CHECK_THROWS_WITH(expression_field<2>("(z, 0)", "--field"), Catch::StartsWith("--field: column 2: unknown name"));
}

TEST_CASE("many threads get the values of one") {
    const auto field = expression_field<3>("(sin(x + t), x*y, exp(z))");
    std::vector<std::thread> threads;
    std::array<bool, 4> is_right{};
    for (std::size_t k = 0; k < is_right.size(); ++k) {
        threads.emplace_back([&, k] {
            bool good = true;
            for (int i = 0; i < 2000; ++i) {
                const double a = 0.001 * i + static_cast<double>(k);
                const Vector<3> v = field({a, 2, 0.5}, 1);
                good = good && v == Vector<3>(std::sin(a + 1), a * 2, std::exp(0.5));
            }
            is_right[k] = good;
        });
    }
    for (std::thread& thread : threads) thread.join();
    for (const bool good : is_right) CHECK(good);
}

TEST_CASE("what is not finite is passed on") {
    CHECK(std::isnan(expression_field<2>("sqrt(x), 0")({-1, 0}, 0).x()));
    CHECK(std::isinf(expression_field<2>("1/x, 0")({0, 0}, 0).x()));
}
