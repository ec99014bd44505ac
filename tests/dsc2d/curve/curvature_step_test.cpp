// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/curve/curvature_step.h"

#include "core/errors.h"
#include "core/random.h"
#include "dsc2d/generate/insert_polygon.h"
#include "dsc2d/generate/shapes.h"
#include "dsc2d/generate/structured.h"
#include "geometry/triangle.h"
#include "tests/dsc2d/support.h"
#include "tests/support/seed.h"

using namespace dsc::dsc2d;
using dsc::tests::circle;
using dsc::tests::complex_of;
using std::numbers::pi;

namespace {

const CurvatureParameters standard = {.shortest_edge = 1e-4};

std::vector<Point2> moved(const Complex& complex, double dt, const CurvatureParameters& parameters = standard) {
    const Interface interface(complex);
    const std::vector<std::uint8_t> is_fixed(interface.vertices.size(), 0);
    std::vector<Point2> places = curvature_displacements(interface, dt, is_fixed, parameters);
    for (std::size_t i = 0; i < places.size(); ++i) places[i] += complex.position(interface.vertices[i]);
    return places;
}

}  // namespace

TEST_CASE("a circle of any spacing has the radius sqrt(r0^2 - 2 t) and stays a circle") {
    dsc::core::Random random(dsc::tests::seed(9));
    std::vector<Point2> uneven;
    for (int i = 0; i < 100; ++i) {
        const double angle = 2 * pi * (i + random.uniform(-0.4, 0.4)) / 100;
        uneven.push_back(Point2(std::cos(angle), std::sin(angle)));
    }
    for (const auto& outline : {circle({0, 0}, 1, 40), circle({0, 0}, 1, 200), uneven}) {
        const Complex complex = complex_of(outline);
        for (const double dt : {0.01, 0.2, 0.375}) {
            const double exact = std::sqrt(1 - 2 * dt);
            for (const Point2& place : moved(complex, dt)) CHECK(place.norm() == Approx(exact).epsilon(1e-3));
        }
    }
}

TEST_CASE("the error falls with the tolerance, by more than its first power in the time step") {
    const Complex complex = complex_of(circle({0, 0}, 1, 60));
    double last = 1;
    for (const double tolerance : {0.1, 0.01, 0.001}) {
        CurvatureParameters parameters = standard;
        parameters.tolerance = tolerance;
        const double error = std::abs(moved(complex, 0.3, parameters).front().norm() - std::sqrt(0.4));
        CHECK(error < last / 3);
        last = error;
    }
    CHECK(last < 1e-4);
}

TEST_CASE("area falls by 2 pi per time for any simple curve") {
    std::vector<Point2> star;
    for (int i = 0; i < 200; ++i) {
        const double angle = 2 * pi * i / 200;
        star.push_back((1 + 0.3 * std::cos(5 * angle)) * Point2(std::cos(angle), std::sin(angle)));
    }
    Complex complex = complex_of(star);
    const Interface interface(complex);
    const std::vector<Point2> places = moved(complex, 0.01);
    double before = 0, after = 0;
    for (const InterfaceSegment& s : interface.segments) {
        before +=
            dsc::geometry::cross(complex.position(interface.vertices[s.a]), complex.position(interface.vertices[s.b]));
        after += dsc::geometry::cross(places[s.a], places[s.b]);
    }
    CHECK((before - after) / 2 == Approx(2 * pi * 0.01).epsilon(0.01));
}

TEST_CASE("a triple point of equal angles stays, fixed vertices stay, and what vanishes goes to a point") {
    // A disc of three labels: three spokes at 120 degrees, whose outer ends are fixed.
    Complex complex = structured_complex(Domain::box({-2, -2}, {2, 2}), 9, 9);
    const auto rim = [](int i) { return Point2(std::cos(2 * pi * i / 60), std::sin(2 * pi * i / 60)); };
    std::vector<Region> thirds;
    for (int k = 0; k < 3; ++k) {
        Region region{.outline = {Point2(0, 0), 0.5 * rim(20 * k)}, .label = k + 1};
        for (int i = 20 * k; i <= 20 * (k + 1); ++i) region.outline.push_back(rim(i));
        region.outline.push_back(0.5 * rim(20 * (k + 1)));
        thirds.push_back(region);
    }
    insert_regions(complex, thirds);
    const Interface interface(complex);
    std::vector<std::uint8_t> is_fixed;
    std::size_t centre = 0;
    for (std::size_t i = 0; i < interface.vertices.size(); ++i) {
        const Point2& p = complex.position(interface.vertices[i]);
        if (p.isZero(0)) centre = i;
        is_fixed.push_back(p.norm() > 0.9 ? 1 : 0);
    }
    const auto steps = curvature_displacements(interface, 0.1, is_fixed, standard);
    CHECK(steps[centre].norm() < 1e-12);
    for (std::size_t i = 0; i < steps.size(); ++i)
        if (is_fixed[i] != 0) CHECK(steps[i].isZero(0));

    for (const Point2& place : moved(complex_of(circle({0.5, 0.25}, 0.5, 30)), 10))
        CHECK((place - Point2(0.5, 0.25)).norm() < 0.01);
    CHECK_THROWS_AS(moved(complex, 1, {.shortest_edge = 0}), dsc::core::UsageError);
}
