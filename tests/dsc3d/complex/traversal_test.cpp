// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/complex/traversal.h"

#include "tests/dsc3d/random_topology.h"
#include "tests/dsc3d/samples.h"
#include "tests/dsc3d/simplices.h"
#include "tests/dsc3d/support.h"
#include "tests/support/seed.h"

using namespace dsc::dsc3d;
using namespace dsc::tests;
using dsc::core::Random;

namespace {

// Both walks are used all along a random sequence of changes, so that their buffers see the complex grow and shrink.
template <class Check>
void along_random_changes(std::uint64_t default_seed, Check&& check) {
    Random random(seed(default_seed));
    Mesh mesh(box({2, 2, 1}));
    RandomTopology topology(mesh.complex(), random, 60, 2);
    for (int round = 0; round < 25; ++round) {
        topology.run(8);
        if (round % 5 == 4) mesh.complex().compact();
        check(mesh.complex(), simplices_of(mesh.complex()));
    }
}

}  // namespace

TEST_CASE("the ring of an edge goes once around it, and its link is the link of the definition") {
    EdgeRing ring;
    along_random_changes(1, [&](const Complex& complex, const Simplices& all) {
        for (const EdgeId e : edges(complex)) {
            gather_ring(complex, e, ring);
            const Simplex ends = simplex(complex.vertices(e));
            REQUIRE(Simplex{ring.a.index(), ring.b.index()} == ends);
            REQUIRE(ring.link.size() == ring.tets.size() + 1);
            REQUIRE(ring.is_closed == !complex.is_boundary(e));
            REQUIRE(ring.is_closed == (ring.link.front() == ring.link.back()));

            Simplices link_edges, tets_found;
            for (std::size_t i = 0; i < ring.tets.size(); ++i) {
                const TetVertices expected = {ring.a, ring.b, ring.link[i], ring.link[i + 1]};
                REQUIRE(oriented(complex.vertices(ring.tets[i])) == oriented(expected));
                link_edges.insert(simplex(std::array{ring.link[i], ring.link[i + 1]}));
                tets_found.insert(simplex(expected));
            }
            REQUIRE(link_edges.size() == ring.tets.size());
            REQUIRE(closure(link_edges) == link(all, ends));
            REQUIRE(tets_found == filter(star(all, ends), 3));
        }
    });
}

TEST_CASE("the star of a vertex is that of the definition, its neighbours are those joined by an edge") {
    Random random(seed(2));
    Mesh mesh(box({2, 2, 1}));
    RandomTopology topology(mesh.complex(), random, 60, 2);
    StarWalker walker(mesh.complex());
    std::vector<VertexId> others;
    for (int round = 0; round < 25; ++round) {
        topology.run(8);
        if (round % 5 == 4) mesh.complex().compact();
        const Complex& complex = mesh.complex();
        const Simplices all = simplices_of(complex);
        for (const VertexId v : vertices(complex)) {
            const Simplices expected = star(all, simplex(v));
            Simplices found;
            const auto tets = walker.star(v);
            for (const TetId t : tets) found.insert(simplex(complex.vertices(t)));
            REQUIRE(found.size() == tets.size());
            REQUIRE(found == filter(expected, 3));

            const std::vector<TetId> first(tets.begin(), tets.end());
            const auto again = walker.star(v, others);
            REQUIRE(std::equal(first.begin(), first.end(), again.begin(), again.end()));
            Simplices neighbours;
            for (const VertexId u : others) neighbours.insert(simplex(std::array{u, v}));
            REQUIRE(neighbours.size() == others.size());
            REQUIRE(neighbours == filter(expected, 1));
        }
    }
}

TEST_CASE("two vertices are joined by the edge that has them, or by none") {
    Random random(seed(3));
    Mesh mesh(box({2, 1, 1}));
    RandomTopology(mesh.complex(), random, 60).run(100);
    StarWalker walker(mesh.complex());
    for (const VertexId a : vertices(mesh.complex())) {
        for (const VertexId b : vertices(mesh.complex())) {
            if (a == b) continue;
            REQUIRE(walker.edge_between(a, b) == edge_between(mesh.complex(), a, b));
        }
    }
}
