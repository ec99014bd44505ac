// SPDX-License-Identifier: GPL-3.0-or-later
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

// Gives every simplex in use its old handle and, by the old handles of its vertices, its name.
template <class Handle>
struct Names {
    Attribute<Handle, std::uint32_t> old;
    Attribute<Handle, Simplex> name;

    template <class Registry>
    explicit Names(const Registry& registry) : old(registry), name(registry) {}
    void note(Handle handle, const Simplex& vertices) { old[handle] = handle.index(), name[handle] = vertices; }
};

}  // namespace

TEST_CASE("compaction renumbers without gaps and keeps order, relations, labels, flags and attributes") {
    Random random(seed(1));
    for (int round = 0; round < 20; ++round) {
        Mesh mesh(box({2, 2, 2}));
        Complex& complex = mesh.complex();
        RandomTopology(complex, random, 150, 3).run(10 * round);
        Names<VertexId> v(complex.vertex_attributes());
        Names<EdgeId> e(complex.edge_attributes());
        Names<FaceId> f(complex.face_attributes());
        Names<TetId> t(complex.tet_attributes());
        for (const VertexId h : vertices(complex)) v.note(h, simplex(h));
        for (const EdgeId h : edges(complex)) e.note(h, simplex(complex.vertices(h)));
        for (const FaceId h : faces(complex)) f.note(h, simplex(complex.vertices(h)));
        for (const TetId h : tets(complex)) t.note(h, simplex(complex.vertices(h)));
        const LabelledTets before = labelled_tets(complex);
        const std::array counts = {complex.vertex_count(), complex.edge_count(), complex.face_count(),
                                   complex.tet_count()};

        complex.compact();

        require_valid(complex);
        CHECK(counts == std::array{complex.vertex_capacity(), complex.edge_capacity(), complex.face_capacity(),
                                   complex.tet_capacity()});
        CHECK(counts ==
              std::array{complex.vertex_count(), complex.edge_count(), complex.face_count(), complex.tet_count()});
        const auto old_name = [&](const auto& corners) {
            Simplex name;
            for (const VertexId u : corners) name.insert(v.old[u]);
            return name;
        };
        const auto check = [&](const auto& handles, const auto& names, auto&& vertices_of) {
            for (std::size_t i = 0; i < handles.size(); ++i) {
                REQUIRE(names.name[handles[i]] == old_name(vertices_of(handles[i])));
                REQUIRE((i == 0 || names.old[handles[i - 1]] < names.old[handles[i]]));
            }
        };
        check(vertices(complex), v, [](VertexId h) { return std::array{h}; });
        check(edges(complex), e, [&](EdgeId h) { return complex.vertices(h); });
        check(faces(complex), f, [&](FaceId h) { return complex.vertices(h); });
        check(tets(complex), t, [&](TetId h) { return complex.vertices(h); });
        LabelledTets after;
        for (const TetId h : tets(complex)) {
            TetVertices corners = complex.vertices(h);
            for (VertexId& u : corners) u = VertexId(v.old[u]);
            after.emplace(oriented(corners), complex.label(h));
        }
        CHECK(after == before);
    }
}

TEST_CASE("renumbering takes any order of vertices and tetrahedra, attributes follow, the rest comes by its vertices") {
    Random random(seed(3));
    const auto shuffled = [&](auto handles) {
        for (std::size_t i = handles.size(); i-- > 1;) std::swap(handles[i], handles[random.below(i + 1)]);
        return handles;
    };
    for (int round = 0; round < 20; ++round) {
        Mesh mesh(box({2, 2, 2}));
        Complex& complex = mesh.complex();
        RandomTopology(complex, random, 150, 3).run(10 * round);
        Names<VertexId> v(complex.vertex_attributes());
        Names<EdgeId> e(complex.edge_attributes());
        Names<FaceId> f(complex.face_attributes());
        Names<TetId> t(complex.tet_attributes());
        for (const VertexId h : vertices(complex)) v.note(h, simplex(h));
        for (const EdgeId h : edges(complex)) e.note(h, simplex(complex.vertices(h)));
        for (const FaceId h : faces(complex)) f.note(h, simplex(complex.vertices(h)));
        for (const TetId h : tets(complex)) t.note(h, simplex(complex.vertices(h)));
        const LabelledTets before = labelled_tets(complex);
        const std::vector<VertexId> vertex_order = shuffled(vertices(complex));
        const std::vector<TetId> tet_order = shuffled(tets(complex));
        const bool has_tet_order = round % 2 == 0;
        if (has_tet_order) {
            complex.renumber(vertex_order, tet_order);
        } else {
            complex.renumber(vertex_order);
        }

        require_valid(complex);
        REQUIRE(complex.vertex_capacity() == vertex_order.size());
        REQUIRE(complex.tet_capacity() == tet_order.size());
        REQUIRE(complex.edge_capacity() == complex.edge_count());
        REQUIRE(complex.face_capacity() == complex.face_count());
        for (std::uint32_t i = 0; i < complex.vertex_capacity(); ++i)
            REQUIRE(v.old[VertexId(i)] == vertex_order[i].index());
        if (has_tet_order)
            for (std::uint32_t i = 0; i < complex.tet_capacity(); ++i) REQUIRE(t.old[TetId(i)] == tet_order[i].index());
        const auto check = [&](const auto& handles, const auto& names, bool by_vertices) {
            VertexId last(0);
            for (const auto handle : handles) {
                const auto corners = complex.vertices(handle);
                Simplex name;
                for (const VertexId u : corners) name.insert(v.old[u]);
                REQUIRE(names.name[handle] == name);
                const VertexId least = *std::min_element(corners.begin(), corners.end());
                REQUIRE((!by_vertices || !(least < last)));
                last = least;
            }
        };
        check(edges(complex), e, true);
        check(faces(complex), f, true);
        check(tets(complex), t, !has_tet_order);
        LabelledTets after;
        for (const TetId h : tets(complex)) {
            TetVertices corners = complex.vertices(h);
            for (VertexId& u : corners) u = VertexId(v.old[u]);
            after.emplace(oriented(corners), complex.label(h));
        }
        CHECK(after == before);
        RandomTopology(complex, random, 150, 3).run(20);
        require_valid(complex);
    }
}

TEST_CASE("a complex that was compacted can be changed") {
    Random random(seed(2));
    Mesh mesh(box({2, 1, 1}));
    RandomTopology topology(mesh.complex(), random, 60, 2);
    for (int round = 0; round < 100; ++round) {
        topology.run(5);
        mesh.complex().compact();
        require_valid(mesh.complex());
    }
}
