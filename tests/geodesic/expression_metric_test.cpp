// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic/expression_metric.h"

#include <bit>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <limits>
#include <thread>

#include "core/errors.h"
#include "tests/geodesic/samples.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::geodesic;
using namespace dsc::tests;

namespace {

/// The value of one expression at (u, v).
double value(const std::string& expression, double u, double v) {
    return ExpressionMetric(std::string("E=").append(expression).append(";F=0;G=1"), {}).tensor({u, v}).E;
}

/// Long derivatives with differences that may come in either sign and sums in any order.
const std::vector<std::string>& tangled_embeddings() {
    static const std::vector<std::string> texts{
        bumpy_embedding,
        "x=(u-v)^3*sin(u-v)/(2+cos(v-3*u))^2; y=sqrt(3+u*v-(v-2*u)^2/70)*exp(sin(u)*cos(v));"
        "z=tan(u/5-v/7)^3+log(5+u-v)*pow(2+cos(u),1.3)+atan(u*v)+cosh(v/2)*tanh(u)"};
    return texts;
}

std::uint64_t bits(const Metric& metric) {
    std::uint64_t hash = 0xCBF29CE484222325ULL;
    const auto take = [&](double number) { hash = (hash ^ std::bit_cast<std::uint64_t>(number)) * 0x100000001B3ULL; };
    for (int i = 0; i < 100; ++i) {
        const Point2 x{0.01 * i, 0.3 - 0.007 * i};
        const LocalGeometry local = metric.local_geometry(x);
        take(local.tensor.E), take(local.tensor.F), take(local.tensor.G), take(local.curvature);
        take(local.curvature_gradient.x()), take(local.curvature_gradient.y());
        for (const double symbol : christoffel_symbols(local)) take(symbol);
        for (const Vector2& gradient : metric.connection_jet(x).christoffel_u_gradient)
            take(gradient.x()), take(gradient.y());
        const Point3 position = metric.position(x).value();
        take(position.x()), take(position.y()), take(position.z());
    }
    return hash;
}

}  // namespace

TEST_CASE("expressions mean what they say") {
    struct Case {
        std::string expression;
        std::function<double(double, double)> expected;
    };
    const std::vector<Case> cases{
        {"u", [](double u, double) { return u; }},
        {" ( u ) ", [](double u, double) { return u; }},
        {"-u^2", [](double u, double) { return -(u * u); }},
        {"(-u)^2", [](double u, double) { return u * u; }},
        {"2^3^2+0*u", [](double, double) { return 512; }},
        {"2^-1*u", [](double u, double) { return u / 2; }},
        {"u-v-1", [](double u, double v) { return u - v - 1; }},
        {"u/v/2", [](double u, double v) { return u / v / 2; }},
        {"u/v*2", [](double u, double v) { return u / v * 2; }},
        {"--u + +v - -1", [](double u, double v) { return u + v + 1; }},
        {"u*-v", [](double u, double v) { return -u * v; }},
        {"u^-2", [](double u, double) { return 1 / (u * u); }},
        {"u^0.5+v^1.5", [](double u, double v) { return std::sqrt(u) + std::pow(v, 1.5); }},
        {"u^v", [](double u, double v) { return std::pow(u, v); }},
        {"pow(u, v/3)", [](double u, double v) { return std::pow(u, v / 3); }},
        {"u^(1/3)", [](double u, double) { return std::cbrt(u); }},
        {"e^u+exp(v)", [](double u, double v) { return std::exp(u) + std::exp(v); }},
        {"e*pi*u", [](double u, double) { return std::numbers::e * pi * u; }},
        {"1e-3*u+2.5E+2+.5+3.", [](double u, double) { return 0.001 * u + 253.5; }},
        {"sin(u)+cos(v)+tan(u)", [](double u, double v) { return std::sin(u) + std::cos(v) + std::tan(u); }},
        {"asin(u/9)*acos(v/9)-atan(u)",
         [](double u, double v) { return std::asin(u / 9) * std::acos(v / 9) - std::atan(u); }},
        {"sinh(u)-cosh(v)*tanh(u)", [](double u, double v) { return std::sinh(u) - std::cosh(v) * std::tanh(u); }},
        {"log(u)/log(10)", [](double u, double) { return std::log10(u); }},
        {"log(e^3)*u", [](double u, double) { return 3 * u; }},
        {"sqrt(u*v)", [](double u, double v) { return std::sqrt(u * v); }},
        {"sqrt(u^2)", [](double u, double) { return std::abs(u); }},
        {"cos(pi/5)*sin(1/2)*sqrt(2)+u",
         [](double u, double) { return std::cos(pi / 5) * std::sin(0.5) * std::sqrt(2) + u; }},
        {"1/3", [](double, double) { return 1.0 / 3; }},
        {"0.1+0.2", [](double, double) { return 0.3; }},  // decimal literals are exact
    };
    core::Random random(tests::seed(7));
    for (const Case& c : cases) {
        INFO(c.expression);
        for (int i = 0; i < 20; ++i) {
            const double u = random.uniform(0.2, 3), v = random.uniform(0.2, 3);
            REQUIRE(value(c.expression, u, v) == Approx(c.expected(u, v)).epsilon(1e-14).margin(1e-15));
        }
    }
    CHECK(value("sqrt(u^2)", -2, 0) == 2);
    CHECK(std::isnan(value("sqrt(u)", -2, 0)));
    CHECK(value("0.1+0.2", 0, 0) == 0.3);
}

TEST_CASE("every derivative of every function agrees with differences") {
    // One expression per rule of differentiation; E G = 1 keeps the symbols simple, and K takes second derivatives.
    for (const std::string text :
         {"sin(u+2*v)", "cos(u*v)", "tan(u/4+v/5)", "asin(u*v/9)", "acos(u/5-v/7)", "atan(u-v)", "sinh(u-v)",
          "cosh(u*v/2)", "tanh(u+v)", "exp(u*v/3)", "log(2+u+v)", "sqrt(3+u*v)", "pow(2+u,v)", "(u+v)^7/(2+u*v)",
          "(2+u+v)^(-3/2)", "pow(1+u^2+v^2,0.3)"}) {
        INFO(text);
        const ExpressionMetric metric("E=3+(" + text + ")^2/20;F=" + text + "/10;G=2+v^2/9", {});
        for (const Point2& x : {Point2{0.4, 0.3}, Point2{0.9, -0.2}, Point2{1.1, 0.8}}) {
            const LocalGeometry local = metric.local_geometry(x);
            const ConnectionJet jet = metric.connection_jet(x);
            for (int direction = 0; direction < 2; ++direction) {
                const double slope = derivative(
                    [&](double h) {
                        return Eigen::Matrix<double, 1, 1>(metric.local_geometry(moved(x, direction, h)).curvature);
                    },
                    0.005)(0);
                CHECK(local.curvature_gradient[direction] == Approx(slope).epsilon(1e-7).margin(1e-8));
                const auto symbols = derivative(
                    [&](double h) { return christoffel_symbols(metric.local_geometry(moved(x, direction, h))); },
                    0.005);
                CHECK(jet.christoffel_u_gradient[0][direction] == Approx(symbols(0)).epsilon(1e-7).margin(1e-8));
                CHECK(jet.christoffel_v_gradient[1][direction] == Approx(symbols(4)).epsilon(1e-7).margin(1e-8));
            }
        }
    }
}

TEST_CASE("components come in any order, and a last semicolon is allowed") {
    const ExpressionMetric metric("G = 3 ;E=1; F=\t0.5;", {});
    const MetricTensor tensor = metric.tensor({0, 0});
    CHECK(tensor.E == 1);
    CHECK(tensor.F == 0.5);
    CHECK(tensor.G == 3);
    CHECK_FALSE(metric.position({0, 0}).has_value());
}

TEST_CASE("periods of expressions must be positive") {
    for (const double period :
         {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        REQUIRE_THROWS_AS(ExpressionMetric("E=1;F=0;G=1", {period, 1}), core::UsageError);
        REQUIRE_THROWS_AS(ExpressionMetric("E=1;F=0;G=1", {{}, period}), core::UsageError);
    }
}

TEST_CASE("programs longer than one muParser expression are evaluated in pieces") {
    std::string sum = "0";
    double expected = 0, expected_u = 0;
    for (int i = 1; i <= 300; ++i) {
        sum += "+sin(" + std::to_string(i) + "*u+v)/" + std::to_string(i * i);
        expected += std::sin(i * 0.1 + 0.2) / (i * i);
        expected_u += std::cos(i * 0.1 + 0.2) / i;
    }
    const ExpressionMetric metric("E=3+" + sum + ";F=0;G=1", {});
    CHECK(metric.tensor({0.1, 0.2}).E == Approx(3 + expected).epsilon(1e-13));
    CHECK(metric.local_geometry({0.1, 0.2}).christoffel_u[0] == Approx(expected_u / 2 / (3 + expected)).epsilon(1e-12));
}

TEST_CASE("expressions have the same bits in two instances and in four threads") {
    for (const std::string& text : tangled_embeddings()) {
        const ExpressionEmbedding first(text, {}), second(text, {});
        const std::uint64_t expected = bits(first);
        CHECK(bits(second) == expected);
        std::vector<std::uint64_t> found(4);
        {
            std::vector<std::jthread> threads;
            for (std::uint64_t& result : found)
                threads.emplace_back([&result, &first, &text] {
                    result = bits(first);
                    result ^= bits(first) ^ bits(ExpressionEmbedding(text, {}));
                });
        }
        for (const std::uint64_t result : found) CHECK(result == expected);
    }
}

TEST_CASE("prints the bits of expression metrics", "[.]") {
    for (const std::string& text : tangled_embeddings())
        std::printf("bits %016llx\n", static_cast<unsigned long long>(bits(ExpressionEmbedding(text, {}))));
}
