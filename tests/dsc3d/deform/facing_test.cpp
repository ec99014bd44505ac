// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/facing.h"

#include "tests/dsc3d/deform/support.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;

namespace {

bool is_off_the_walls(const Complex& complex, TetId t) {
    const TetVertices& v = complex.vertices(t);
    return std::any_of(v.begin(), v.end(), [&](VertexId u) { return !complex.is_boundary(u); });
}

}  // namespace

TEST_CASE("the sheets of a slab face each other when it is thinner than the distance, at its thickness") {
    for (const double edge_length : {1.0, 2.0}) {
        for (const double thickness : {0.05, 0.2, 0.4, 0.7}) {
            Mesh mesh = slab(thickness, {0, 1, 0});
            PassBench bench(mesh, {.edge_length = edge_length});
            PassContext context = bench.context();
            const double distance = 0.3;
            for (const TetId t : tets(mesh.complex())) {
                const auto facing = facing_sheets(context, t, distance);
                const bool is_expected = mesh.complex().label(t) == 1 && is_off_the_walls(mesh.complex(), t) &&
                                         thickness < distance * edge_length;
                REQUIRE(facing.has_value() == is_expected);
                if (!facing) continue;
                CHECK(facing->gap == Approx(thickness).epsilon(1e-12));
                CHECK(std::abs(mesh.position(facing->a).z() - mesh.position(facing->b).z()) ==
                      Approx(thickness).epsilon(1e-12));
            }
        }
    }
}

TEST_CASE("three labels: the slab between two others has two sheets as well") {
    Mesh mesh = slab(0.1, {1, 0, 2});
    PassBench bench(mesh, {.edge_length = 1});
    PassContext context = bench.context();
    for (const TetId t : tets(mesh.complex()))
        REQUIRE(facing_sheets(context, t, 0.25).has_value() ==
                (mesh.complex().label(t) == 0 && is_off_the_walls(mesh.complex(), t)));
}

TEST_CASE("one sheet faces nothing, however flat the tetrahedra at it") {
    // Flat tetrahedra on top of the sheet between labels 0 and 1: with one of them given to the lower side, all its
    // vertices are on the interface.
    for (std::size_t bump = 0; bump < 6; ++bump) {
        Mesh mesh = slab(0.02, {1, 0, 0});
        std::vector<TetId> flat;
        for (const TetId t : tets(mesh.complex())) {
            const TetVertices& v = mesh.complex().vertices(t);
            Point3 middle = Point3::Zero();
            for (const VertexId u : v) middle += mesh.position(u) / 4;
            if (middle.x() > 2 && middle.x() < 3 && middle.y() > 2 && middle.y() < 3 && middle.z() > 1 &&
                middle.z() < 1.02)
                flat.push_back(t);
        }
        REQUIRE(flat.size() == 6);
        // Some stand on the sheet, others on an edge of it.
        mesh.complex().set_label(flat[bump], 1);
        PassBench bench(mesh, {.edge_length = 1});
        PassContext context = bench.context();
        const TetVertices& v = mesh.complex().vertices(flat[bump]);
        const int below =
            static_cast<int>(std::count_if(v.begin(), v.end(), [&](VertexId u) { return mesh.position(u).z() == 1; }));
        if (below != 3) continue;
        for (const TetId t : tets(mesh.complex())) REQUIRE_FALSE(facing_sheets(context, t, 0.25));
    }
}

TEST_CASE("sheets close in when their motion shortens the distance, not when they rest, part or go together") {
    Mesh mesh = slab(0.1, {0, 1, 0});
    PassBench bench(mesh, {.edge_length = 1});
    PassContext context = bench.context();
    const auto move = [&](double lower, double upper, double aside) {
        for (const VertexId v : vertices(mesh.complex())) {
            const double z = mesh.position(v).z();
            bench.way[v] = Point3(aside, 0, z == 1 ? lower : z < 1.5 && z > 1 ? upper : 0);
        }
    };
    const auto all_close = [&](bool expected) {
        for (const TetId t : tets(mesh.complex()))
            if (const auto facing = facing_sheets(context, t, 0.25)) REQUIRE(is_closing(context, *facing) == expected);
    };
    all_close(false);
    move(0, -0.1, 0), all_close(true);
    move(0.1, 0, 0), all_close(true);
    move(0.05, -0.05, 0.7), all_close(true);
    move(0.1, 0.05, 0), all_close(true);  // the lower one catches up
    move(0, 0.1, 0), all_close(false);
    move(0.1, 0.1, 0.3), all_close(false);
}

TEST_CASE("a sheet faces the wall that it is near to, and closes in on it when it moves towards it, not along it") {
    // A layer on the lower side of the box; its own sheet is the only one.
    for (const double thickness : {0.1, 0.4}) {
        TetData data = box({5, 5, 2});
        for (Point3& p : data.vertices)
            if (p.z() == 1) p.z() = thickness;
        for (const auto& [a, b, c, d] : data.tets) {
            const double z = data.vertices[a].z() + data.vertices[b].z() + data.vertices[c].z() + data.vertices[d].z();
            data.labels.push_back(z < 3.9 * thickness ? 1 : 0);
        }
        Mesh mesh(data);
        PassBench bench(mesh, {.edge_length = 1});
        PassContext context = bench.context();
        const auto move = [&](const Point3& way) {
            for (const VertexId v : vertices(mesh.complex()))
                bench.way[v] = mesh.complex().is_interface(v) ? way : Point3(Point3::Zero());
        };
        int count = 0;
        for (const TetId t : tets(mesh.complex())) {
            const TetVertices& v = mesh.complex().vertices(t);
            const bool has_sheet = std::any_of(v.begin(), v.end(), [&](VertexId u) {
                return mesh.complex().is_interface(u) && !mesh.complex().is_boundary(u);
            });
            const auto facing = facing_sheets(context, t, 0.25);
            REQUIRE(facing.has_value() == (mesh.complex().label(t) == 1 && has_sheet && thickness < 0.25));
            if (!facing) continue;
            ++count;
            CHECK(facing->gap == Approx(thickness).epsilon(1e-12));
            CHECK(mesh.position(facing->a).z() == thickness);
            CHECK(mesh.position(facing->b).z() == 0);
            move({0.3, 0, -0.01});
            CHECK(is_closing(context, *facing));
            move({0.3, -0.2, 0});
            CHECK_FALSE(is_closing(context, *facing));
            move({0, 0, 0.01});
            CHECK_FALSE(is_closing(context, *facing));
        }
        CHECK((count > 0) == (thickness < 0.25));
    }
}
