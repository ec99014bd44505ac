// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "dsc3d/complex/complex.h"

namespace dsc::dsc3d {

/// A new numbering: which simplex of the present one comes at each place.
struct Complex::Order {
    std::vector<std::uint32_t> new_to_old;
    std::vector<std::uint32_t> old_to_new;

    Order(std::uint32_t capacity, std::vector<std::uint32_t> order)
        : new_to_old(std::move(order)), old_to_new(capacity) {
        for (std::uint32_t i = 0; i < new_to_old.size(); ++i) old_to_new[new_to_old[i]] = i;
    }
    template <class Handle>
    Order(std::uint32_t capacity, std::span<const Handle> order) : Order(capacity, indices(order)) {}

    /// All in use, in their present order.
    template <class Handle>
    static Order present(const Complex& complex, std::uint32_t capacity) {
        std::vector<std::uint32_t> order;
        for (std::uint32_t i = 0; i < capacity; ++i)
            if (!complex.is_deleted(Handle(i))) order.push_back(i);
        return {capacity, std::move(order)};
    }

    /// All in use, by the least of their vertices; equal ones in their present order.
    template <class Handle>
    static Order by_vertices(const Complex& complex, std::uint32_t capacity) {
        const auto least = [&](std::uint32_t i) {
            const auto corners = complex.vertices(Handle(i));
            return std::min_element(corners.begin(), corners.end())->index();
        };
        std::vector<std::uint32_t> begin(complex.vertex_capacity() + 1, 0);
        for (std::uint32_t i = 0; i < capacity; ++i)
            if (!complex.is_deleted(Handle(i))) ++begin[least(i) + 1];
        for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
        std::vector<std::uint32_t> order(begin.back());
        for (std::uint32_t i = 0; i < capacity; ++i)
            if (!complex.is_deleted(Handle(i))) order[begin[least(i)]++] = i;
        return {capacity, std::move(order)};
    }

    template <class Value>
    void move(std::vector<Value>& values) const {
        std::vector<Value> kept;
        kept.reserve(with_room(new_to_old.size()));
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

private:
    template <class Handle>
    static std::vector<std::uint32_t> indices(std::span<const Handle> handles) {
        std::vector<std::uint32_t> order;
        order.reserve(handles.size());
        for (const Handle handle : handles) order.push_back(handle.index());
        return order;
    }
};

// One kind of simplex after the other, so that only one order is in memory at a time.
void Complex::compact() {
    reorder_vertices(Order::present<VertexId>(*this, vertex_capacity()));
    reorder_edges(Order::present<EdgeId>(*this, edge_capacity()));
    reorder_faces(Order::present<FaceId>(*this, face_capacity()));
    reorder_tets(Order::present<TetId>(*this, tet_capacity()));
}

void Complex::renumber(std::span<const VertexId> vertices) {
    DSC_ASSERT(vertices.size() == vertex_count());
    reorder_vertices(Order(vertex_capacity(), vertices));
    reorder_edges(Order::by_vertices<EdgeId>(*this, edge_capacity()));
    reorder_faces(Order::by_vertices<FaceId>(*this, face_capacity()));
    reorder_tets(Order::by_vertices<TetId>(*this, tet_capacity()));
}

void Complex::renumber(std::span<const VertexId> vertices, std::span<const TetId> tets) {
    DSC_ASSERT(vertices.size() == vertex_count() && tets.size() == tet_count());
    reorder_vertices(Order(vertex_capacity(), vertices));
    reorder_edges(Order::by_vertices<EdgeId>(*this, edge_capacity()));
    reorder_faces(Order::by_vertices<FaceId>(*this, face_capacity()));
    reorder_tets(Order(tet_capacity(), tets));
}

void Complex::reorder_vertices(const Order& order) {
    order.move(vertex_edge_);
    order.move(vertex_faces_);
    order.rename(edge_vertices_);
    order.rename(tet_vertices_);
    free_vertices_.clear();
    vertex_attributes_->compact(order.new_to_old);
}

void Complex::reorder_edges(const Order& order) {
    order.move(edge_vertices_);
    order.move(edge_face_);
    order.move(edge_faces_);
    order.rename(vertex_edge_);
    order.rename(face_edges_);
    free_edges_.clear();
    edge_attributes_->compact(order.new_to_old);
}

void Complex::reorder_faces(const Order& order) {
    order.move(face_edges_);
    order.move(face_tets_);
    order.rename(edge_face_);
    order.rename(tet_faces_);
    free_faces_.clear();
    face_attributes_->compact(order.new_to_old);
}

void Complex::reorder_tets(const Order& order) {
    order.move(tet_vertices_);
    order.move(tet_faces_);
    order.move(tet_label_);
    order.rename(face_tets_);
    free_tets_.clear();
    tet_attributes_->compact(order.new_to_old);
}

}  // namespace dsc::dsc3d
