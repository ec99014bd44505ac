// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/surface_check.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "core/random.h"
#include "tests/geometry/surfaces.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::tests;
using geometry::check_surface;
using geometry::SurfaceCheck;
using geometry::SurfaceData;
using geometry::SurfaceEdge;

namespace {

void check_closed_oriented_manifold(const SurfaceCheck& check) {
    CHECK(check.is_closed());
    CHECK(check.is_manifold());
    CHECK(check.is_oriented());
    CHECK(check.duplicated_triangles.empty());
    CHECK(check.degenerate_triangles.empty());
}

}  // namespace

TEST_CASE("a box is a closed oriented manifold of genus 0, wherever it is") {
    for (const double far : {0.0, -3.0, 0x1p30}) {
        const SurfaceCheck check = check_surface(box({far, far, far}, 0.5));
        check_closed_oriented_manifold(check);
        CHECK(check.components == 1);
        CHECK(check.euler_characteristic == 2);
        CHECK(check.genus == 0);
        CHECK(check.area == Approx(1.5).epsilon(1e-14));
        CHECK(check.volume.value() == Approx(0.125).epsilon(1e-14));
    }
}

TEST_CASE("icospheres and tori converge to the measures of the smooth surfaces") {
    const double pi = std::numbers::pi;
    const SurfaceCheck sphere = check_surface(icosphere(5));
    check_closed_oriented_manifold(sphere);
    CHECK(sphere.genus == 0);
    CHECK(sphere.area == Approx(4 * pi).epsilon(2e-3));
    CHECK(sphere.volume.value() == Approx(4 * pi / 3).epsilon(2e-3));
    const SurfaceCheck ring = check_surface(torus(100, 0.3));
    check_closed_oriented_manifold(ring);
    CHECK(ring.euler_characteristic == 0);
    CHECK(ring.genus == 1);
    CHECK(ring.area == Approx(4 * pi * pi * 0.3).epsilon(2e-3));
    CHECK(ring.volume.value() == Approx(2 * pi * pi * 0.09).epsilon(2e-3));
}

TEST_CASE("the genus is that of all components together, and a surface inside out has negative volume") {
    SurfaceData surface = joined(joined(torus(10, 0.2), box({5, 0, 0})), torus(7, 0.4));
    surface.vertices.emplace_back(9, 9, 9);  // of no triangle
    const double volume = check_surface(surface).volume.value();
    for (auto& [a, b, c] : surface.triangles) std::swap(b, c);
    const SurfaceCheck check = check_surface(surface);
    check_closed_oriented_manifold(check);
    CHECK(check.components == 3);
    CHECK(check.euler_characteristic == 2);
    CHECK(check.genus == 2);
    CHECK(volume > 0);
    CHECK(check.volume.value() == Approx(-volume));
}

TEST_CASE("the border of an open box is listed") {
    SurfaceData surface = box();
    surface.triangles.erase(surface.triangles.begin(), surface.triangles.begin() + 2);
    const SurfaceCheck check = check_surface(surface);
    CHECK(check.open_edges == std::vector<SurfaceEdge>{{0, 1}, {0, 2}, {1, 3}, {2, 3}});
    CHECK_FALSE(check.is_closed());
    CHECK(check.is_manifold());
    CHECK(check.is_oriented());
    CHECK(check.euler_characteristic == 1);
    CHECK(check.area == Approx(5));
    CHECK_FALSE(check.genus);
    CHECK_FALSE(check.volume);
}

TEST_CASE("a triangle that is turned over disagrees with its neighbours") {
    SurfaceData surface = box();
    std::swap(surface.triangles[0][0], surface.triangles[0][1]);
    const SurfaceCheck check = check_surface(surface);
    CHECK(check.misoriented_edges == std::vector<SurfaceEdge>{{0, 2}, {0, 3}, {2, 3}});
    CHECK(check.is_closed());
    CHECK(check.is_manifold());
    CHECK_FALSE(check.genus);
    CHECK_FALSE(check.volume);
}

TEST_CASE("a Moebius strip can't be oriented, whichever of its triangles are turned over") {
    SurfaceData surface = moebius_strip(15);
    const SurfaceCheck check = check_surface(surface);
    CHECK(check.euler_characteristic == 0);
    CHECK(check.open_edges.size() == 30);
    CHECK(check.is_manifold());
    CHECK(check.misoriented_edges.size() == 1);
    // Turning triangles over moves the place, but never removes it.
    core::Random random(seed(71));
    for (int i = 0; i < 100; ++i) {
        auto& triangle = surface.triangles[random.below(surface.triangles.size())];
        std::swap(triangle[1], triangle[2]);
        CHECK(check_surface(surface).misoriented_edges.size() % 2 == 1);
    }
}

TEST_CASE("a vertex where two boxes touch is pinched") {
    const SurfaceCheck check = check_surface(glued(joined(box(), box({1, 1, 1})), 8, 7));
    CHECK(check.non_manifold_vertices == std::vector<std::uint32_t>{7});
    CHECK(check.is_closed());
    CHECK_FALSE(check.is_manifold());
    CHECK(check.components == 1);
    CHECK(check.euler_characteristic == 3);
    CHECK_FALSE(check.genus);
    CHECK(check.volume.value() == Approx(2));
}

TEST_CASE("an edge where two boxes touch has four triangles") {
    const SurfaceCheck check = check_surface(glued(glued(joined(box(), box({1, 1, 0})), 8, 3), 12, 7));
    CHECK(check.non_manifold_edges == std::vector<SurfaceEdge>{{3, 7}});
    CHECK(check.non_manifold_vertices.empty());
    CHECK_FALSE(check.is_closed());
    CHECK_FALSE(check.is_manifold());
    CHECK_FALSE(check.volume);
}

TEST_CASE("triangles that are there twice are found whatever their first vertex and side") {
    SurfaceData surface = box();
    surface.triangles.push_back({3, 0, 2});
    surface.triangles.push_back({1, 3, 0});
    const SurfaceCheck check = check_surface(surface);
    CHECK(check.duplicated_triangles == std::vector<std::uint32_t>{12, 13});
    CHECK(check.non_manifold_edges.size() == 5);
}

TEST_CASE("triangles of no area are found exactly") {
    SurfaceData surface = box({0.1, 0.7, 0.3}, 3);
    // On the line exactly, and as far beside it as doubles allow.
    surface.vertices.emplace_back(0, 0, 0);
    surface.vertices.emplace_back(3, 5, 7);
    surface.vertices.emplace_back(9, 15, 21);
    surface.vertices.emplace_back(9, 15, std::nextafter(21, 22));
    surface.triangles.push_back({8, 9, 10});
    surface.triangles.push_back({8, 11, 9});
    CHECK(check_surface(surface).degenerate_triangles == std::vector<std::uint32_t>{12});
    for (const double scale : {1e-200, 1e200}) {
        SurfaceData scaled = box();
        scaled.vertices.emplace_back(2, 0, 0);
        scaled.triangles.push_back({0, 1, 8});
        for (Eigen::Vector3d& p : scaled.vertices) p *= scale;
        CHECK(check_surface(scaled).degenerate_triangles == std::vector<std::uint32_t>{12});
    }
}

TEST_CASE("a triangle that names a vertex twice is degenerate, and nothing else") {
    SurfaceData surface = box();
    surface.triangles.push_back({0, 5, 5});
    const SurfaceCheck check = check_surface(surface);
    CHECK(check.degenerate_triangles == std::vector<std::uint32_t>{12});
    CHECK(check.is_closed());
    CHECK(check.is_manifold());
    CHECK(check.genus == 0);
}

TEST_CASE("no surface at all is closed and has nothing") {
    const SurfaceCheck check = check_surface({});
    CHECK(check.is_closed());
    CHECK(check.components == 0);
    CHECK(check.area == 0);
    CHECK(check.volume.value() == 0);
}
