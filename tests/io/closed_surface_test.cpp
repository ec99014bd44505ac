// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/closed_surface.h"

#include <catch2/catch.hpp>

#include "core/errors.h"
#include "io/surface_mesh.h"
#include "tests/geometry/surfaces.h"
#include "tests/support/shared_data.h"

using namespace dsc;
using namespace dsc::tests;
using geometry::SurfaceData;

namespace {

/// Empty when there is none.
std::string problem_of(const SurfaceData& surface) {
    try {
        io::require_closed_surface("s.off", surface);
    } catch (const core::InputError& error) {
        return error.what();
    }
    return "";
}

SurfaceData box_with(const std::array<std::uint32_t, 3>& triangle) {
    SurfaceData surface = box();
    surface.triangles.push_back(triangle);
    return surface;
}

}  // namespace

TEST_CASE("closed surfaces are let through, also inside out and in several components") {
    CHECK(problem_of(box()).empty());
    CHECK(problem_of(joined(torus(20, 0.3), box({5, 5, 5}))).empty());
    SurfaceData inverted = icosphere(2);
    for (auto& triangle : inverted.triangles) std::swap(triangle[0], triangle[1]);
    CHECK(problem_of(inverted).empty());
}

TEST_CASE("what is wrong with a surface is said with the place") {
    SurfaceData open = box();
    open.triangles.pop_back();
    CHECK(problem_of(open) == "s.off: between (1, 0, 0), (1, 0, 1): an open edge, one of 3; close the holes");
    SurfaceData turned = box();
    std::swap(turned.triangles[0][0], turned.triangles[0][1]);
    CHECK(problem_of(turned) ==
          "s.off: between (0, 0, 0), (0, 1, 0): an edge whose two triangles face different sides, one of 3; "
          "turn one of them over");
    CHECK(problem_of(glued(joined(box(), box({1, 1, 1})), 8, 7)) ==
          "s.off: at (1, 1, 1): a vertex where the surface is pinched, one of 1; double the vertex");
    CHECK_THAT(
        problem_of(glued(glued(joined(box(), box({1, 1, 0})), 8, 3), 12, 7)),
        Catch::StartsWith("s.off: between (1, 1, 0), (1, 1, 1): an edge of more than two triangles, one of 1; "));
    CHECK_THAT(
        problem_of(box_with({2, 3, 0})),
        Catch::StartsWith("s.off: between (0, 1, 0), (1, 1, 0), (0, 0, 0): a triangle that is there twice, one of 1"));
    CHECK_THAT(problem_of(box_with({0, 1, 1})),
               Catch::StartsWith("s.off: between (0, 0, 0), (1, 0, 0), (1, 0, 0): a triangle of no area, one of 1"));
    CHECK_THAT(problem_of(joined(box(), box({0.5, 0.4, 0.3}))), Catch::Contains("a self-intersection, one of "));
}

TEST_CASE("the shared surfaces bound volumes", "[shared]") {
    DSC_NEEDS_SHARED_DATA("surface");
    for (const char* name :
         {"surface/teapot.off", "surface/boid.off", "surface/deer.off", "surface/glass.off", "surface/spot.off",
          "surface/house2_boundary.off", "surface/letterp_q_boundary.off", "surface/grain_q_boundary.off",
          "surface/bracket_q_boundary.off", "points/fandisk.off", "points/gearplate.off", "points/hollow.off"}) {
        INFO(name);
        CHECK(problem_of(io::read_surface_mesh(shared_data(name))).empty());
    }
}
