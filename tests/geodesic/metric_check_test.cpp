// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic/metric_check.h"

#include "core/errors.h"
#include "geodesic/expression_metric.h"
#include "geodesic/torus.h"
#include "tests/geodesic/samples.h"

using namespace dsc;
using namespace dsc::geodesic;
using namespace dsc::tests;
using Catch::Contains;

TEST_CASE("regular periodic metrics pass the check") {
    REQUIRE_NOTHROW(check_metric(TorusOfRevolution(2, 1), "--torus"));
    REQUIRE_NOTHROW(check_metric(TorusOfRevolution(1.001, 0.001), "--torus"));
    REQUIRE_NOTHROW(check_metric(ExpressionEmbedding(bumpy_embedding, torus_periods), "--embedding"));
    REQUIRE_NOTHROW(check_metric(ExpressionMetric(skew_tensor, torus_periods), "--metric"));
    REQUIRE_NOTHROW(check_metric(ExpressionMetric("E=1e-9;F=0;G=1e-9", torus_periods), "--metric"));
    // A cylinder, periodic in u only; a position need not be periodic, only the metric.
    REQUIRE_NOTHROW(check_metric(ExpressionEmbedding("x=cos(u);y=sin(u);z=v+v^3", {2 * pi, {}}), "--embedding"));
    REQUIRE_NOTHROW(check_metric(ExpressionEmbedding("x=v*cos(u);y=v*sin(u);z=u", {2 * pi, {}}), "--embedding"));
    // A sphere's pole at u = 0 lies outside of the strip that is asked for.
    MetricCheckParameters strip;
    strip.center = {1.5, 0};
    REQUIRE_NOTHROW(check_metric(ExpressionMetric("E=1;F=0;G=sin(u)^2", {{}, 2 * pi}), "--metric", strip));
}

TEST_CASE("a metric that is not positive definite is refused with the place") {
    const auto check = [](const std::string& text) { check_metric(ExpressionMetric(text, torus_periods), "--metric"); };
    REQUIRE_THROWS_AS(check("E=1;F=0;G=cos(u)"), core::InputError);
    REQUIRE_THROWS_WITH(check("E=1;F=0;G=cos(u)"), Contains("--metric: u = ") && Contains("not positive definite"));
    REQUIRE_THROWS_WITH(check("E=-1;F=0;G=-1"), Contains("not positive definite"));
    REQUIRE_THROWS_WITH(check("E=1;F=2;G=1"), Contains("E G - F^2 = -3"));
    // Negative in a spot far smaller than the grid spacing, and zero on a curve between the grid points.
    REQUIRE_THROWS_WITH(check("E=1;F=0;G=1.0001-1.0002*((cos((u-0.34)/2)*cos((v-1.2)/2))^1000)^10"),
                        Contains("u = 0.3"));
    REQUIRE_THROWS_WITH(check_metric(ExpressionEmbedding(torus_embedding(0.99, 1), torus_periods), "--embedding"),
                        Contains("--embedding: u = ") && Contains("degenerate to rounding"));
    REQUIRE_THROWS_WITH(check_metric(ExpressionEmbedding("x=u;y=2*u;z=0", {}), "--embedding"),
                        Contains("not positive definite"));
}

TEST_CASE("a metric that is not finite is refused with the place") {
    const auto check = [](const std::string& text) { check_metric(ExpressionMetric(text, torus_periods), "--metric"); };
    REQUIRE_THROWS_WITH(check("E=1;F=0;G=1/u^2"), Contains("not finite") && Contains("u = 0"));
    REQUIRE_THROWS_WITH(check("E=1;F=0;G=1/sin(u)^2"), Contains("degenerate to rounding"));
    REQUIRE_THROWS_WITH(check("E=1;F=0;G=sqrt(cos(v))"), Contains("not finite") && Contains("v = "));
    REQUIRE_THROWS_WITH(check("E=1;F=0;G=exp(1000+sin(u))"), Contains("not finite"));
}

TEST_CASE("a wrong period is refused with the place and the direction") {
    const auto check = [](const std::string& text, const ChartPeriods& periods) {
        check_metric(ExpressionMetric(text, periods), "--metric");
    };
    REQUIRE_THROWS_WITH(check("E=2+cos(u);F=0;G=2+cos(v)", {2 * pi, 6.28}), Contains("6.28 in v"));
    REQUIRE_THROWS_WITH(check("E=2+cos(u);F=0;G=2+cos(v)", {6.283, 2 * pi}), Contains("6.283 in u"));
    REQUIRE_THROWS_WITH(check("E=2+cos(u/2);F=0;G=1", torus_periods), Contains("changes by a fraction"));
    REQUIRE_THROWS_WITH(check("E=1e-6*(2+cos(u/2));F=0;G=1e-6", torus_periods), Contains("in u"));
    REQUIRE_THROWS_WITH(check("E=1+u^2;F=0;G=1", torus_periods), Contains("--period"));
    REQUIRE_NOTHROW(check("E=2+cos(u);F=0;G=2+cos(v)", {2 * pi, 4 * pi}));
}
