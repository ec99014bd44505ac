// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/complex_arrays.h"

#include "core/errors.h"

namespace dsc::dsc2d {

namespace {

using Numbers = std::vector<std::uint32_t>;

void require_size(const char* name, std::size_t size, std::size_t expected) {
    if (size != expected)
        throw core::InputError(
            "complex", name,
            "has " + std::to_string(size) + " values where " + std::to_string(expected) + " are expected", "");
}

// All below `bound`, or none.
void require_range(const char* name, const Numbers& numbers, std::size_t bound) {
    for (const std::uint32_t number : numbers)
        if (number >= bound && number != ComplexArrays::none)
            throw core::InputError("complex", name, "names something that does not exist", "");
}

void require_arrays(const ComplexArrays& arrays) {
    const std::size_t vertices = arrays.positions.size(), halfedges = arrays.ends.size(), faces = arrays.labels.size();
    require_size("outgoing", arrays.outgoing.size(), vertices);
    require_size("is_locked", arrays.is_locked.size(), vertices);
    require_size("ends", halfedges, halfedges / 2 * 2);
    require_size("next", arrays.next.size(), halfedges);
    require_size("faces", arrays.faces.size(), halfedges);
    require_size("offsets", arrays.offsets.size(), halfedges);
    require_size("halfedges", arrays.halfedges.size(), faces);
    require_range("outgoing", arrays.outgoing, halfedges);
    require_range("ends", arrays.ends, vertices);
    require_range("next", arrays.next, halfedges);
    require_range("faces", arrays.faces, faces);
    require_range("halfedges", arrays.halfedges, halfedges);
    for (std::size_t h = 0; h < halfedges; ++h)
        if ((arrays.ends[h] == ComplexArrays::none) != (arrays.next[h] == ComplexArrays::none) ||
            (arrays.ends[h] == ComplexArrays::none) != (arrays.ends[h ^ 1] == ComplexArrays::none))
            throw core::InputError("complex", "half-edge " + std::to_string(h), "is there in part only", "");
}

}  // namespace

ComplexArrays Complex::arrays() const {
    ComplexArrays arrays;
    for (std::uint32_t i = 0; i < vertex_capacity(); ++i) {
        const VertexId v(i);
        arrays.outgoing.push_back(is_deleted(v) ? ComplexArrays::none : halfedge(v).index());
        arrays.positions.push_back(position(v));
        arrays.is_locked.push_back(is_locked_[v]);
    }
    for (std::uint32_t i = 0; i < 2 * edge_capacity(); ++i) {
        const HalfedgeId h(i);
        const bool is_there = !is_deleted(edge(h));
        arrays.ends.push_back(is_there ? to(h).index() : ComplexArrays::none);
        arrays.next.push_back(is_there ? next(h).index() : ComplexArrays::none);
        arrays.faces.push_back(is_there && !is_boundary(h) ? face(h).index() : ComplexArrays::none);
        arrays.offsets.push_back(offset(h));
    }
    for (std::uint32_t i = 0; i < face_capacity(); ++i) {
        const FaceId f(i);
        arrays.halfedges.push_back(is_deleted(f) ? ComplexArrays::none : halfedge(f).index());
        arrays.labels.push_back(label(f));
    }
    return arrays;
}

Complex::Complex(const Domain& domain, const ComplexArrays& arrays) : Complex(domain) {
    require_arrays(arrays);
    for (const Point2& position : arrays.positions) new_vertex(position);
    const OpenMesh::VertexHandle end_to_be_set;
    for (std::size_t h = 0; h < arrays.ends.size(); h += 2) mesh_.new_edge(end_to_be_set, end_to_be_set);
    for (std::size_t f = 0; f < arrays.labels.size(); ++f) mesh_.new_face();
    resize_attributes();

    for (std::uint32_t i = 0; i < vertex_capacity(); ++i) {
        const auto v = to_kernel(VertexId(i));
        is_locked_[VertexId(i)] = arrays.is_locked[i];
        if (arrays.outgoing[i] == ComplexArrays::none) {
            mesh_.status(v).set_deleted(true);
            ++deleted_vertices_;
        } else {
            mesh_.set_halfedge_handle(v, to_kernel(HalfedgeId(arrays.outgoing[i])));
        }
    }
    for (std::uint32_t i = 0; i < 2 * edge_capacity(); ++i) {
        const auto h = to_kernel(HalfedgeId(i));
        offset_[HalfedgeId(i)] = arrays.offsets[i];
        if (arrays.ends[i] == ComplexArrays::none) {
            mesh_.status(h).set_deleted(true);
            mesh_.status(mesh_.edge_handle(h)).set_deleted(true);
            continue;
        }
        mesh_.set_vertex_handle(h, to_kernel(VertexId(arrays.ends[i])));
        mesh_.set_next_halfedge_handle(h, to_kernel(HalfedgeId(arrays.next[i])));
        if (arrays.faces[i] != ComplexArrays::none) mesh_.set_face_handle(h, to_kernel(FaceId(arrays.faces[i])));
    }
    for (std::uint32_t i = 0; i < face_capacity(); ++i) {
        const auto f = to_kernel(FaceId(i));
        label_[FaceId(i)] = arrays.labels[i];
        if (arrays.halfedges[i] == ComplexArrays::none) {
            mesh_.status(f).set_deleted(true);
            ++deleted_faces_;
        } else {
            mesh_.set_halfedge_handle(f, to_kernel(HalfedgeId(arrays.halfedges[i])));
        }
    }
    for (std::uint32_t e = 0; e < edge_capacity(); ++e)
        if (!is_deleted(EdgeId(e))) refresh_interface(EdgeId(e));
}

}  // namespace dsc::dsc2d
