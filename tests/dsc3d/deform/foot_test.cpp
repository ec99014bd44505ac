// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/foot.h"

#include "tests/dsc3d/deform/support.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;

namespace {

/// A square column of label 1 on the lower side of a box.
Mesh column(double width) {
    const double low = 3, high = 3 + width;
    return cubes_with({8, 8, 3}, [=](const Point3& p) {
        return p.x() > low && p.x() < high && p.y() > low && p.y() < high && p.z() < 2 ? 1 : 0;
    });
}

}  // namespace

TEST_CASE(
    "a narrow patch on a wall whose rim contracts, or that is pulled off, is a foot: all of its region at the patch") {
    for (const int width : {1, 3}) {
        Mesh mesh = column(width);
        PassBench bench(mesh, {.edge_length = 1});
        PassContext context = bench.context();
        const Point3 middle(3 + 0.5 * width, 3 + 0.5 * width, 0);
        Foot foot;
        const auto count = [&](double rate, const Point3& shift, double lift = 0) {
            for (const VertexId v : vertices(mesh.complex())) {
                bench.way[v] = rate * (mesh.position(v) - middle) + shift;
                bench.pull[v] = {0, 0, lift};
            }
            int found = 0;
            for (const FaceId f : faces(mesh.complex())) {
                const TetId t = mesh.complex().tets(f)[0];
                const FaceVertices corners = mesh.complex().vertices(f);
                if (std::none_of(corners.begin(), corners.end(),
                                 [&](VertexId v) { return mesh.complex().is_interface(v); }))
                    continue;
                if (!mesh.complex().is_boundary(f) || mesh.complex().label(t) != 1 || !foot.find(context, f)) continue;
                ++found;
                std::set<TetId> expected;
                for (const TetId s : tets(mesh.complex())) {
                    const TetVertices& v = mesh.complex().vertices(s);
                    const bool is_low =
                        std::any_of(v.begin(), v.end(), [&](VertexId u) { return mesh.position(u).z() == 0; });
                    if (mesh.complex().label(s) == 1 && is_low) expected.insert(s);
                }
                CHECK(std::set<TetId>(foot.tets().begin(), foot.tets().end()) == expected);
            }
            return found;
        };
        CHECK(count(-0.1, {0, 0, 0}) == (width == 1 ? 2 : 0));
        CHECK(count(-0.1, {0.5, 0.2, 0}) == (width == 1 ? 2 : 0));
        CHECK(count(0.1, {0, 0, 0}) == 0);
        CHECK(count(0, {0.3, 0, 0}) == 0);
        CHECK(count(0, {0, 0, 0}) == 0);
        CHECK(count(0, {0, 0, 0}, 0.1) == (width == 1 ? 2 : 0));
        CHECK(count(0, {0.3, 0, 0}, 0.1) == 0);
        CHECK(count(0, {0, 0, 0}, -0.1) == 0);
    }
}
