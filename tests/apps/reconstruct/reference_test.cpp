// SPDX-License-Identifier: GPL-3.0-or-later
// Thesis Fig. 4.6, a box with a tunnel, from the reference clouds: topology, and the truth's volume and area.
#include <catch2/catch.hpp>

#include <iostream>

#include "apps/reconstruct/reconstruct.h"
#include "geometry/surface_intersections.h"
#include "io/points.h"
#include "io/surface_mesh.h"
#include "tests/support/shared_data.h"

using namespace dsc;

TEST_CASE("a box with a tunnel", "[shared][slow]") {
    DSC_NEEDS_SHARED_DATA("points/box_tunnel.xyz");
    const geometry::SurfaceCheck truth =
        geometry::check_surface(io::read_surface_mesh(tests::shared_data("points/box_tunnel.off")));
    core::Observer observer;
    const reconstruct::Reconstruction result = reconstruct::reconstruct(
        io::read_points(tests::shared_data("points/box_tunnel.xyz")), {}, "box_tunnel.xyz", observer);
    CHECK(result.genus == std::vector<std::int64_t>{1});
    CHECK(result.check.is_manifold());
    CHECK(geometry::self_intersections(result.surface).empty());
    CHECK(*result.check.volume == Approx(*truth.volume).epsilon(0.001));
    CHECK(result.check.area == Approx(truth.area).epsilon(0.003));
    CHECK(result.surface.triangles.size() < 10000);
}
