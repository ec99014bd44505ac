// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/flips.h"

#include "tests/dsc3d/random_topology.h"
#include "tests/dsc3d/samples.h"
#include "tests/dsc3d/support.h"
#include "tests/support/seed.h"

using namespace dsc::dsc3d;
using namespace dsc::tests;
using dsc::core::Random;

namespace {

// A shaken box whose inner tetrahedra make many flips possible.
Mesh shaken_box(const Cells& cells, std::uint64_t with_seed) {
    Random random(with_seed);
    TetData data = box(cells);
    shake_inside(data, 0.3, random);
    return Mesh(data);
}

double volume(const Mesh& mesh, std::span<const TetId> tets) {
    double sum = 0;
    for (const TetId t : tets) sum += dsc::tests::volume(mesh, mesh.complex().vertices(t));
    return sum;
}

// Does the flip, checks that it filled the place of what it took, with what it said, and with its label.
Complex::Change checked(Mesh& mesh, const Flip& flip) {
    const double before = volume(mesh, flip.removed());
    const Complex::Change change = flip.apply(mesh.complex());
    require_valid(mesh);
    REQUIRE(volume(mesh, change.added_tets) == Approx(before).epsilon(1e-13));
    return change;
}

}  // namespace

TEST_CASE("3-2 undoes 2-3") {
    Mesh mesh = shaken_box({3, 3, 3}, seed(1));
    StarWalker walker(mesh.complex());
    int done = 0;
    for (const FaceId f : faces(mesh.complex())) {
        if (mesh.complex().is_deleted(f) || !can_flip_2_3(mesh.complex(), f, walker)) continue;
        const Flip flip = flip_2_3(mesh.complex(), f);
        REQUIRE(flip.removed().size() == 2);
        REQUIRE(flip.added().size() == 3);
        if (!flip.is_positive(mesh)) continue;
        ++done;
        const LabelledTets before = labelled_tets(mesh.complex());
        const Complex::Change change = checked(mesh, flip);
        REQUIRE(change.added_edges.size() == 1);
        const EdgeId e = change.added_edges[0];
        REQUIRE(can_flip_3_2(mesh.complex(), e, walker));
        checked(mesh, flip_3_2(mesh.complex(), e));
        REQUIRE(labelled_tets(mesh.complex()) == before);
    }
    CHECK(done > 50);
}

TEST_CASE("2-3 undoes 3-2") {
    Random random(seed(2));
    Mesh mesh = shaken_box({2, 2, 2}, 2);
    StarWalker walker(mesh.complex());
    RandomTopology topology(mesh.complex(), random, 120);
    int done = 0;
    for (int round = 0; round < 2000; ++round) {
        topology.run_one();
        const EdgeId e = topology.pick_edge();
        if (!can_flip_3_2(mesh.complex(), e, walker)) continue;
        ++done;
        const LabelledTets before = labelled_tets(mesh.complex());
        const Complex::Change change = flip_3_2(mesh.complex(), e).apply(mesh.complex());
        REQUIRE(change.added_faces.size() == 1);
        const FaceId f = change.added_faces[0];
        REQUIRE(can_flip_2_3(mesh.complex(), f, walker));
        flip_2_3(mesh.complex(), f).apply(mesh.complex());
        REQUIRE(labelled_tets(mesh.complex()) == before);
    }
    CHECK(done > 50);
}

TEST_CASE("one of the two 4-4 flips of the new edge undoes a 4-4 flip") {
    Random random(seed(3));
    Mesh mesh = shaken_box({2, 2, 2}, 3);
    StarWalker walker(mesh.complex());
    RandomTopology topology(mesh.complex(), random, 120, 2);
    int done = 0, across_interface = 0;
    for (int round = 0; round < 3000; ++round) {
        topology.run_one();
        const EdgeId e = topology.pick_edge();
        for (const Diagonal diagonal : {Diagonal::link_0_2, Diagonal::link_1_3}) {
            if (!can_flip_4_4(mesh.complex(), e, diagonal, walker)) continue;
            ++done;
            across_interface += mesh.complex().is_interface(e) ? 1 : 0;
            const LabelledTets before = labelled_tets(mesh.complex());
            EdgeRing ring;
            gather_ring(mesh.complex(), e, ring);
            const std::size_t i = diagonal == Diagonal::link_0_2 ? 0 : 1;
            const std::set expected = {ring.link[i], ring.link[i + 2]};
            const Complex::Change change = flip_4_4(mesh.complex(), e, diagonal).apply(mesh.complex());
            REQUIRE(change.added_edges.size() == 1);
            const EdgeVertices ends = mesh.complex().vertices(change.added_edges[0]);
            REQUIRE(std::set(ends.begin(), ends.end()) == expected);

            int undone = 0;
            for (const Diagonal again : {Diagonal::link_0_2, Diagonal::link_1_3}) {
                if (!can_flip_4_4(mesh.complex(), change.added_edges[0], again, walker)) continue;
                const Flip flip = flip_4_4(mesh.complex(), change.added_edges[0], again);
                LabelledTets after = labelled_tets(mesh.complex());
                for (const TetId t : flip.removed())
                    after.erase({oriented(mesh.complex().vertices(t)), mesh.complex().label(t)});
                for (const NewTet& tet : flip.added()) after.emplace(oriented(tet.vertices), tet.label);
                if (after != before) continue;
                ++undone;
                flip.apply(mesh.complex());
                break;
            }
            REQUIRE(undone == 1);
            REQUIRE(labelled_tets(mesh.complex()) == before);
            break;
        }
    }
    CHECK(done > 50);
    CHECK(across_interface > 5);
}

TEST_CASE("2-2 undoes 2-2 and exchanges the diagonal of a square of the boundary") {
    Mesh mesh(box({2, 2, 2}));
    StarWalker walker(mesh.complex());
    int done = 0;
    for (const EdgeId e : edges(mesh.complex())) {
        if (mesh.complex().is_deleted(e) || !can_flip_2_2(mesh.complex(), e, walker)) continue;
        const Flip flip = flip_2_2(mesh.complex(), e);
        if (!flip.is_positive(mesh)) continue;
        ++done;
        const LabelledTets before = labelled_tets(mesh.complex());
        const auto areas = surface_areas(mesh);
        const Complex::Change change = checked(mesh, flip);
        require_same(areas, surface_areas(mesh), 1e-14);
        REQUIRE(change.added_edges.size() == 1);
        REQUIRE(can_flip_2_2(mesh.complex(), change.added_edges[0], walker));
        checked(mesh, flip_2_2(mesh.complex(), change.added_edges[0]));
        REQUIRE(labelled_tets(mesh.complex()) == before);
    }
    CHECK(done > 5);
}

TEST_CASE("every flip that the connectivity allows leaves a complex of the same topology") {
    for (const int labels : {1, 3}) {
        Random random(seed(4));
        Mesh mesh(box({2, 2, 1}));
        RandomTopology topology(mesh.complex(), random, 60, labels);
        for (int step = 0; step < 1000; ++step) {
            const RandomTopology::Kind kind = topology.run_one();
            INFO("step " << step << ", kind " << kind);
            require_valid(mesh.complex());
        }
        for (const auto kind :
             {RandomTopology::flip_23, RandomTopology::flip_32, RandomTopology::flip_44, RandomTopology::flip_22})
            CHECK(topology.done(kind) > 10);
    }
}

TEST_CASE("a flip that is already there, or that crosses a region, is refused") {
    SECTION("2-3 across an interface or at the boundary") {
        Mesh mesh(
            TetData{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 1}, {0.3, 0.3, -1}}, {{0, 1, 2, 3}, {0, 2, 1, 4}}});
        StarWalker walker(mesh.complex());
        int possible = 0;
        for (const FaceId f : faces(mesh.complex())) {
            const bool is_possible = can_flip_2_3(mesh.complex(), f, walker);
            CHECK(is_possible == !mesh.complex().is_boundary(f));
            possible += is_possible ? 1 : 0;
        }
        CHECK(possible == 1);
        mesh.complex().set_label(TetId(1), 5);
        for (const FaceId f : faces(mesh.complex())) CHECK_FALSE(can_flip_2_3(mesh.complex(), f, walker));
    }
    SECTION("2-3 where the edge exists, 3-2 with two labels, 4-4 against the interface") {
        Mesh three(fan(3));
        StarWalker walker(three.complex());
        for (const FaceId f : faces(three.complex())) CHECK_FALSE(can_flip_2_3(three.complex(), f, walker));
        const EdgeId axis = edge_between(three.complex(), VertexId(0), VertexId(1));
        CHECK(can_flip_3_2(three.complex(), axis, walker));
        three.complex().set_label(TetId(1), 1);
        CHECK_FALSE(can_flip_3_2(three.complex(), axis, walker));

        Mesh four(fan(4));
        StarWalker four_walker(four.complex());
        const EdgeId middle = edge_between(four.complex(), VertexId(0), VertexId(1));
        EdgeRing ring;
        gather_ring(four.complex(), middle, ring);
        for (const Diagonal diagonal : {Diagonal::link_0_2, Diagonal::link_1_3})
            CHECK(can_flip_4_4(four.complex(), middle, diagonal, four_walker));
        four.complex().set_label(ring.tets[0], 1);
        for (const Diagonal diagonal : {Diagonal::link_0_2, Diagonal::link_1_3})
            CHECK_FALSE(can_flip_4_4(four.complex(), middle, diagonal, four_walker));
        four.complex().set_label(ring.tets[1], 1);
        CHECK(can_flip_4_4(four.complex(), middle, Diagonal::link_0_2, four_walker));
        CHECK_FALSE(can_flip_4_4(four.complex(), middle, Diagonal::link_1_3, four_walker));
    }
}
