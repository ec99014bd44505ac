// SPDX-License-Identifier: GPL-3.0-or-later
// A complex from its tetrahedra: faces are found as pairs of equal vertex triples, edges as equal pairs, both bucketed
// by their least vertex, so that the cost is linear and the scratch is 24 bytes per tetrahedron.
#include <algorithm>
#include <string>

#include "core/errors.h"
#include "dsc3d/complex/complex.h"
#include "dsc3d/complex/traversal.h"

namespace dsc::dsc3d {

namespace {

FaceVertices sorted_face(const TetVertices& tet, std::uint32_t i) {
    FaceVertices corners;
    std::size_t k = 0;
    for (std::uint32_t j = 0; j < 4; ++j)
        if (j != i) corners[k++] = tet[j];
    std::sort(corners.begin(), corners.end());
    return corners;
}

EdgeVertices sorted_edge(const FaceVertices& face, std::uint32_t i) {
    const VertexId a = face[(i + 1) % 3], b = face[(i + 2) % 3];
    return a < b ? EdgeVertices{a, b} : EdgeVertices{b, a};
}

// Items 0 .. count - 1 in the order of their keys; items of equal keys in ascending order.
template <class KeyOf>
std::vector<std::uint32_t> order_by_key(std::uint32_t count, std::uint32_t vertex_count, KeyOf&& key_of) {
    std::vector<std::uint32_t> begin(vertex_count + 1, 0), order(count);
    for (std::uint32_t i = 0; i < count; ++i) ++begin[key_of(i)[0].index() + 1];
    for (std::uint32_t v = 0; v < vertex_count; ++v) begin[v + 1] += begin[v];
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (std::uint32_t i = 0; i < count; ++i) order[next[key_of(i)[0].index()]++] = i;
    for (std::uint32_t v = 0; v < vertex_count; ++v) {
        std::sort(order.begin() + begin[v], order.begin() + begin[v + 1], [&](std::uint32_t i, std::uint32_t j) {
            const auto a = key_of(i), b = key_of(j);
            return a != b ? a < b : i < j;
        });
    }
    return order;
}

[[noreturn]] void reject(const std::string& source, std::uint32_t tet, const std::string& problem) {
    throw core::InputError(source, "tetrahedron " + std::to_string(tet) + " (counted from 0)", problem,
                           "the tetrahedra have to fill a manifold, meeting face to face");
}

template <std::size_t N>
std::string names(const std::array<VertexId, N>& vertices) {
    std::string text;
    for (const VertexId v : vertices) text += (text.empty() ? "" : " ") + std::to_string(v.index());
    return text;
}

}  // namespace

Complex::Complex(std::uint32_t vertex_count, std::span<const NewTet> tets, const std::string& source) : Complex() {
    build_tets(tets);
    build_faces(vertex_count, source);
    build_edges(vertex_count);
    vertex_edge_.assign(vertex_count, EdgeId());
    for (std::uint32_t i = 0; i < edge_capacity(); ++i)
        for (const VertexId v : edge_vertices_[i])
            if (!vertex_edge_[v.index()].is_valid()) vertex_edge_[v.index()] = EdgeId(i);
    count_surface_faces();
    require_manifold(source);
    vertex_attributes_->resize(vertex_edge_.size());
    edge_attributes_->resize(edge_vertices_.size());
    face_attributes_->resize(face_edges_.size());
    tet_attributes_->resize(tet_vertices_.size());
}

void Complex::build_tets(std::span<const NewTet> tets) {
    tet_vertices_.reserve(with_room(tets.size()));
    tet_label_.reserve(with_room(tets.size()));
    for (const NewTet& tet : tets) {
        tet_vertices_.push_back(tet.vertices);
        tet_label_.push_back(tet.label);
    }
    tet_faces_.reserve(with_room(tets.size()));
    tet_faces_.resize(tets.size());
}

void Complex::build_faces(std::uint32_t vertex_count, const std::string& source) {
    const std::uint32_t count = 4 * tet_capacity();
    const auto key_of = [&](std::uint32_t i) { return sorted_face(tet_vertices_[i / 4], i % 4); };
    const std::vector<std::uint32_t> order = order_by_key(count, vertex_count, key_of);
    std::uint32_t faces = 0;
    for (std::uint32_t k = 0; k < count; ++k) faces += k == 0 || key_of(order[k]) != key_of(order[k - 1]) ? 1u : 0u;
    face_tets_.reserve(with_room(faces));
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::uint32_t tet = order[k] / 4;
        if (k == 0 || key_of(order[k]) != key_of(order[k - 1])) {
            face_tets_.push_back({TetId(tet), TetId()});
        } else {
            std::array<TetId, 2>& sides = face_tets_.back();
            const FaceVertices corners = key_of(order[k]);
            if (sides[1].is_valid())
                reject(source, tet, "its face " + names(corners) + " belongs to two other tetrahedra already");
            const FaceVertices here = oriented_face(TetId(tet), static_cast<int>(order[k] % 4));
            const FaceVertices there = oriented_face(sides[0], static_cast<int>(order[k - 1] % 4));
            const auto turn = std::find(there.begin(), there.end(), here[0]) - there.begin();
            if (there[static_cast<std::size_t>((turn + 1) % 3)] == here[1])
                reject(source, tet,
                       "it lies on the same side of its face " + names(corners) + " as tetrahedron " +
                           std::to_string(sides[0].index()));
            sides[1] = TetId(tet);
        }
        tet_faces_[tet][order[k] % 4] = FaceId(static_cast<std::uint32_t>(face_tets_.size() - 1));
    }
}

void Complex::build_edges(std::uint32_t vertex_count) {
    const std::uint32_t count = 3 * static_cast<std::uint32_t>(face_tets_.size());
    const auto key_of = [&](std::uint32_t i) {
        const TetId t = face_tets_[i / 3][0];
        return sorted_edge(oriented_face(t, index_of(t, FaceId(i / 3))), i % 3);
    };
    const std::vector<std::uint32_t> order = order_by_key(count, vertex_count, key_of);
    face_edges_.reserve(with_room(face_tets_.size()));
    face_edges_.resize(face_tets_.size());
    std::uint32_t edges = 0;
    for (std::uint32_t k = 0; k < count; ++k) edges += k == 0 || key_of(order[k]) != key_of(order[k - 1]) ? 1u : 0u;
    edge_vertices_.reserve(with_room(edges));
    edge_face_.reserve(with_room(edges));
    for (std::uint32_t k = 0; k < count; ++k) {
        const EdgeVertices ends = key_of(order[k]);
        if (k == 0 || ends != key_of(order[k - 1])) {
            edge_vertices_.push_back(ends);
            edge_face_.push_back(FaceId(order[k] / 3));
        }
        face_edges_[order[k] / 3][order[k] % 3] = EdgeId(edge_capacity() - 1);
    }
}

// A vertex or an edge is manifold when its link is a sphere, a disc, a circle or a path. With faces of at most two
// tetrahedra, stars connected through faces and Euler's number of the link decide that.
void Complex::require_manifold(const std::string& source) const {
    std::vector<std::uint32_t> tets_at_edge(edge_capacity(), 0), tets_at_vertex(vertex_capacity(), 0);
    std::vector<int> euler(vertex_capacity(), 0);
    for (std::uint32_t i = 0; i < tet_capacity(); ++i) {
        for (const EdgeId e : edges(TetId(i))) ++tets_at_edge[e.index()];
        for (const VertexId v : vertices(TetId(i))) ++tets_at_vertex[v.index()], ++euler[v.index()];
    }
    for (std::uint32_t i = 0; i < face_capacity(); ++i)
        for (const VertexId v : vertices(FaceId(i))) --euler[v.index()];
    for (std::uint32_t i = 0; i < edge_capacity(); ++i)
        for (const VertexId v : vertices(EdgeId(i))) ++euler[v.index()];

    EdgeRing ring;
    for (std::uint32_t i = 0; i < edge_capacity(); ++i) {
        const EdgeId e(i);
        gather_ring(*this, e, ring);
        if (ring.tets.size() != tets_at_edge[i])
            reject(source, tet(e).index(), "its edge " + names(vertices(e)) + " joins parts that share no face there");
    }
    StarWalker walker(*this);
    for (std::uint32_t i = 0; i < vertex_capacity(); ++i) {
        const VertexId v(i);
        if (is_deleted(v)) continue;
        if (walker.star(v).size() != tets_at_vertex[i] || euler[i] != (is_boundary(v) ? 1 : 2))
            reject(source, tet(v).index(), "its vertex " + std::to_string(i) + " joins parts that share no face there");
    }
}

}  // namespace dsc::dsc3d
