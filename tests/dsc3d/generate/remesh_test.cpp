// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/generate/remesh.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "core/errors.h"
#include "dsc3d/generate/blocks.h"
#include "dsc3d/generate/shapes.h"
#include "tests/dsc3d/generate/surface_figures.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;

TEST_CASE("a cube that is remeshed stays the same cube, with edges of the length asked for") {
    const geometry::SurfaceData coarse = box_surface({Point3(0, 0, 0), Point3(1, 1, 1)}, 0.5);
    for (const double length : {0.2, 0.1}) {
        const geometry::SurfaceData fine = remeshed(coarse, {.edge_length = length});
        const geometry::SurfaceCheck check = require_closed(fine);
        CHECK(*check.volume == Approx(1).epsilon(1e-12));
        CHECK(check.area == Approx(6).epsilon(1e-12));
        std::set<std::array<double, 3>> corners;
        for (const Point3& p : fine.vertices)
            if (((p.array() == 0) || (p.array() == 1)).all()) corners.insert({p.x(), p.y(), p.z()});
        CHECK(corners.size() == 8);
        const TriangleFigures triangles(fine);
        CHECK(triangles.shortest > 0.4 * length);
        CHECK(triangles.longest < 1.7 * length);
        CHECK(triangles.least_angle > 25);
    }
}

TEST_CASE("a sphere that is remeshed coarser keeps its genus, and its vertices on the surface") {
    const geometry::SurfaceData fine = icosphere(Point3(1, 2, 3), 0.5, 16);
    const geometry::SurfaceData coarse = remeshed(fine, {.edge_length = 0.12});
    CHECK(*require_closed(coarse).genus == 0);
    CHECK(coarse.triangles.size() < fine.triangles.size() / 4);
    for (const Point3& p : coarse.vertices) {
        CHECK((p - Point3(1, 2, 3)).norm() <= 0.5 + 1e-12);
        CHECK((p - Point3(1, 2, 3)).norm() > 0.499);
    }
}

TEST_CASE("remeshing says what it can't do") {
    const geometry::SurfaceData cube = box_surface({Point3(0, 0, 0), Point3(1, 1, 1)}, 0.5);
    CHECK_THROWS_AS(remeshed(cube, {}), core::UsageError);
    CHECK_THROWS_AS(remeshed(cube, {.edge_length = 0.1, .feature_angle = 0}), core::UsageError);
    CHECK_THROWS_AS(remeshed(cube, {.edge_length = 0.1, .iterations = 0}), core::UsageError);
    geometry::SurfaceData open = cube;
    open.triangles.pop_back();
    CHECK_THROWS_AS(remeshed(open, {.edge_length = 0.1}), core::UsageError);
}
