// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/generate/vessel.h"

#include <catch2/catch.hpp>

#include "core/errors.h"
#include "dsc3d/generate/shapes.h"
#include "dsc3d/improve/angle_range.h"
#include "dsc3d/mesh.h"
#include "geometry/surface_check.h"
#include "tests/dsc3d/support.h"
#include "tests/dsc3d/volumes.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;

namespace {

const Point3 vessel_centre(0.5, 0.5, 0.5);

geometry::InterfaceData ball(double radius) {
    geometry::InterfaceData data{.surface = icosphere(vessel_centre, radius, 4)};
    data.sides.assign(data.surface.triangles.size(), {0, 1});
    return data;
}

}  // namespace

TEST_CASE("a vessel is filled to its triangles, with the labels of what is inside") {
    core::Observer observer;
    const geometry::SurfaceData vessel = icosphere(vessel_centre, 1, 8);
    const Mesh mesh(tetrahedralize_within(ball(0.4), vessel, {}, observer));
    require_valid(mesh);
    CHECK(volume_of_label(mesh, 1) == Approx(*geometry::check_surface(ball(0.4).surface).volume).epsilon(1e-12));
    CHECK(volume_of_label(mesh, 0) + volume_of_label(mesh, 1) ==
          Approx(*geometry::check_surface(vessel).volume).epsilon(1e-12));
    std::size_t boundary_faces = 0;
    for (const FaceId f : faces(mesh.complex())) boundary_faces += mesh.complex().is_boundary(f) ? 1 : 0;
    CHECK(boundary_faces == vessel.triangles.size());
    for (const VertexId v : vertices(mesh.complex()))
        if (mesh.complex().is_boundary(v)) CHECK((mesh.position(v) - vessel_centre).norm() == Approx(1).epsilon(1e-14));
    CHECK(AngleRange(mesh).min > 14 * std::numbers::pi / 180);
}

TEST_CASE("what is no vessel, or does not hold the interface, is refused") {
    core::Observer observer;
    geometry::SurfaceData turned = icosphere(vessel_centre, 1, 4), open = turned;
    for (auto& triangle : turned.triangles) std::swap(triangle[0], triangle[1]);
    open.triangles.pop_back();
    CHECK_THROWS_AS(tetrahedralize_within(ball(0.4), turned, {}, observer), core::UsageError);
    CHECK_THROWS_AS(tetrahedralize_within(ball(0.4), open, {}, observer), core::UsageError);
    CHECK_THROWS_AS(tetrahedralize_within(ball(0.4), icosphere(vessel_centre, 0.2, 4), {}, observer), core::UsageError);
    geometry::InterfaceData sides = ball(0.4);
    sides.sides.pop_back();
    CHECK_THROWS_AS(tetrahedralize_within(sides, icosphere(vessel_centre, 1, 4), {}, observer), core::UsageError);
}
