// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/generate/tetrahedralize.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <numbers>
#include <set>
#include <vector>

#include "core/errors.h"
#include "dsc3d/generate/blocks.h"
#include "dsc3d/generate/shapes.h"
#include "dsc3d/improve/angle_range.h"
#include "geometry/surface_check.h"
#include "tests/dsc3d/support.h"
#include "tests/dsc3d/volumes.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;

namespace {

const Eigen::AlignedBox3d unit_box(Point3(0, 0, 0), Point3(1, 1, 1));
const Point3 domain_centre(0.5, 0.5, 0.5);
constexpr double degree = std::numbers::pi / 180;

using Corner = std::array<double, 3>;
using Triangle = std::array<Corner, 3>;

template <class Vertices>
Triangle triangle(const Vertices& position) {
    Triangle corners;
    for (std::size_t k = 0; k < 3; ++k) {
        const Point3 p = position(k);
        corners[k] = {p.x(), p.y(), p.z()};
    }
    std::ranges::sort(corners);
    return corners;
}

std::set<Triangle> triangles(const geometry::SurfaceData& surface) {
    std::set<Triangle> result;
    for (const auto& t : surface.triangles)
        result.insert(triangle([&](std::size_t k) { return surface.vertices[t[k]]; }));
    return result;
}

std::set<Triangle> interface_of(const Mesh& mesh) {
    std::set<Triangle> result;
    for (const FaceVertices& f : interface_triangles(mesh.complex()))
        result.insert(triangle([&](std::size_t k) { return mesh.position(f[k]); }));
    return result;
}

template <class Surface>
Mesh filled(const Surface& surface, const Eigen::AlignedBox3d& box = unit_box) {
    core::Observer observer;
    Mesh mesh(tetrahedralize(surface, box, {}, observer));
    require_valid(mesh);
    CHECK(AngleRange(mesh).min > 15 * degree);
    double volume = 0;
    for (const auto& [label, share] : volumes(mesh)) volume += share;
    CHECK(volume == Approx(box.volume()).epsilon(1e-12));
    return mesh;
}

geometry::SurfaceData joined(geometry::SurfaceData a, const geometry::SurfaceData& b) {
    const auto shift = static_cast<std::uint32_t>(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const auto& [p, q, r] : b.triangles) a.triangles.push_back({p + shift, q + shift, r + shift});
    return a;
}

geometry::SurfaceData turned(geometry::SurfaceData surface) {
    for (auto& t : surface.triangles) std::swap(t[0], t[1]);
    return surface;
}

double enclosed(const geometry::SurfaceData& surface) { return *geometry::check_surface(surface).volume; }

}  // namespace

TEST_CASE("every triangle of a surface is kept, nothing else separates labels, and all angles are 15 degrees or more",
          "[slow]") {
    const std::vector<std::pair<const char*, geometry::SurfaceData>> surfaces = {
        {"sphere", icosphere(domain_centre, 0.3, 8)},
        {"small sphere aside", icosphere(Point3(0.35, 0.35, 0.35), 0.15, 8)},
        {"torus", torus(domain_centre, 0.3, 0.1, 0.05)},
        {"slotted cube", slotted_cube(domain_centre, {}, 0.05)},
        {"two spheres", two_spheres(domain_centre, 0.15, 0.02, 8)},
    };
    for (const auto& [name, surface] : surfaces) {
        CAPTURE(name);
        const Mesh mesh = filled(surface);
        CHECK(interface_of(mesh) == triangles(surface));
        CHECK(1 - volume_of_label(mesh, 0) == Approx(enclosed(surface)).epsilon(1e-12));
        // As many as the thesis has (4.4.5: 7 to 8 per triangle, 70 % of them at the interface).
        const double per_triangle =
            static_cast<double>(mesh.complex().tet_count()) / static_cast<double>(surface.triangles.size());
        CHECK(per_triangle > 4);
        CHECK(per_triangle < 10);
    }
}

TEST_CASE("a box that is not a cube, larger than what is in it") {
    const geometry::SurfaceData surface = dumbbell(Point3(0, 0, 0), {}, 0.1);
    const Mesh mesh = filled(surface, {Point3(-2, -1, -1.1), Point3(1.5, 0.8, 1)});
    CHECK(interface_of(mesh) == triangles(surface));
}

TEST_CASE("three labels that meet in a line are kept") {
    const geometry::InterfaceData block = labelled_block({Point3(0.3, 0.3, 0.3), Point3(0.7, 0.7, 0.7)}, 0.05);
    const Mesh mesh = filled(block);
    CHECK(interface_of(mesh) == triangles(block.surface));
    CHECK(volume_of_label(mesh, 1) == Approx(0.032).epsilon(1e-12));
    CHECK(volume_of_label(mesh, 2) == Approx(0.016).epsilon(1e-12));
    CHECK(volume_of_label(mesh, 3) == Approx(0.016).epsilon(1e-12));
}

TEST_CASE("labels are winding numbers: parts side by side, cavities, parts within parts") {
    const geometry::SurfaceData outer = icosphere(domain_centre, 0.4, 3), inner = icosphere(domain_centre, 0.2, 2);
    const double large = enclosed(outer), small = enclosed(inner);
    {
        const Mesh mesh = filled(joined(outer, inner));
        CHECK(volume_of_label(mesh, 1) == Approx(large - small).epsilon(1e-12));
        CHECK(volume_of_label(mesh, 2) == Approx(small).epsilon(1e-12));
    }
    {
        const Mesh mesh = filled(joined(outer, turned(inner)));
        CHECK(volume_of_label(mesh, 1) == Approx(large - small).epsilon(1e-12));
        CHECK(volume_of_label(mesh, 0) == Approx(1 - large + small).epsilon(1e-12));
        CHECK(components_of_label(mesh.complex(), 0) == 2);
    }
    {
        const Mesh mesh = filled(turned(outer));
        CHECK(volume_of_label(mesh, 1) == Approx(large).epsilon(1e-12));
    }
    {
        const geometry::SurfaceData pair = two_spheres(domain_centre, 0.15, 0.1, 4);
        const Mesh mesh = filled(pair);
        CHECK(volume_of_label(mesh, 1) == Approx(enclosed(pair)).epsilon(1e-12));
        CHECK(components_of_label(mesh.complex(), 1) == 2);
    }
    {
        // A ball in the cavity of a ball.
        const Mesh mesh = filled(joined(joined(outer, turned(inner)), icosphere(domain_centre, 0.1, 2)));
        CHECK(components_of_label(mesh.complex(), 0) == 2);
        CHECK(components_of_label(mesh.complex(), 1) == 2);
    }
}

TEST_CASE("the same surface gives the same mesh") {
    core::Observer observer;
    const geometry::SurfaceData surface = icosphere(domain_centre, 0.3, 6);
    const geometry::TetData first = tetrahedralize(surface, unit_box, {}, observer);
    const geometry::TetData second = tetrahedralize(surface, unit_box, {}, observer);
    CHECK(first.vertices == second.vertices);
    CHECK(first.tets == second.tets);
    CHECK(first.labels == second.labels);
}

TEST_CASE("surfaces that bound nothing, meet themselves or leave the box are refused") {
    core::Observer observer;
    const auto fill = [&](const auto& surface, const Eigen::AlignedBox3d& box = unit_box,
                          const TetrahedralizeParameters& parameters = {}) {
        return tetrahedralize(surface, box, parameters, observer);
    };
    const geometry::SurfaceData ball = icosphere(domain_centre, 0.3, 2);
    geometry::SurfaceData bad = ball;
    bad.triangles.pop_back();
    CHECK_THROWS_AS(fill(bad), core::UsageError);
    bad = ball;
    std::swap(bad.triangles[3][0], bad.triangles[3][1]);
    CHECK_THROWS_AS(fill(bad), core::UsageError);
    CHECK_THROWS_AS(fill(geometry::SurfaceData()), core::UsageError);
    CHECK_THROWS_WITH(fill(joined(ball, icosphere(domain_centre + Point3(0.3, 0, 0), 0.1, 2))),
                      Catch::Contains("intersects"));
    CHECK_THROWS_WITH(fill(joined(ball, turned(icosphere(Point3(0.1, 0.1, 0.1), 0.05, 2)))),
                      Catch::Contains("inside out"));
    CHECK_THROWS_WITH(fill(icosphere(domain_centre, 0.6, 2)), Catch::Contains("leaves the box"));
    CHECK_THROWS_AS(fill(ball, {Point3(0, 0, 0), Point3(1, 1, 0)}), core::UsageError);
    CHECK_THROWS_AS(fill(ball, unit_box, {.growth = -1}), core::UsageError);
    CHECK_THROWS_AS(fill(ball, unit_box, {.min_angle = 0}), core::UsageError);
    CHECK_THROWS_AS(fill(ball, unit_box, {.tetgen = "no-such-program"}), core::RunError);

    geometry::InterfaceData block = labelled_block({Point3(0.3, 0.3, 0.3), Point3(0.7, 0.7, 0.7)}, 0.2);
    block.sides.front() = {0, 5};
    CHECK_THROWS_WITH(fill(block), Catch::Contains("disagree"));
    block.sides.pop_back();
    CHECK_THROWS_AS(fill(block), core::UsageError);
}
