// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/contact_line.h"

#include "tests/dsc3d/deform/support.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;

namespace {

/// A box whose vertices are shifted in x by `shear` per height; label 1 in the middle third, between two plane sheets
/// that stand on the lower side.
Mesh leaning_plate(double shear) {
    TetData data = box({6, 5, 3});
    for (const auto& [a, b, c, d] : data.tets) {
        const double x =
            (data.vertices[a].x() + data.vertices[b].x() + data.vertices[c].x() + data.vertices[d].x()) / 4;
        data.labels.push_back(x > 2 && x < 4 ? 1 : 0);
    }
    for (Point3& p : data.vertices) p.x() += shear * p.z();
    return Mesh(data);
}

template <class Use>
void for_each_on_floor(const Mesh& mesh, Use&& use) {
    for (const VertexId v : vertices(mesh.complex())) {
        const Point3& p = mesh.position(v);
        if (mesh.complex().is_interface(v) && p.z() == 0 && p.y() > 0 && p.y() < 5) use(v, p.x() > 3);
    }
}

}  // namespace

TEST_CASE("a contact line goes to where its plane sheets meet the wall after their motion") {
    const double depth = 0.03;
    const double rounding = 1e-14;  // of places up to 6
    for (const double shear : {-0.7, -0.2, 0.2, 0.7}) {
        Mesh mesh = leaning_plate(shear);
        RatedMesh rated(mesh, geometry::QualityMeasure::minimum_sine, FlatSurface::flat_boundary(mesh));
        InterfaceRing ring;
        for_each_on_floor(mesh, [&](VertexId v, bool is_right) {
            // Pressed down, both sheets shift alike; pulled up, only the one that recedes from its region's side.
            const Eigen::Vector3d pressed = contact_line_slip(rated, v, Point3(0, 0, -depth), ring);
            CHECK((pressed - Point3(shear * depth, 0, 0)).norm() < rounding);
            const Eigen::Vector3d pulled = contact_line_slip(rated, v, Point3(0, 0, depth), ring);
            const bool recedes = is_right == (shear > 0);
            CHECK((pulled - Point3(recedes ? -shear * depth : 0, 0, 0)).norm() < rounding);
        });
    }
}

TEST_CASE("upright sheets don't slip, and without motion off the wall nothing does") {
    Mesh mesh = leaning_plate(0);
    RatedMesh rated(mesh, geometry::QualityMeasure::minimum_sine, FlatSurface::flat_boundary(mesh));
    InterfaceRing ring;
    for_each_on_floor(mesh, [&](VertexId v, bool) {
        CHECK(contact_line_slip(rated, v, Point3(0, 0, -0.1), ring).norm() < 1e-15);
        CHECK(contact_line_slip(rated, v, Point3::Zero(), ring).isZero(0));
    });
}
