// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/complex.h"

#include <string>

#include "core/errors.h"
#include "geometry/triangle.h"

namespace dsc::dsc2d {

namespace {

// The new-to-old numbering of one kind of handle, read from a property that OpenMesh carried through its collection.
template <class Count, class Property>
std::vector<std::uint32_t> read_numbering(Count count, const Property& old_index) {
    std::vector<std::uint32_t> new_to_old(count);
    for (std::size_t i = 0; i < new_to_old.size(); ++i) new_to_old[i] = old_index(static_cast<int>(i));
    return new_to_old;
}

}  // namespace

Complex::Complex(const Domain& domain, std::span<const Point2> points, std::span<const TriangleInput> triangles)
    : domain_(domain),
      vertices_(std::make_shared<core::AttributeRegistry<VertexId>>()),
      halfedges_(std::make_shared<core::AttributeRegistry<HalfedgeId>>()),
      edges_(std::make_shared<core::AttributeRegistry<EdgeId>>()),
      faces_(std::make_shared<core::AttributeRegistry<FaceId>>()),
      offset_(halfedges_, LatticeVector::Zero()),
      label_(faces_, 0),
      is_interface_(edges_, 0),
      interface_degree_(vertices_, 0),
      is_locked_(vertices_, 0) {
    for (const Point2& point : points) {
        if (!domain_.is_in_reach(point)) throw core::InputError("complex", "", "a point lies far outside the domain", "");
        new_vertex(domain_.snapped(point));
    }
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const TriangleInput& triangle = triangles[t];
        const auto fail = [&](const char* problem) {
            throw core::InputError("complex", "triangle " + std::to_string(t), problem, "");
        };
        std::array<OpenMesh::VertexHandle, 3> corners;
        std::array<Point2, 3> places;
        for (std::size_t i = 0; i < 3; ++i) {
            if (triangle.vertices[i] >= points.size()) fail("names a vertex that does not exist");
            corners[i] = OpenMesh::VertexHandle(static_cast<int>(triangle.vertices[i]));
            places[i] = mesh_.point(corners[i]) + domain_.translation(triangle.cells[i]);
        }
        if (!geometry::is_counterclockwise(places[0], places[1], places[2])) fail("is not counterclockwise");
        const auto face = mesh_.add_face(corners[0], corners[1], corners[2]);
        if (!face.is_valid()) fail("does not fit into an oriented manifold with its neighbours");
        resize_attributes();
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            set_offset(from_kernel(mesh_.find_halfedge(corners[i], corners[j])), triangle.cells[j] - triangle.cells[i]);
        }
        label_[from_kernel(face)] = triangle.label;
    }
    for (std::uint32_t v = 0; v < vertex_capacity(); ++v)
        if (!halfedge(VertexId(v)).is_valid())
            throw core::InputError("complex", "vertex " + std::to_string(v), "belongs to no triangle", "");
    for (std::uint32_t e = 0; e < edge_capacity(); ++e) refresh_interface(EdgeId(e));
}

std::array<Point2, 3> Complex::corners(FaceId f) const {
    const HalfedgeId h = halfedge(f);
    const Point2 a = position(from(h));
    return {a, a + vector(h), a - vector(prev(h))};
}

double Complex::area(FaceId f) const {
    const HalfedgeId h = halfedge(f);
    return 0.5 * geometry::cross(vector(h), -vector(prev(h)));
}

void Complex::set_label(FaceId f, int label) {
    label_[f] = label;
    const HalfedgeId h = halfedge(f);
    refresh_interface(edge(h));
    refresh_interface(edge(next(h)));
    refresh_interface(edge(prev(h)));
}

void Complex::reanchor(VertexId v, const LatticeVector& cell) {
    set_position_unchecked(v, position(v) + domain_.translation(cell));
    for (const HalfedgeId h : outgoing(v)) set_offset(h, offset(h) + cell);
}

void Complex::flip_unchecked(HalfedgeId h, int label_of_both) {
    // a -> b with c on the left and d on the right becomes d -> c.
    const HalfedgeId o = opposite(h);
    const auto a0 = to_kernel(h), a1 = to_kernel(next(h)), a2 = to_kernel(prev(h));
    const auto b0 = to_kernel(o), b1 = to_kernel(next(o)), b2 = to_kernel(prev(o));
    const auto b = mesh_.to_vertex_handle(a0), a = mesh_.to_vertex_handle(b0);
    const auto c = mesh_.to_vertex_handle(a1), d = mesh_.to_vertex_handle(b1);
    const auto left = mesh_.face_handle(a0), right = mesh_.face_handle(b0);
    set_interface(edge(h), false);

    mesh_.set_vertex_handle(a0, c);
    mesh_.set_vertex_handle(b0, d);
    mesh_.set_next_halfedge_handle(a0, a2);
    mesh_.set_next_halfedge_handle(a2, b1);
    mesh_.set_next_halfedge_handle(b1, a0);
    mesh_.set_next_halfedge_handle(b0, b2);
    mesh_.set_next_halfedge_handle(b2, a1);
    mesh_.set_next_halfedge_handle(a1, b0);
    mesh_.set_face_handle(a1, right);
    mesh_.set_face_handle(b1, left);
    mesh_.set_halfedge_handle(left, a0);
    mesh_.set_halfedge_handle(right, b0);
    if (mesh_.halfedge_handle(a) == a0) mesh_.set_halfedge_handle(a, b1);
    if (mesh_.halfedge_handle(b) == b0) mesh_.set_halfedge_handle(b, a1);

    set_offset(h, -(offset(from_kernel(a2)) + offset(from_kernel(b1))));
    const FaceId faces[2] = {from_kernel(left), from_kernel(right)};
    if (label(faces[0]) == label_of_both && label(faces[1]) == label_of_both) return;
    for (const FaceId f : faces) set_label(f, label_of_both);
}

VertexId Complex::split_edge_unchecked(HalfedgeId h, const Point2& position) {
    const HalfedgeId o = opposite(h);
    const bool was_interface = is_interface(edge(h));
    const LatticeVector to_b = offset(h);
    const LatticeVector to_c = is_boundary(h) ? LatticeVector::Zero() : LatticeVector(-offset(prev(h)));
    const LatticeVector to_d = is_boundary(o) ? LatticeVector::Zero() : offset(next(o));
    const FaceId left = face(h), right = face(o);
    set_interface(edge(h), false);

    const VertexId m = new_vertex(position);
    mesh_.split_edge(to_kernel(edge(h)), to_kernel(m));
    resize_attributes();
    // The split keeps half-edge 0 of the old edge leaving from m, so h is now either m -> b or a -> m. The ring of m is,
    // counterclockwise, b, c (if there is a left face), a, d (if there is a right face).
    HalfedgeId toward_b, toward_a;
    if (from(h) == m) {
        toward_b = h;
        toward_a = left.is_valid() ? rotated(rotated(toward_b)) : rotated(toward_b);
    } else {
        toward_a = opposite(h);
        toward_b = right.is_valid() ? rotated(rotated(toward_a)) : rotated(toward_a);
    }
    set_offset(toward_a, LatticeVector::Zero());
    set_offset(toward_b, to_b);
    if (left.is_valid()) set_offset(rotated(toward_b), to_c);
    if (right.is_valid()) set_offset(rotated(toward_a), to_d);

    if (left.is_valid()) label_[face(toward_b)] = label_[face(rotated(toward_b))] = label_[left];
    if (right.is_valid()) label_[face(toward_a)] = label_[face(rotated(toward_a))] = label_[right];
    set_interface(edge(toward_b), was_interface);
    set_interface(edge(toward_a), was_interface);
    return m;
}

VertexId Complex::split_face_unchecked(HalfedgeId h, const Point2& position) {
    const FaceId f = face(h);
    const HalfedgeId hn = next(h), hp = prev(h);
    const LatticeVector to_b = offset(h), to_c = -offset(hp);
    const VertexId m = new_vertex(position);
    mesh_.split(to_kernel(f), to_kernel(m));
    resize_attributes();
    set_offset(prev(h), LatticeVector::Zero());
    set_offset(prev(hn), to_b);
    set_offset(prev(hp), to_c);
    for (const HalfedgeId side : {h, hn, hp}) label_[face(side)] = label_[f];
    return m;
}

void Complex::collapse_unchecked(HalfedgeId h) {
    const VertexId a = from(h), b = to(h);
    const LatticeVector to_b = offset(h);
    for (const HalfedgeId out : outgoing(a)) {
        set_interface(edge(out), false);
        set_offset(out, offset(out) - to_b);
    }
    for (const HalfedgeId out : outgoing(b)) set_interface(edge(out), false);
    // The edges between b and the two apexes survive with the offsets they have.
    deleted_faces_ += (is_boundary(h) ? 0u : 1u) + (is_boundary(opposite(h)) ? 0u : 1u);
    ++deleted_vertices_;
    mesh_.collapse(to_kernel(h));
    for (const HalfedgeId out : outgoing(b)) refresh_interface(edge(out));
}

double Complex::garbage_fraction() const {
    return vertex_capacity() == 0 ? 0.0 : static_cast<double>(deleted_vertices_) / vertex_capacity();
}

void Complex::compact() {
    OpenMesh::VPropHandleT<std::uint32_t> vertex_index;
    OpenMesh::HPropHandleT<std::uint32_t> halfedge_index;
    OpenMesh::EPropHandleT<std::uint32_t> edge_index;
    OpenMesh::FPropHandleT<std::uint32_t> face_index;
    mesh_.add_property(vertex_index);
    mesh_.add_property(halfedge_index);
    mesh_.add_property(edge_index);
    mesh_.add_property(face_index);
    for (const auto v : mesh_.all_vertices()) mesh_.property(vertex_index, v) = static_cast<std::uint32_t>(v.idx());
    for (const auto h : mesh_.all_halfedges()) mesh_.property(halfedge_index, h) = static_cast<std::uint32_t>(h.idx());
    for (const auto e : mesh_.all_edges()) mesh_.property(edge_index, e) = static_cast<std::uint32_t>(e.idx());
    for (const auto f : mesh_.all_faces()) mesh_.property(face_index, f) = static_cast<std::uint32_t>(f.idx());

    mesh_.garbage_collection();
    vertices_->compact(read_numbering(
        mesh_.n_vertices(), [&](int i) { return mesh_.property(vertex_index, OpenMesh::VertexHandle(i)); }));
    halfedges_->compact(read_numbering(
        mesh_.n_halfedges(), [&](int i) { return mesh_.property(halfedge_index, OpenMesh::HalfedgeHandle(i)); }));
    edges_->compact(read_numbering(mesh_.n_edges(),
                                   [&](int i) { return mesh_.property(edge_index, OpenMesh::EdgeHandle(i)); }));
    faces_->compact(read_numbering(mesh_.n_faces(),
                                   [&](int i) { return mesh_.property(face_index, OpenMesh::FaceHandle(i)); }));
    mesh_.remove_property(vertex_index);
    mesh_.remove_property(halfedge_index);
    mesh_.remove_property(edge_index);
    mesh_.remove_property(face_index);
    deleted_vertices_ = deleted_faces_ = 0;
}

VertexId Complex::new_vertex(const Point2& position) {
    const auto v = mesh_.new_vertex();
    mesh_.set_point(v, position);
    return from_kernel(v);
}

void Complex::resize_attributes() {
    vertices_->resize(mesh_.n_vertices());
    halfedges_->resize(mesh_.n_halfedges());
    edges_->resize(mesh_.n_edges());
    faces_->resize(mesh_.n_faces());
}

void Complex::set_offset(HalfedgeId h, const LatticeVector& cell) {
    offset_[h] = cell;
    offset_[opposite(h)] = -cell;
}

void Complex::set_interface(EdgeId e, bool flag) {
    if (is_interface(e) == flag) return;
    is_interface_[e] = flag ? 1 : 0;
    const HalfedgeId h = halfedge(e);
    const int change = flag ? 1 : -1;
    for (const VertexId v : {from(h), to(h)})
        interface_degree_[v] = static_cast<std::uint16_t>(interface_degree_[v] + change);
}

void Complex::refresh_interface(EdgeId e) {
    const FaceId left = face(halfedge(e)), right = face(opposite(halfedge(e)));
    set_interface(e, left.is_valid() && right.is_valid() && label_[left] != label_[right]);
}

}  // namespace dsc::dsc2d
