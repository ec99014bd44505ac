// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/complex/complex.h"

#include <algorithm>

namespace dsc::dsc3d {

namespace {

template <class Array>
Array sorted(Array vertices) {
    std::sort(vertices.begin(), vertices.end());
    return vertices;
}

// Face i of the oriented tetrahedron [v0 v1 v2 v3] with its induced orientation.
FaceVertices induced_face(const TetVertices& v, int i) {
    switch (i) {
        case 0: return {v[1], v[2], v[3]};
        case 1: return {v[0], v[3], v[2]};
        case 2: return {v[0], v[1], v[3]};
        default: return {v[0], v[2], v[1]};
    }
}

}  // namespace

Complex::Complex()
    : vertex_attributes_(std::make_shared<core::AttributeRegistry<VertexId>>()),
      edge_attributes_(std::make_shared<core::AttributeRegistry<EdgeId>>()),
      face_attributes_(std::make_shared<core::AttributeRegistry<FaceId>>()),
      tet_attributes_(std::make_shared<core::AttributeRegistry<TetId>>()) {}

FaceVertices Complex::vertices(FaceId f) const {
    const std::array<EdgeId, 3>& sides = edges(f);
    const EdgeVertices& e0 = vertices(sides[0]);
    const EdgeVertices& e1 = vertices(sides[1]);
    // Vertex 0 is the end of edge 1 that is not on edge 0; then edge 1 is {0, 2}.
    const bool is_first = e1[0] != e0[0] && e1[0] != e0[1];
    const VertexId v0 = is_first ? e1[0] : e1[1];
    const VertexId v2 = is_first ? e1[1] : e1[0];
    const VertexId v1 = e0[0] == v2 ? e0[1] : e0[0];
    return {v0, v1, v2};
}

std::array<EdgeId, 6> Complex::edges(TetId t) const {
    const TetVertices& v = vertices(t);
    const auto edge_between = [&](FaceId f, VertexId a, VertexId b) {
        for (const EdgeId e : edges(f)) {
            const EdgeVertices& ends = vertices(e);
            if ((ends[0] == a && ends[1] == b) || (ends[0] == b && ends[1] == a)) return e;
        }
        DSC_ASSERT(false);
        return EdgeId();
    };
    const std::array<FaceId, 4>& f = faces(t);
    return {edge_between(f[2], v[0], v[1]), edge_between(f[1], v[0], v[2]), edge_between(f[1], v[0], v[3]),
            edge_between(f[0], v[1], v[2]), edge_between(f[0], v[1], v[3]), edge_between(f[0], v[2], v[3])};
}

FaceVertices Complex::oriented_face(TetId t, int i) const { return induced_face(vertices(t), i); }

Complex::FaceKind Complex::kind(FaceId f) const {
    if (!face_tets_[f.index()][0].is_valid()) return FaceKind::none;
    if (is_boundary(f)) return FaceKind::boundary;
    return is_interface(f) ? FaceKind::interface : FaceKind::interior;
}

void Complex::count_face(const FaceVertices& corners, const std::array<EdgeId, 3>& edges, FaceKind kind, int change) {
    const auto add = [change](auto& count) { count = static_cast<std::decay_t<decltype(count)>>(count + change); };
    if (kind == FaceKind::boundary) {
        for (const EdgeId e : edges) add(edge_faces_[e.index()].boundary);
        for (const VertexId v : corners) add(vertex_faces_[v.index()].boundary);
    } else if (kind == FaceKind::interface) {
        for (const EdgeId e : edges) add(edge_faces_[e.index()].interface);
        for (const VertexId v : corners) add(vertex_faces_[v.index()].interface);
    }
}

void Complex::count_surface_faces() {
    edge_faces_.reserve(with_room(edge_capacity()));
    edge_faces_.assign(edge_capacity(), {});
    vertex_faces_.assign(vertex_capacity(), {});
    for (std::uint32_t i = 0; i < face_capacity(); ++i) {
        const FaceId f(i);
        const FaceKind k = kind(f);
        if (k == FaceKind::boundary || k == FaceKind::interface) count_face(vertices(f), edges(f), k, 1);
    }
}

void Complex::set_label(TetId t, int label) {
    if (tet_label_[t.index()] == label) return;
    for (const FaceId f : faces(t)) count_face(vertices(f), edges(f), kind(f), -1);
    tet_label_[t.index()] = label;
    for (const FaceId f : faces(t)) count_face(vertices(f), edges(f), kind(f), 1);
}

VertexId Complex::add_vertex() {
    if (!free_vertices_.empty()) {
        const VertexId v = free_vertices_.back();
        free_vertices_.pop_back();
        vertex_faces_[v.index()] = {};
        vertex_attributes_->reset(v);
        return v;
    }
    const VertexId v(vertex_capacity());
    grow(vertex_edge_);
    grow(vertex_faces_);
    vertex_attributes_->resize(vertex_edge_.size());
    return v;
}

TetId Complex::new_tet() {
    if (!free_tets_.empty()) {
        const TetId t = free_tets_.back();
        free_tets_.pop_back();
        tet_attributes_->reset(t);
        return t;
    }
    const TetId t(tet_capacity());
    grow(tet_vertices_);
    grow(tet_faces_);
    grow(tet_label_);
    tet_attributes_->resize(tet_vertices_.size());
    return t;
}

FaceId Complex::new_face() {
    if (!free_faces_.empty()) {
        const FaceId f = free_faces_.back();
        free_faces_.pop_back();
        face_attributes_->reset(f);
        return f;
    }
    const FaceId f(face_capacity());
    grow(face_edges_);
    grow(face_tets_);
    face_attributes_->resize(face_edges_.size());
    return f;
}

EdgeId Complex::new_edge() {
    if (!free_edges_.empty()) {
        const EdgeId e = free_edges_.back();
        free_edges_.pop_back();
        edge_faces_[e.index()] = {};
        edge_attributes_->reset(e);
        return e;
    }
    const EdgeId e(edge_capacity());
    grow(edge_vertices_);
    grow(edge_face_);
    grow(edge_faces_);
    edge_attributes_->resize(edge_vertices_.size());
    return e;
}

const Complex::Change& Complex::replace(std::span<const TetId> removed, std::span<const NewTet> added) {
    change_.added_tets.clear();
    change_.removed_tets.assign(removed.begin(), removed.end());
    change_.added_faces.clear();
    change_.added_edges.clear();
    change_.removed_vertices.clear();
    gather_cavity(removed);
    detach(removed);
    attach(added);
    settle_faces();
    settle_edges_and_vertices();
    free_tets_.insert(free_tets_.end(), removed.begin(), removed.end());
    return change_;
}

// All faces and edges of the cavity go into the tables, before anything changes.
void Complex::gather_cavity(std::span<const TetId> removed) {
    cavity_faces_.clear();
    cavity_edges_.clear();
    for (const TetId t : removed) {
        for (int i = 0; i < 4; ++i) {
            const auto [entry, is_new] = cavity_faces_.insert(sorted(oriented_face(t, i)));
            if (!is_new) continue;
            const FaceId f = faces(t)[static_cast<std::size_t>(i)];
            *entry = {f, kind(f)};
            for (const EdgeId e : edges(f)) cavity_edges_.insert(sorted(vertices(e))).first->edge = e;
        }
    }
}

void Complex::detach(std::span<const TetId> removed) {
    for (const TetId t : removed) {
        for (const FaceId f : faces(t)) {
            std::array<TetId, 2>& sides = face_tets_[f.index()];
            if (sides[0] == t) sides[0] = sides[1];
            sides[1] = TetId();
        }
        tet_faces_[t.index()].fill(FaceId());
    }
}

EdgeId Complex::cavity_edge(VertexId a, VertexId b) {
    const auto [entry, is_new] = cavity_edges_.insert(a < b ? EdgeVertices{a, b} : EdgeVertices{b, a});
    if (is_new) {
        const EdgeId e = new_edge();
        edge_vertices_[e.index()] = {a, b};
        entry->edge = e;
        change_.added_edges.push_back(e);
    }
    return entry->edge;
}

FaceId Complex::cavity_face(const FaceVertices& corners) {
    const auto [entry, is_new] = cavity_faces_.insert(sorted(corners));
    if (is_new) {
        const FaceId f = new_face();
        entry->face = f;
        face_edges_[f.index()] = {cavity_edge(corners[1], corners[2]), cavity_edge(corners[2], corners[0]),
                                  cavity_edge(corners[0], corners[1])};
        face_tets_[f.index()].fill(TetId());
        change_.added_faces.push_back(f);
    }
    return entry->face;
}

void Complex::attach(std::span<const NewTet> added) {
    for (const NewTet& tet : added) {
        const TetId t = new_tet();
        change_.added_tets.push_back(t);
        tet_vertices_[t.index()] = tet.vertices;
        tet_label_[t.index()] = tet.label;
        for (int i = 0; i < 4; ++i) {
            const FaceId f = cavity_face(induced_face(tet.vertices, i));
            tet_faces_[t.index()][static_cast<std::size_t>(i)] = f;
            std::array<TetId, 2>& sides = face_tets_[f.index()];
            DSC_ASSERT(!sides[1].is_valid());
            sides[sides[0].is_valid() ? 1 : 0] = t;
        }
    }
}

void Complex::settle_faces() {
    for (auto& [corners, cavity_face] : cavity_faces_.entries()) {
        const FaceId f = cavity_face.face;
        const FaceKind kind_now = kind(f);
        if (kind_now != cavity_face.kind_before) {
            count_face(corners, edges(f), cavity_face.kind_before, -1);
            count_face(corners, edges(f), kind_now, 1);
        }
        if (kind_now == FaceKind::none) {
            free_faces_.push_back(f);
            continue;
        }
        for (const EdgeId e : edges(f)) {
            edge_face_[e.index()] = f;
            cavity_edges_.insert(sorted(vertices(e))).first->is_used = true;
        }
    }
}

// In a manifold complex an edge of the cavity that is still in use has a face of the cavity that is: its star is
// connected through faces. The same holds for a vertex and its edges.
void Complex::settle_edges_and_vertices() {
    cavity_vertices_.clear();
    for (const auto& [ends, cavity_edge] : cavity_edges_.entries()) {
        for (const VertexId v : ends) {
            if (vertex_edge_[v.index()].is_valid()) cavity_vertices_.push_back(v);
            vertex_edge_[v.index()] = EdgeId();
        }
    }
    for (const auto& [ends, cavity_edge] : cavity_edges_.entries()) {
        if (cavity_edge.is_used) {
            for (const VertexId v : ends) vertex_edge_[v.index()] = cavity_edge.edge;
        } else {
            edge_face_[cavity_edge.edge.index()] = FaceId();
            free_edges_.push_back(cavity_edge.edge);
        }
    }
    for (const VertexId v : cavity_vertices_) {
        if (vertex_edge_[v.index()].is_valid()) continue;
        free_vertices_.push_back(v);
        change_.removed_vertices.push_back(v);
    }
}

std::size_t Complex::memory() const {
    const auto bytes = [](const auto& values) {
        return values.capacity() * sizeof(typename std::decay_t<decltype(values)>::value_type);
    };
    return bytes(tet_vertices_) + bytes(tet_faces_) + bytes(tet_label_) + bytes(face_edges_) + bytes(face_tets_) +
           bytes(edge_vertices_) + bytes(edge_face_) + bytes(edge_faces_) + bytes(vertex_edge_) + bytes(vertex_faces_) +
           bytes(free_tets_) + bytes(free_faces_) + bytes(free_edges_) + bytes(free_vertices_);
}

}  // namespace dsc::dsc3d
