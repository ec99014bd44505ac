// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/interface_ring.h"

#include "tests/dsc3d/deform/support.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;

TEST_CASE("the ring of a vertex has each interface face at it once, its normal to the side of the lower label") {
    core::Random random(seed(1));
    for (int labels = 2; labels <= 4; ++labels) {
        TetData data = box({4, 3, 3});
        label_randomly(data, labels, random);
        shake_inside(data, 0.2, random);
        turn(data);
        Mesh mesh(data);
        const Complex& complex = mesh.complex();
        RatedMesh rated(mesh, geometry::QualityMeasure::minimum_sine, FlatSurface::flat_boundary(mesh));
        InterfaceRing buffer;
        for (const VertexId v : vertices(complex)) {
            const surface::OneRing ring = buffer.gather(rated, v);
            REQUIRE(ring.centre == mesh.position(v));
            std::size_t faces_at_v = 0;
            for (const FaceId f : faces(complex)) {
                const FaceVertices corners = complex.vertices(f);
                if (!complex.is_interface(f) || std::find(corners.begin(), corners.end(), v) == corners.end()) continue;
                ++faces_at_v;
                std::array<Point3, 2> others;
                std::size_t count = 0;
                for (const VertexId u : corners)
                    if (u != v) others[count++] = mesh.position(u);
                const auto is_it = [&](const surface::RingTriangle& t) {
                    return (t.a == others[0] && t.b == others[1]) || (t.a == others[1] && t.b == others[0]);
                };
                REQUIRE(std::count_if(ring.triangles.begin(), ring.triangles.end(), is_it) == 1);
                const surface::RingTriangle& found = *std::find_if(ring.triangles.begin(), ring.triangles.end(), is_it);
                const Point3 normal = (found.a - ring.centre).cross(found.b - ring.centre);
                const auto [first, second] = complex.tets(f);
                const TetId higher = complex.label(first) > complex.label(second) ? first : second;
                Point3 inside = Point3::Zero();
                for (const VertexId u : complex.vertices(higher)) inside += mesh.position(u) / 4;
                REQUIRE(normal.dot(inside - ring.centre) < 0);
            }
            REQUIRE(ring.triangles.size() == faces_at_v);
        }
    }
}
