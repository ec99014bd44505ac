// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/complex/complex.h"

#include "core/errors.h"
#include "tests/dsc3d/random_topology.h"
#include "tests/dsc3d/samples.h"
#include "tests/dsc3d/simplices.h"
#include "tests/dsc3d/support.h"
#include "tests/support/seed.h"

using namespace dsc::dsc3d;
using namespace dsc::tests;
using dsc::core::Attribute;
using dsc::core::Random;

namespace {

// Complexes of irregular connectivity, with deleted handles, two labels and a boundary.
std::vector<Mesh> irregular_meshes(Random& random) {
    std::vector<Mesh> meshes;
    for (const TetData& data : {box({2, 1, 1}), box({2, 2, 2}), ball(0)}) {
        meshes.emplace_back(data);
        RandomTopology(meshes.back().complex(), random, 120, 2).run(200);
    }
    return meshes;
}

// The permutation that takes `from` to `to` is even.
template <std::size_t N>
bool has_even_order(std::array<VertexId, N> from, const std::array<VertexId, N>& to) {
    bool is_even = true;
    for (std::size_t i = 0; i < N; ++i) {
        if (from[i] == to[i]) continue;
        std::swap(from[i], *std::find(from.begin() + static_cast<std::ptrdiff_t>(i), from.end(), to[i]));
        is_even = !is_even;
    }
    return is_even;
}

std::string complaint(std::uint32_t vertex_count, const std::vector<std::array<std::uint32_t, 4>>& tets) {
    std::vector<NewTet> list;
    for (const auto& [a, b, c, d] : tets) list.push_back({{VertexId(a), VertexId(b), VertexId(c), VertexId(d)}});
    try {
        const Complex complex(vertex_count, list, "sample.ele");
    } catch (const dsc::core::InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("the boundary relation of a complex has the simplices and the order that its header promises") {
    Random random(seed(1));
    for (const Mesh& mesh : irregular_meshes(random)) {
        const Complex& complex = mesh.complex();
        const Simplices all = simplices_of(complex);
        CHECK(complex.vertex_count() == filter(all, 0).size());
        CHECK(complex.edge_count() == filter(all, 1).size());
        CHECK(complex.face_count() == filter(all, 2).size());
        CHECK(complex.tet_count() == filter(all, 3).size());
        for (const TetId t : tets(complex)) {
            const TetVertices& v = complex.vertices(t);
            for (int i = 0; i < 4; ++i) {
                const FaceId f = complex.faces(t)[static_cast<std::size_t>(i)];
                Simplex expected = simplex(v);
                expected.erase(v[static_cast<std::size_t>(i)].index());
                REQUIRE(simplex(complex.vertices(f)) == expected);
                // The induced orientation is (-1)^i [v0 .. without vi ..].
                FaceVertices rest;
                std::copy_if(v.begin(), v.end(), rest.begin(), [&](VertexId u) { return expected.count(u.index()); });
                REQUIRE(has_even_order(complex.oriented_face(t, i), rest) == (i % 2 == 0));
                REQUIRE(complex.index_of(t, f) == i);
                REQUIRE(complex.index_of(t, v[static_cast<std::size_t>(i)]) == i);
            }
            std::size_t k = 0;
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = i + 1; j < 4; ++j)
                    REQUIRE(simplex(complex.vertices(complex.edges(t)[k++])) == simplex(std::array{v[i], v[j]}));
        }
        for (const FaceId f : faces(complex)) {
            const FaceVertices v = complex.vertices(f);
            for (std::size_t i = 0; i < 3; ++i)
                REQUIRE(simplex(complex.vertices(complex.edges(f)[i])) ==
                        simplex(std::array{v[(i + 1) % 3], v[(i + 2) % 3]}));
        }
    }
}

TEST_CASE("the coboundary relation of a complex is the inverse of its boundary relation") {
    Random random(seed(2));
    for (const Mesh& mesh : irregular_meshes(random)) {
        const Complex& complex = mesh.complex();
        std::map<FaceId, std::set<TetId>> tets_at_face;
        for (const TetId t : tets(complex))
            for (const FaceId f : complex.faces(t)) tets_at_face[f].insert(t);
        REQUIRE(tets_at_face.size() == complex.face_count());
        for (const auto& [f, expected] : tets_at_face) {
            const auto [first, second] = complex.tets(f);
            REQUIRE(complex.is_boundary(f) == (expected.size() == 1));
            REQUIRE(expected == (second.is_valid() ? std::set{first, second} : std::set{first}));
            for (const TetId t : expected) {
                const TetId across = complex.across(f, t);
                REQUIRE(across == (t == first ? second : first));
                REQUIRE(complex.neighbour(t, complex.index_of(t, f)) == across);
            }
        }
        // Of the partial coboundary one element is stored: any one, but one of them.
        for (const EdgeId e : edges(complex)) {
            REQUIRE(is_face(simplex(complex.vertices(e)), simplex(complex.vertices(complex.face(e)))));
            REQUIRE(is_face(simplex(complex.vertices(e)), simplex(complex.vertices(complex.tet(e)))));
        }
        for (const VertexId v : vertices(complex)) {
            REQUIRE(is_face(simplex(v), simplex(complex.vertices(complex.edge(v)))));
            REQUIRE(complex.has_vertex(complex.tet(v), v));
        }
    }
}

TEST_CASE("two tetrahedra at a face induce opposite orientations on it") {
    Random random(seed(3));
    for (const Mesh& mesh : irregular_meshes(random)) {
        const Complex& complex = mesh.complex();
        for (const FaceId f : faces(complex)) {
            const auto [first, second] = complex.tets(f);
            if (!second.is_valid()) continue;
            REQUIRE_FALSE(has_even_order(complex.oriented_face(first, complex.index_of(first, f)),
                                         complex.oriented_face(second, complex.index_of(second, f))));
        }
    }
}

TEST_CASE("Euler's number of a ball is 1, of its boundary 2, whatever changes within") {
    Random random(seed(4));
    for (const Mesh& mesh : irregular_meshes(random)) {
        Simplices boundary;
        for (const FaceId f : faces(mesh.complex()))
            if (mesh.complex().is_boundary(f)) boundary.insert(simplex(mesh.complex().vertices(f)));
        CHECK(euler_characteristic(simplices_of(mesh.complex())) == 1);
        CHECK(euler_characteristic(closure(boundary)) == 2);
    }
}

TEST_CASE("labels decide which simplices are interface") {
    Random random(seed(5));
    Mesh mesh(box({3, 2, 2}));
    Complex& complex = mesh.complex();
    for (int round = 0; round < 300; ++round) {
        complex.set_label(TetId(static_cast<std::uint32_t>(random.below(complex.tet_capacity()))),
                          static_cast<int>(random.below(3)));
        if (round % 10 != 0) continue;
        std::map<EdgeId, std::pair<int, int>> at_edge;
        std::map<VertexId, std::pair<int, int>> at_vertex;
        for (const FaceId f : faces(complex)) {
            const auto [first, second] = complex.tets(f);
            const bool is_interface = second.is_valid() && complex.label(first) != complex.label(second);
            REQUIRE(complex.is_interface(f) == is_interface);
            REQUIRE(complex.is_surface(f) == (is_interface || !second.is_valid()));
            for (const EdgeId e : complex.edges(f))
                at_edge[e].first += second.is_valid() ? 0 : 1, at_edge[e].second += is_interface ? 1 : 0;
            for (const VertexId v : complex.vertices(f))
                at_vertex[v].first += second.is_valid() ? 0 : 1, at_vertex[v].second += is_interface ? 1 : 0;
        }
        for (const auto& [e, count] : at_edge) {
            REQUIRE(complex.is_boundary(e) == (count.first > 0));
            REQUIRE(complex.is_interface(e) == (count.second > 0));
            REQUIRE(complex.surface_degree(e) == static_cast<std::uint32_t>(count.first + count.second));
        }
        for (const auto& [v, count] : at_vertex) {
            REQUIRE(complex.is_boundary(v) == (count.first > 0));
            REQUIRE(complex.is_interface(v) == (count.second > 0));
            REQUIRE(complex.is_surface(v) == (count.first + count.second > 0));
        }
    }
}

TEST_CASE("replace says what it has changed, and what it has not changed keeps its handle") {
    Random random(seed(6));
    Mesh mesh(box({2, 2, 2}));
    Complex& complex = mesh.complex();
    StarWalker walker(complex);
    RandomTopology topology(complex, random, 200);
    int done = 0;
    while (done < 300) {
        topology.run_one();
        const FaceId chosen = topology.pick_face();
        if (!can_flip_2_3(complex, chosen, walker)) continue;
        ++done;
        const Flip flip = flip_2_3(complex, chosen);
        std::map<TetId, Simplex> tets_before;
        std::map<FaceId, Simplex> faces_before;
        std::map<EdgeId, Simplex> edges_before;
        for (const TetId t : tets(complex)) tets_before[t] = simplex(complex.vertices(t));
        for (const FaceId f : faces(complex)) faces_before[f] = simplex(complex.vertices(f));
        for (const EdgeId e : edges(complex)) edges_before[e] = simplex(complex.vertices(e));

        const Complex::Change& change = flip.apply(complex);
        REQUIRE(change.removed_tets == std::vector(flip.removed().begin(), flip.removed().end()));
        REQUIRE(change.added_tets.size() == 3);
        for (std::size_t i = 0; i < 3; ++i) {
            REQUIRE(complex.vertices(change.added_tets[i]) == flip.added()[i].vertices);
            REQUIRE(tets_before.count(change.added_tets[i]) == 0);
        }
        for (const TetId t : change.removed_tets) REQUIRE(complex.is_deleted(t));
        REQUIRE(complex.is_deleted(chosen));
        REQUIRE(change.added_edges.size() == 1);
        REQUIRE(change.added_faces.size() == 3);
        REQUIRE(change.removed_vertices.empty());
        for (const FaceId f : change.added_faces) {
            REQUIRE(f != chosen);
            REQUIRE(is_face(simplex(complex.vertices(change.added_edges[0])), simplex(complex.vertices(f))));
        }
        for (const auto& [t, before] : tets_before)
            if (!complex.is_deleted(t)) REQUIRE(simplex(complex.vertices(t)) == before);
        for (const auto& [f, before] : faces_before)
            if (f != chosen) REQUIRE(simplex(complex.vertices(f)) == before);
        for (const auto& [e, before] : edges_before) REQUIRE(simplex(complex.vertices(e)) == before);
    }
}

TEST_CASE("attributes of simplices that stay survive changes, new simplices have the defaults") {
    Random random(seed(7));
    Mesh mesh(box({2, 2, 1}));
    Complex& complex = mesh.complex();
    Attribute<VertexId, Simplex> vertex_name(complex.vertex_attributes());
    Attribute<EdgeId, Simplex> edge_name(complex.edge_attributes());
    Attribute<FaceId, Simplex> face_name(complex.face_attributes());
    Attribute<TetId, Simplex> tet_name(complex.tet_attributes());
    RandomTopology topology(complex, random, 80);
    int fresh = 0;
    for (int step = 0; step < 1000; ++step) {
        // A name that is there has to be the right one; simplices without a name are new since the last step.
        const auto check = [&](Simplex& name, const Simplex& expected) {
            fresh += name.empty() ? 1 : 0;
            REQUIRE((name.empty() || name == expected));
            name = expected;
        };
        for (const VertexId v : vertices(complex)) check(vertex_name[v], simplex(v));
        for (const EdgeId e : edges(complex)) check(edge_name[e], simplex(complex.vertices(e)));
        for (const FaceId f : faces(complex)) check(face_name[f], simplex(complex.vertices(f)));
        for (const TetId t : tets(complex)) check(tet_name[t], simplex(complex.vertices(t)));
        topology.run_one();
    }
    CHECK(fresh > 3000);
    CHECK(complex.tet_capacity() < 1000);  // handles were used again
}

TEST_CASE("a complex that is no manifold is refused, naming the tetrahedron") {
    CHECK(complaint(5, {{0, 1, 2, 3}, {0, 2, 1, 4}}).empty());
    SECTION("a face of three tetrahedra") {
        const std::string what = complaint(6, {{0, 1, 2, 3}, {0, 2, 1, 4}, {0, 2, 1, 5}});
        CHECK(what.find("sample.ele: tetrahedron 2") != std::string::npos);
        CHECK(what.find("face 0 1 2 belongs to two other tetrahedra") != std::string::npos);
    }
    SECTION("two tetrahedra on one side of a face") {
        const std::string what = complaint(5, {{0, 1, 2, 3}, {0, 1, 2, 4}});
        CHECK(what.find("tetrahedron 1") != std::string::npos);
        CHECK(what.find("same side of its face 0 1 2 as tetrahedron 0") != std::string::npos);
    }
    SECTION("the same tetrahedron twice") {
        CHECK(complaint(4, {{0, 1, 2, 3}, {0, 1, 2, 3}}).find("tetrahedron 1") != std::string::npos);
    }
    SECTION("two tetrahedra that share an edge only") {
        const std::string what = complaint(6, {{0, 1, 2, 3}, {0, 1, 4, 5}});
        CHECK(what.find("tetrahedron 0") != std::string::npos);
        CHECK(what.find("its edge 0 1 joins parts") != std::string::npos);
    }
    SECTION("two tetrahedra that share a vertex only") {
        const std::string what = complaint(7, {{0, 1, 2, 3}, {0, 4, 5, 6}});
        CHECK(what.find("tetrahedron 0") != std::string::npos);
        CHECK(what.find("its vertex 0 joins parts") != std::string::npos);
    }
    SECTION("a vertex in whose link two boundary circles meet nothing: an annulus") {
        // A ring of three prisms around an axis, all coned to one apex: its link is the ring's annulus.
        std::vector<std::array<std::uint32_t, 4>> tets;
        for (std::uint32_t i = 0; i < 3; ++i) {
            const std::uint32_t inner = i, outer = 3 + i, next_inner = (i + 1) % 3, next_outer = 3 + (i + 1) % 3;
            tets.push_back({inner, outer, next_outer, 6});
            tets.push_back({inner, next_outer, next_inner, 6});
        }
        CHECK(complaint(7, tets).find("its vertex 6 joins parts") != std::string::npos);
    }
}

TEST_CASE("the memory of a complex is that of its arrays") {
    const Mesh small(box({2, 2, 2})), large(box({8, 8, 8}));
    CHECK(large.complex().memory() > small.complex().memory());
    CHECK(large.complex().memory() < 160 * std::size_t{large.complex().tet_count()});
}

TEST_CASE("changes do not make the memory of a complex grow beyond its size") {
    Random random(seed(4));
    Mesh mesh(box({14, 14, 14}));
    Complex& complex = mesh.complex();
    const auto has_grown = [&] {
        return static_cast<double>(complex.memory()) > 160.0 * static_cast<double>(complex.tet_capacity());
    };
    CHECK_FALSE(has_grown());
    RandomTopology topology(complex, random, 2 * complex.tet_count());
    topology.run_one();
    CHECK_FALSE(has_grown());
    topology.run(3000);
    CHECK_FALSE(has_grown());
    complex.compact();
    topology.run_one();
    CHECK_FALSE(has_grown());
}
