// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/curve/edge_offsetting.h"

#include "core/errors.h"
#include "core/random.h"
#include "dsc2d/generate/complex_around.h"
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

TEST_CASE("every vertex of any polygon goes to where the offset lines of its sides meet") {
    dsc::core::Random random(dsc::tests::seed(3));
    std::vector<Point2> outline;
    for (int i = 0; i < 30; ++i)
        outline.push_back(random.uniform(0.9, 1.2) * Point2(std::cos(2 * pi * i / 30), std::sin(2 * pi * i / 30)));
    const Complex complex = complex_of(outline);
    const Interface interface(complex);
    for (const double distance : {0.01, -0.01}) {
        const auto steps = offset_displacements(interface, distance, {});
        REQUIRE(steps.size() == interface.vertices.size());
        for (const InterfaceSegment& s : interface.segments) {
            const Point2 normal = Point2(s.vector.y(), -s.vector.x()).normalized();
            CHECK(steps[s.a].dot(normal) == Approx(distance).epsilon(1e-9));
            CHECK(steps[s.b].dot(normal) == Approx(distance).epsilon(1e-9));
        }
    }
}

TEST_CASE("corners of a square stay corners, sides stay straight") {
    const Complex complex = complex_of(rectangle({0, 0}, {2, 2}, 0.25)[0].outline);
    const Interface interface(complex);
    const auto steps = offset_displacements(interface, 0.1, {});
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const Point2 place = complex.position(interface.vertices[i]) + steps[i];
        CHECK(place.cwiseAbs().maxCoeff() == Approx(1.1).epsilon(1e-13));
    }
}

TEST_CASE("the tip of a needle goes no further than it may") {
    const Complex complex = complex_of({{-1, 0}, {1, -0.01}, {1, 0.01}});
    for (const Point2& step : offset_displacements(Interface(complex), 0.01, {})) CHECK(step.norm() <= 0.05 + 1e-12);
    CHECK_THROWS_AS(offset_displacements(Interface(complex), 0.01, {.feature_angle = 0}), dsc::core::UsageError);
    CHECK_THROWS_AS(offset_displacements(Interface(complex), 0.01, {.max_stretch = 0.5}), dsc::core::UsageError);
}
