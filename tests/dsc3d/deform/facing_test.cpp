// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/facing.h"

#include "tests/dsc3d/deform/support.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;

TEST_CASE("the sheets of a slab face each other when it is thinner than the distance, at its thickness") {
    for (const double edge_length : {1.0, 2.0}) {
        for (const double thickness : {0.05, 0.2, 0.4, 0.7}) {
            Mesh mesh = slab(thickness, {0, 1, 0});
            PassBench bench(mesh, {.edge_length = edge_length});
            PassContext context = bench.context();
            const double distance = 0.3;
            int count = 0;
            for (const TetId t : tets(mesh.complex())) {
                const TetVertices& v = mesh.complex().vertices(t);
                const bool is_inner =
                    std::none_of(v.begin(), v.end(), [&](VertexId u) { return mesh.complex().is_boundary(u); });
                const auto facing = facing_sheets(context, t, distance);
                const bool is_expected = mesh.complex().label(t) == 1 && is_inner && thickness < distance * edge_length;
                REQUIRE(facing.has_value() == is_expected);
                if (!facing) continue;
                ++count;
                CHECK(facing->gap == Approx(thickness).epsilon(1e-12));
                CHECK(std::abs(mesh.position(facing->a).z() - mesh.position(facing->b).z()) ==
                      Approx(thickness).epsilon(1e-12));
            }
            CHECK(count == (thickness < distance * edge_length ? 6 * 4 * 4 : 0));
        }
    }
}

TEST_CASE("three labels: the slab between two others has two sheets as well") {
    Mesh mesh = slab(0.1, {1, 0, 2});
    PassBench bench(mesh, {.edge_length = 1});
    PassContext context = bench.context();
    int count = 0;
    for (const TetId t : tets(mesh.complex())) count += facing_sheets(context, t, 0.25) ? 1 : 0;
    CHECK(count == 6 * 4 * 4);
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
