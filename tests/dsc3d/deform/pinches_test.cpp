// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/pinches.h"

#include "tests/dsc3d/deform/support.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;

namespace {

const VertexId inner_vertex(13);  // of the box of 2 x 2 x 2 cubes, its only vertex off the boundary

/// Gives to the winner what is found until nothing is; how many tetrahedra that were.
int open_pinches(Mesh& mesh, int winner, int loser) {
    PassBench bench(mesh, {.edge_length = 1});
    PassContext context = bench.context();
    Pinches pinches;
    int given = 0;
    for (;;) {
        const std::span<const TetId> found = pinches.find(context, inner_vertex, winner, loser);
        if (found.empty()) return given;
        const std::set<TetId> once(found.begin(), found.end());
        REQUIRE(once.size() == found.size());
        for (const TetId t : once) {
            REQUIRE(mesh.complex().label(t) == loser);
            REQUIRE(mesh.complex().has_vertex(t, inner_vertex));
            bench.rated.set_label(t, winner);
            ++given;
        }
    }
}

std::vector<TetId> star_of_centre(const Mesh& mesh) {
    std::vector<TetId> star;
    for (const TetId t : tets(mesh.complex()))
        if (mesh.complex().has_vertex(t, inner_vertex)) star.push_back(t);
    return star;
}

int shared_vertices(const Complex& complex, TetId a, TetId b) {
    int count = 0;
    for (const VertexId v : complex.vertices(a)) count += complex.has_vertex(b, v) ? 1 : 0;
    return count;
}

Mesh shaken_box(core::Random& random) {
    TetData data = box({2, 2, 2});
    shake_inside(data, 0.3, random);
    return Mesh(data);
}

}  // namespace

TEST_CASE("two tetrahedra of the winner that meet in an edge or a vertex are joined, two that share a face stay") {
    core::Random random(seed(1));
    std::map<int, int> cases;
    const Mesh sample = shaken_box(random);
    const std::vector<TetId> star = star_of_centre(sample);
    REQUIRE(star.size() == 24);
    for (std::size_t i = 0; i < star.size(); ++i) {
        for (std::size_t j = i + 1; j < star.size(); ++j) {
            Mesh mesh(sample.data());
            mesh.complex().set_label(star[i], 1);
            mesh.complex().set_label(star[j], 1);
            const int shared = shared_vertices(mesh.complex(), star[i], star[j]);
            ++cases[shared];
            const bool is_pinched = pinches(mesh.complex()) != 0;
            CHECK(is_pinched == (shared < 3));
            const int given = open_pinches(mesh, 1, 0);
            CHECK((given > 0) == is_pinched);
            CHECK(pinches(mesh.complex()) == 0);
        }
    }
    CHECK(cases[1] > 0);
    CHECK(cases[2] > 0);
    CHECK(cases[3] > 0);
}

TEST_CASE("two tetrahedra of the loser that meet in an edge or a vertex: one goes, or both") {
    core::Random random(seed(2));
    const Mesh sample = shaken_box(random);
    const std::vector<TetId> star = star_of_centre(sample);
    for (std::size_t i = 0; i < star.size(); ++i) {
        for (std::size_t j = i + 1; j < star.size(); ++j) {
            Mesh mesh(sample.data());
            mesh.complex().set_label(star[i], 1);
            mesh.complex().set_label(star[j], 1);
            const bool is_pinched = shared_vertices(mesh.complex(), star[i], star[j]) < 3;
            const double first = volume(mesh, mesh.complex().vertices(star[i]));
            const double second = volume(mesh, mesh.complex().vertices(star[j]));
            const int given = open_pinches(mesh, 0, 1);
            CHECK(given == (is_pinched ? 1 : 0));
            if (is_pinched) CHECK(mesh.complex().label(first < second ? star[i] : star[j]) == 0);
            CHECK(pinches(mesh.complex()) == 0);
        }
    }
}

TEST_CASE("any two regions around a vertex are manifolds there after all pinches are opened") {
    core::Random random(seed(3));
    for (int trial = 0; trial < 300; ++trial) {
        Mesh mesh = shaken_box(random);
        const double share = random.uniform(0.05, 0.95);
        for (const TetId t : star_of_centre(mesh)) mesh.complex().set_label(t, random.uniform(0, 1) < share ? 1 : 0);
        const bool is_pinched = pinches(mesh.complex()) != 0;
        const int given = open_pinches(mesh, 1, 0);
        REQUIRE((given > 0) == is_pinched);
        REQUIRE(pinches(mesh.complex()) == 0);
    }
}

TEST_CASE("among three regions the loser is a manifold in the end, and the third keeps all it has") {
    core::Random random(seed(4));
    for (int trial = 0; trial < 300; ++trial) {
        Mesh mesh = shaken_box(random);
        std::map<TetId, int> label;
        for (const TetId t : star_of_centre(mesh)) {
            label[t] = static_cast<int>(random.below(3));
            mesh.complex().set_label(t, label[t]);
        }
        open_pinches(mesh, 1, 0);
        for (const auto& [t, before] : label) {
            const int after = mesh.complex().label(t);
            REQUIRE((after == before || (before == 0 && after == 1)));
        }
        REQUIRE(pinches(mesh.complex(), 0) == 0);
    }
}
