// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/interface.h"

#include <catch2/catch.hpp>

#include "dsc3d/generate/fit.h"
#include "dsc3d/generate/lattice.h"
#include "geometry/surface_check.h"
#include "tests/dsc3d/volumes.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;

TEST_CASE("the interface of a ball is closed, bounds its volume and has the labels on either side") {
    Mesh mesh(lattice({Point3(0, 0, 0), Point3(1, 1, 1)}, 0.1));
    fit(mesh, [](const Point3& p) { return (p - Point3(0.5, 0.5, 0.5)).norm() - 0.3; }, {.inside = 7});
    const Interface interface(mesh);
    const geometry::SurfaceCheck check = geometry::check_surface(interface.data.surface);
    CHECK(check.is_closed());
    CHECK(*check.genus == 0);
    CHECK(*check.volume == Approx(volume_of_label(mesh, 7)).epsilon(1e-12));
    CHECK(interface.faces.size() == interface_triangles(mesh.complex()).size());
    for (const auto& [front, back] : interface.data.sides) CHECK((front == 0 && back == 7));
    for (std::size_t i = 0; i < interface.faces.size(); ++i)
        for (const std::uint32_t v : interface.data.surface.triangles[i]) {
            const FaceVertices corners = mesh.complex().vertices(interface.faces[i]);
            CHECK(std::ranges::count(corners, interface.vertices[v]) == 1);
            CHECK(mesh.position(interface.vertices[v]) == interface.data.surface.vertices[v]);
        }
}
