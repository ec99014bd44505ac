// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "dsc3d/complex/complex.h"

namespace dsc::dsc3d {

namespace {

struct Renumbering {
    std::vector<std::uint32_t> new_to_old;
    std::vector<std::uint32_t> old_to_new;

    template <class IsDeleted>
    Renumbering(std::uint32_t capacity, IsDeleted&& is_deleted) : old_to_new(capacity) {
        for (std::uint32_t i = 0; i < capacity; ++i) {
            if (is_deleted(i)) continue;
            old_to_new[i] = static_cast<std::uint32_t>(new_to_old.size());
            new_to_old.push_back(i);
        }
    }

    template <class Value>
    void move(std::vector<Value>& values) const {
        std::vector<Value> kept;
        kept.reserve(new_to_old.size());
        for (const std::uint32_t old : new_to_old) kept.push_back(values[old]);
        values = std::move(kept);
    }
    template <class Handle>
    void rename(Handle& handle) const {
        if (handle.is_valid()) handle = Handle(old_to_new[handle.index()]);
    }
    template <class Handle, std::size_t N>
    void rename(std::array<Handle, N>& handles) const {
        for (Handle& handle : handles) rename(handle);
    }
    template <class Value>
    void rename(std::vector<Value>& values) const {
        for (Value& value : values) rename(value);
    }
};

}  // namespace

void Complex::compact() {
    const Renumbering new_vertices(vertex_capacity(), [&](std::uint32_t i) { return is_deleted(VertexId(i)); });
    const Renumbering new_edges(edge_capacity(), [&](std::uint32_t i) { return is_deleted(EdgeId(i)); });
    const Renumbering new_faces(face_capacity(), [&](std::uint32_t i) { return is_deleted(FaceId(i)); });
    const Renumbering new_tets(tet_capacity(), [&](std::uint32_t i) { return is_deleted(TetId(i)); });
    new_tets.move(tet_vertices_), new_vertices.rename(tet_vertices_);
    new_tets.move(tet_faces_), new_faces.rename(tet_faces_);
    new_tets.move(tet_label_);
    new_faces.move(face_edges_), new_edges.rename(face_edges_);
    new_faces.move(face_tets_), new_tets.rename(face_tets_);
    new_edges.move(edge_vertices_), new_vertices.rename(edge_vertices_);
    new_edges.move(edge_face_), new_faces.rename(edge_face_);
    new_edges.move(edge_faces_);
    new_vertices.move(vertex_edge_), new_edges.rename(vertex_edge_);
    new_vertices.move(vertex_faces_);
    free_tets_.clear(), free_faces_.clear(), free_edges_.clear(), free_vertices_.clear();
    vertex_attributes_->compact(new_vertices.new_to_old);
    edge_attributes_->compact(new_edges.new_to_old);
    face_attributes_->compact(new_faces.new_to_old);
    tet_attributes_->compact(new_tets.new_to_old);
}

}  // namespace dsc::dsc3d
