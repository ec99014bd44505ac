// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic/torus.h"

#include <limits>

#include "core/errors.h"
#include "tests/geodesic/samples.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::geodesic;
using namespace dsc::tests;

TEST_CASE("torus parameters that degenerate the metric are refused with the reason") {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    for (const double lambda : {0.0, -1.0, nan, infinity, 1e-200, 1e200})
        REQUIRE_THROWS_AS(TorusOfRevolution(2, lambda), core::UsageError);
    for (const double radius : {1.0, 0.5, 0.0, -1.0, nan, infinity, -infinity, 1e200})
        REQUIRE_THROWS_AS(TorusOfRevolution(radius, 1), core::UsageError);
    REQUIRE_THROWS_WITH(TorusOfRevolution(1, 1), Catch::Contains("--major-radius") && Catch::Contains("degenerates"));
    REQUIRE_THROWS_WITH(TorusOfRevolution(2, 0), Catch::Contains("--lambda") && Catch::EndsWith("it is 0"));
    REQUIRE_THROWS_WITH(TorusOfRevolution(2, -1e-9), Catch::EndsWith("it is -1e-09"));
}

TEST_CASE("a negative major radius gives the same torus, turned by half a period") {
    const TorusOfRevolution torus(2, 1.5), turned(-2, 1.5);
    core::Random random(tests::seed(1));
    for (int i = 0; i < 100; ++i) {
        const Point2 x = random_point(random);
        const LocalGeometry a = torus.local_geometry(x), b = turned.local_geometry(x + Point2(pi, pi));
        CHECK((components(a.tensor) - components(b.tensor)).norm() < 1e-12);
        CHECK((christoffel_symbols(a) - christoffel_symbols(b)).norm() < 1e-12);
        CHECK(a.curvature == Approx(b.curvature).margin(1e-12));
    }
}

TEST_CASE("a nearly flat section keeps its accuracy") {
    const double lambda = 1e-6;
    const TorusOfRevolution torus(2, lambda);
    CHECK(torus.tensor({0, 0}).G == Approx(lambda * lambda).epsilon(1e-14));
    CHECK(torus.local_geometry({0, 0}).curvature == Approx(1 / (3 * lambda * lambda)).epsilon(1e-14));
}
