// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/generate/shapes.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/errors.h"
#include "tests/dsc3d/generate/surface_figures.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;
using std::numbers::pi;

namespace {

const Point3 shape_centre(0.3, -0.2, 0.5);

// Errors of the volume at an edge length, at half of it and at a quarter: it has to converge with its square.
template <class Surface>
void require_second_order(const Surface& surface, double edge_length, double volume) {
    std::vector<double> error;
    for (const double part : {1.0, 0.5, 0.25})
        error.push_back(std::abs(*require_closed(surface(part * edge_length)).volume - volume));
    CHECK(error[0] < 0.05 * volume);
    CHECK(error[1] < error[0] / 3.4);
    CHECK(error[2] < error[1] / 3.4);
}

}  // namespace

TEST_CASE("an icosphere of any frequency has 20 f^2 triangles, all alike, and its vertices on the sphere") {
    for (const std::uint32_t frequency : {1u, 2u, 3u, 6u, 8u, 16u}) {
        CAPTURE(frequency);
        const geometry::SurfaceData surface = icosphere(shape_centre, 0.3, frequency);
        CHECK(surface.triangles.size() == 20 * frequency * frequency);
        CHECK(surface.vertices.size() == 10 * frequency * frequency + 2);
        CHECK(*require_closed(surface).genus == 0);
        for (const Point3& p : surface.vertices) REQUIRE((p - shape_centre).norm() == Approx(0.3).epsilon(1e-14));
        const TriangleFigures triangles(surface);
        CHECK(triangles.least_angle > 50);
        CHECK(triangles.longest < 1.3 * triangles.shortest);
    }
}

TEST_CASE("the frequency of an icosphere follows from the edge length") {
    for (const double edge_length : {0.1, 0.045, 0.02}) {
        const geometry::SurfaceData surface = icosphere(shape_centre, 0.3, icosphere_frequency(0.3, edge_length));
        const TriangleFigures triangles(surface);
        CHECK(triangles.mean == Approx(edge_length).epsilon(0.15));
    }
    require_second_order([](double length) { return icosphere(shape_centre, 0.3, icosphere_frequency(0.3, length)); },
                         0.3 * std::sqrt(4 * pi / 20 / 16 / std::sqrt(3.0) * 4), 4 * pi / 3 * 0.027);
}

TEST_CASE("two spheres are one gap apart") {
    const geometry::SurfaceData surface = two_spheres(shape_centre, 0.15, 0.01, 8);
    const geometry::SurfaceCheck check = require_closed(surface);
    CHECK(check.components == 2);
    CHECK(check.euler_characteristic == 4);
    double left = -1e9, right = 1e9;
    for (const Point3& p : surface.vertices) {
        const double side = p.x() < shape_centre.x() ? -1 : 1;
        REQUIRE((p - shape_centre - side * Point3(0.155, 0, 0)).norm() == Approx(0.15).epsilon(1e-14));
        (side < 0 ? left : right) = side < 0 ? std::max(left, p.x()) : std::min(right, p.x());
    }
    // The vertices nearest to the axis are on it or nearly so.
    CHECK(right - left >= 0.01 * (1 - 1e-12));
    CHECK(right - left < 0.015);
}

TEST_CASE("a torus has genus 1, its vertices on the torus, and its volume converges") {
    const geometry::SurfaceData surface = torus(shape_centre, 0.3, 0.1, 0.05);
    CHECK(*require_closed(surface).genus == 1);
    for (const Point3& p : surface.vertices) {
        const Point3 q = p - shape_centre;
        REQUIRE(std::hypot(std::hypot(q.x(), q.y()) - 0.3, q.z()) == Approx(0.1).epsilon(1e-13));
    }
    CHECK(TriangleFigures(surface).least_angle > 40);
    CHECK(TriangleFigures(torus(shape_centre, 0.3, 0.15, 0.05)).least_angle > 30);
    CHECK(TriangleFigures(surface).longest < 1.5 * 0.05);
    require_second_order([](double length) { return torus(shape_centre, 0.3, 0.1, length); }, 0.06,
                         2 * pi * pi * 0.3 * 0.01);
}

TEST_CASE("a dumbbell has genus 0, round balls and a thin neck, and its volume converges") {
    const DumbbellSize size;
    const geometry::SurfaceData surface = dumbbell(shape_centre, size, 0.05);
    CHECK(*require_closed(surface).genus == 0);
    // The arc of the neck has radius 0.425 (from touching the balls) and its centre 0.525 above the axis; it touches
    // the ball at 0.5 - 0.3 * 0.5 / 0.725 from the middle.
    const double touch = 0.5 - 0.3 * 0.5 / 0.725;
    double thinnest = 1;
    for (const Point3& p : surface.vertices) {
        const Point3 q = p - shape_centre;
        const double rho = std::hypot(q.y(), q.z()), x = std::abs(q.x());
        thinnest = std::min(thinnest, rho);
        if (x > touch + 1e-9) {
            REQUIRE(std::hypot(x - 0.5, rho) == Approx(0.3).epsilon(1e-12));
        } else if (x < touch - 1e-9) {
            REQUIRE(std::hypot(x, rho - 0.525) == Approx(0.425).epsilon(1e-12));
            REQUIRE(rho >= 0.1 - 1e-12);
        }
    }
    const TriangleFigures triangles(surface);
    CHECK(triangles.least_angle > 30);
    CHECK(triangles.shortest > 0.6 * 0.05);
    CHECK(triangles.longest < 1.6 * 0.05);

    // Volume of the solid of revolution: the part of each ball beyond `touch`, and the neck by Simpson's rule.
    const double cap = 0.5 + 0.3 - touch;
    double neck = 0;
    constexpr int parts = 1000;
    for (int i = 0; i <= parts; ++i) {
        const double x = touch * i / parts, rho = 0.525 - std::sqrt(0.425 * 0.425 - x * x);
        neck += (i == 0 || i == parts ? 1 : i % 2 == 1 ? 4 : 2) * pi * rho * rho * touch / parts / 3;
    }
    require_second_order([&](double length) { return dumbbell(shape_centre, size, length); }, 0.1,
                         2 * (neck + pi * cap * cap * (0.9 - cap) / 3));
}

TEST_CASE("shapes say what is wrong with their lengths") {
    CHECK_THROWS_AS(icosphere(shape_centre, 0, 2), core::UsageError);
    CHECK_THROWS_AS(icosphere(shape_centre, 1, 0), core::UsageError);
    CHECK_THROWS_AS(icosphere_frequency(1, 0), core::UsageError);
    CHECK_THROWS_AS(icosphere_frequency(1, 1e-9), core::UsageError);
    CHECK_THROWS_AS(two_spheres(shape_centre, 1, -0.1, 2), core::UsageError);
    CHECK_THROWS_AS(torus(shape_centre, 0.3, 0.3, 0.1), core::UsageError);
    CHECK_THROWS_AS(torus(shape_centre, 0.3, 0.1, -1), core::UsageError);
    CHECK_THROWS_AS(torus(shape_centre, 0.3, 0.1, 1e-9), core::UsageError);
    CHECK_THROWS_AS(dumbbell(shape_centre, {.neck_radius = 0.4}, 0.1), core::UsageError);
    CHECK_THROWS_AS(dumbbell(shape_centre, {.half_distance = 0.2}, 0.1), core::UsageError);
    CHECK_THROWS_AS(dumbbell(shape_centre, {}, std::nan("")), core::UsageError);
}
