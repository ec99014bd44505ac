// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/edge_flip.h"

#include <catch2/catch.hpp>

#include "surface/triangle.h"
#include "tests/support/seed.h"
#include "tests/surface/rings.h"

using namespace dsc;
using namespace dsc::surface;

namespace {

/// a and b on the z axis, c and d on either side; the edge ab bends by `bend` [degree].
struct Pair {
    Point3 a, b, c, d;
    Pair(double half_edge, double reach_c, double reach_d, double bend)
        : a(0, 0, -half_edge),
          b(0, 0, half_edge),
          c(reach_c, 0, 0),
          d(-reach_d * std::cos(radians(bend)), reach_d * std::sin(radians(bend)), 0) {}
    std::optional<double> gain(const FlipParameters& parameters = {}) const {
        return flip_gain(a, b, c, d, parameters);
    }
};

}  // namespace

TEST_CASE("in a plane the flip is that of Delaunay") {
    core::Random random(tests::seed(1));
    int flips = 0;
    for (int i = 0; i < 2000; ++i) {
        const Eigen::Affine3d placement = tests::random_placement(random);
        const auto point = [&](double low, double high) -> geometry::Point2 {
            const double x = random.uniform(low, high);
            return {x, random.uniform(-1, 1)};
        };
        const geometry::Point2 a(0, -0.5), b(0, 0.5), c = point(-1, -0.05), d = point(0.05, 1);
        const auto lifted = [&](const geometry::Point2& p) -> Point3 { return placement * Point3(p.x(), p.y(), 0); };
        const bool is_delaunay = geometry::in_circle(a, b, c, d) != geometry::Sign::positive;
        const auto gain = flip_gain(lifted(a), lifted(b), lifted(c), lifted(d), {.min_gain = 0});
        const bool is_convex = geometry::is_counterclockwise(a, d, c) && geometry::is_counterclockwise(d, b, c);
        CHECK(gain.has_value() == (!is_delaunay && is_convex));
        flips += gain.has_value();
    }
    CHECK(flips > 200);
}

TEST_CASE("a gain is the rise of the smallest angle, and the flip back gains nothing") {
    const Pair pair(1, 0.3, 0.3, 0);
    const double before = std::atan(0.3), after = std::min(2 * std::atan(0.3), std::numbers::pi / 2 - std::atan(0.3));
    CHECK(pair.gain().value() == Approx((after - before) / radians(1)));
    CHECK_FALSE(flip_gain(pair.c, pair.d, pair.b, pair.a, {}).has_value());
    CHECK(pair.gain({.min_gain = 16}).has_value());
    CHECK_FALSE(pair.gain({.min_gain = 17}).has_value());
}

TEST_CASE("feature edges and curved pairs stay") {
    CHECK(Pair(0.55, 0.5, 0.5, 0).gain().has_value());
    CHECK(Pair(0.55, 0.5, 0.5, 3).gain().has_value());
    CHECK_FALSE(Pair(0.55, 0.5, 0.5, 25).gain().has_value());  // too much volume
    CHECK(Pair(0.55, 0.5, 0.5, 25).gain({.max_volume = 0.11}).has_value());
    CHECK_FALSE(Pair(0.55, 0.5, 0.5, 42).gain({.max_volume = 0.11}).has_value());  // a ridge
    CHECK(Pair(0.55, 0.5, 0.5, 42).gain({.feature_angle = 43, .max_volume = 0.11}).has_value());
    CHECK_FALSE(Pair(1, 1e-3, 1e-3, 90).gain({.min_gain = 0}).has_value());  // a ridge of needles
}

TEST_CASE("the normal of a needle does not make a flat pair a ridge") {
    // c lies beside ab by far less than rounding of a real coordinate, on the wrong side of the plane.
    const Pair pair(1, 1e-12, 0.7, 0);
    const Point3 c = pair.c + Vector3(0, 1e-12, 0);
    CHECK(flip_gain(pair.a, pair.b, c, pair.d, {}).has_value());
}

TEST_CASE("flatness is that of two equilateral triangles, and does not depend on scale") {
    for (const double angle : {0.0, 1.0, 10.0, 60.0}) {
        for (const double scale : {1e-6, 1.0, 1e6}) {
            const Point3 a(0, 0, 0), b(0, 0, scale), c(scale * std::sqrt(0.75), 0, scale / 2);
            const double s = std::sin(radians(angle)), k = std::cos(radians(angle));
            const Point3 d(-k * scale * std::sqrt(0.75), s * scale * std::sqrt(0.75), scale / 2);
            const double other = (d - c).norm() / scale;
            const double longest = std::max(1.0, other);
            CHECK(flatness(a, b, c, d) * longest * longest * longest == Approx(s / 8).margin(1e-15));
        }
    }
    CHECK(flatness(Point3::Zero(), Point3::Zero(), Point3::Zero(), Point3::Zero()) == 0);
}

TEST_CASE("flip parameters out of their range are refused by name") {
    CHECK_THROWS_WITH(FlipParameters{.max_volume = 1}.validate(), Catch::StartsWith("max_volume"));
    CHECK_THROWS_WITH(FlipParameters{.min_gain = -1}.validate(), Catch::StartsWith("min_gain"));
    CHECK_NOTHROW(FlipParameters{}.validate());
}
