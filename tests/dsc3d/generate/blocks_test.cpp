// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/generate/blocks.h"

#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "core/errors.h"
#include "tests/dsc3d/generate/surface_figures.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;

namespace {

const Eigen::AlignedBox3d block_box(Point3(-0.5, 0, 0.1), Point3(0.5, 0.6, 0.9));

// The closed surface of one label, normals out of it.
geometry::SurfaceData boundary(const geometry::InterfaceData& interface, int label) {
    geometry::SurfaceData surface{.vertices = interface.surface.vertices};
    for (std::size_t i = 0; i < interface.sides.size(); ++i) {
        std::array<std::uint32_t, 3> triangle = interface.surface.triangles[i];
        if (interface.sides[i][0] == label) std::swap(triangle[1], triangle[2]);
        if (interface.sides[i][0] == label || interface.sides[i][1] == label) surface.triangles.push_back(triangle);
    }
    return surface;
}

}  // namespace

TEST_CASE("a box has its volume, its area, and edges of the length asked for") {
    const geometry::SurfaceData surface = box_surface(block_box, 0.1);
    const geometry::SurfaceCheck check = require_closed(surface);
    CHECK(*check.genus == 0);
    CHECK(surface.triangles.size() == 2 * 2 * (10 * 6 + 10 * 8 + 6 * 8));
    CHECK(*check.volume == Approx(0.48).epsilon(1e-12));
    CHECK(check.area == Approx(2 * (0.6 + 0.8 + 0.48)).epsilon(1e-12));
    const TriangleFigures triangles(surface);
    CHECK(triangles.shortest == Approx(0.1));
    CHECK(triangles.longest == Approx(0.1 * std::sqrt(2.0)));
    CHECK(triangles.least_angle == Approx(45));
    CHECK(box_surface(block_box, 5).triangles.size() == 12);
}

TEST_CASE("a cube with a slot has its volume, its area and genus 0") {
    const SlottedCubeSize size = {.side = 0.4, .slot_width = 0.1, .slot_depth = 0.25};
    const geometry::SurfaceCheck check = require_closed(slotted_cube(Point3(0.5, 0.4, 0.3), size, 0.05));
    CHECK(*check.genus == 0);
    CHECK(*check.volume == Approx(0.4 * (0.16 - 0.1 * 0.25)).epsilon(1e-12));
    CHECK(check.area == Approx(4 * 0.16 + 2 * (0.16 - 0.025) + 2 * 0.4 * 0.25).epsilon(1e-12));
}

TEST_CASE("three labels of a block have their volumes and meet in one straight line") {
    const geometry::InterfaceData block = labelled_block(block_box, 0.1);
    REQUIRE(block.sides.size() == block.surface.triangles.size());
    const double half = 0.24;
    for (const auto& [label, volume] : std::map<int, double>{{1, half}, {2, half / 2}, {3, half / 2}}) {
        const geometry::SurfaceCheck check = require_closed(boundary(block, label));
        CHECK(*check.genus == 0);
        CHECK(*check.volume == Approx(volume).epsilon(1e-12));
    }
    CHECK(*geometry::check_surface(boundary(block, 0)).volume == Approx(-2 * half).epsilon(1e-12));

    std::map<std::uint32_t, std::set<int>> labels;
    for (std::size_t i = 0; i < block.sides.size(); ++i)
        for (const std::uint32_t v : block.surface.triangles[i])
            labels[v].insert(block.sides[i].begin(), block.sides[i].end());
    for (const auto& [v, around] : labels) {
        if (!around.contains(1) || !around.contains(2) || !around.contains(3)) continue;
        CHECK(block.surface.vertices[v].x() == Approx(0).margin(1e-15));
        CHECK(block.surface.vertices[v].z() == Approx(0.5));
    }
}

TEST_CASE("blocks say what is wrong with their lengths") {
    CHECK_THROWS_AS(box_surface(block_box, 0), core::UsageError);
    CHECK_THROWS_AS(box_surface(block_box, 1e-7), core::UsageError);
    CHECK_THROWS_AS(box_surface({Point3(0, 0, 0), Point3(1, 0, 1)}, 0.1), core::UsageError);
    CHECK_THROWS_AS(slotted_cube(Point3::Zero(), {.side = 0.1}, 0.1), core::UsageError);
    CHECK_THROWS_AS(slotted_cube(Point3::Zero(), {.slot_width = -0.1}, 0.1), core::UsageError);
}
