// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/generate/manifold_interface.h"

#include <catch2/catch.hpp>

#include "core/random.h"
#include "dsc3d/generate/lattice.h"
#include "dsc3d/interface.h"
#include "geometry/surface_check.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::dsc3d;

namespace {

Mesh box() { return Mesh(lattice({Point3(0, 0, 0), Point3(1, 1, 1)}, 0.2)); }

// Labels of tetrahedra off the boundary by a question about their centroids.
template <class Question>
void label(Mesh& mesh, Question&& is_inside) {
    Complex& complex = mesh.complex();
    for (std::uint32_t i = 0; i < complex.tet_capacity(); ++i) {
        Point3 centroid = Point3::Zero();
        bool is_at_boundary = false;
        for (const VertexId v : complex.vertices(TetId(i))) {
            centroid += 0.25 * mesh.position(v);
            is_at_boundary = is_at_boundary || complex.is_boundary(v);
        }
        if (!is_at_boundary && is_inside(centroid)) complex.set_label(TetId(i), 1);
    }
}

bool is_manifold(const Mesh& mesh) {
    const geometry::SurfaceCheck check = geometry::check_surface(Interface(mesh).data.surface);
    return check.is_closed() && check.is_manifold() && check.is_oriented();
}

}  // namespace

TEST_CASE("a manifold interface is left as it is") {
    Mesh mesh = box();
    label(mesh, [](const Point3& p) { return (p - Point3(0.5, 0.5, 0.5)).norm() < 0.28; });
    const bool was_manifold = is_manifold(mesh);
    const ManifoldInterfaceReport report = make_interface_manifold(mesh, 1, 0);
    CHECK((report.relabelled == 0) == was_manifold);
    CHECK(is_manifold(mesh));
}

TEST_CASE("labels at random end in a manifold interface") {
    for (std::uint64_t run = 1; run <= 5; ++run) {
        core::Random random(tests::seed(run));
        Mesh mesh = box();
        label(mesh, [&](const Point3&) { return random.uniform() < 0.4; });
        REQUIRE(!is_manifold(mesh));
        const ManifoldInterfaceReport report = make_interface_manifold(mesh, 1, 0, 200);
        CHECK(report.relabelled > 0);
        CHECK(validate(mesh).empty());
        CHECK((report.pinches == 0) == is_manifold(mesh));
        CHECK(report.pinches == 0);
    }
}
