// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/complex.h"

#include <algorithm>
#include <optional>
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

[[noreturn]] void reject_triangle(std::size_t t, const std::string& problem) {
    throw core::InputError("complex", "triangle " + std::to_string(t), problem, "");
}

// A triangle at a vertex: counterclockwise round the vertex it goes from one neighbour to another.
struct Corner {
    std::uint32_t from, to;
    std::size_t triangle;
};

// Whether the corners at one vertex, in the order of `from`, follow each other in one fan or all the way round.
bool is_one_fan(std::span<const Corner> corners) {
    const auto following = [&](const Corner& corner) {
        const auto found = std::ranges::lower_bound(corners, corner.to, {}, &Corner::from);
        return found != corners.end() && found->from == corner.to ? &*found : nullptr;
    };
    std::vector<bool> has_previous(corners.size(), false);
    for (const Corner& corner : corners)
        if (const Corner* next = following(corner))
            has_previous[static_cast<std::size_t>(next - corners.data())] = true;
    const auto begin = std::ranges::find(has_previous, false) - has_previous.begin();
    const Corner* first = &corners[static_cast<std::size_t>(begin) % corners.size()];
    std::size_t count = 1;
    for (const Corner* c = following(*first); c != nullptr && c != first; c = following(*c)) ++count;
    return count == corners.size();
}

// The triangles are an oriented manifold without repeated edges. OpenMesh reports on stderr what it can't take.
void require_manifold(std::size_t vertex_count, std::span<const TriangleInput> triangles) {
    std::vector<std::vector<Corner>> corners(vertex_count);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const auto& v = triangles[t].vertices;
        for (std::size_t i = 0; i < 3; ++i) corners[v[i]].push_back({v[(i + 1) % 3], v[(i + 2) % 3], t});
    }
    // Of the triangles that repeat a side, the first one in their order.
    std::optional<std::pair<std::size_t, std::size_t>> repeated;
    for (std::vector<Corner>& around : corners) {
        std::ranges::stable_sort(around, {}, &Corner::from);
        for (std::size_t i = 0; i + 1 < around.size(); ++i) {
            if (around[i].from != around[i + 1].from) continue;
            const std::pair found(around[i + 1].triangle, around[i].triangle);
            if (!repeated || found < *repeated) repeated = found;
        }
    }
    if (repeated)
        reject_triangle(repeated->first,
                        "lies on the same side of an edge as triangle " + std::to_string(repeated->second));
    for (std::size_t v = 0; v < vertex_count; ++v) {
        if (corners[v].empty())
            throw core::InputError("complex", "vertex " + std::to_string(v), "belongs to no triangle", "");
        if (!is_one_fan(corners[v]))
            throw core::InputError("complex", "vertex " + std::to_string(v),
                                   "joins triangles that have no chain of common edges round it", "");
    }
}

}  // namespace

Complex::Complex(const Domain& domain)
    : domain_(domain),
      vertices_(std::make_shared<core::AttributeRegistry<VertexId>>()),
      halfedges_(std::make_shared<core::AttributeRegistry<HalfedgeId>>()),
      edges_(std::make_shared<core::AttributeRegistry<EdgeId>>()),
      faces_(std::make_shared<core::AttributeRegistry<FaceId>>()),
      offset_(halfedges_, LatticeVector::Zero()),
      label_(faces_, 0),
      is_interface_(edges_, 0),
      interface_degree_(vertices_, 0),
      is_locked_(vertices_, 0) {}

Complex::Complex(const Domain& domain, std::span<const Point2> points, std::span<const TriangleInput> triangles)
    : Complex(domain) {
    for (const Point2& point : points) {
        if (!domain_.is_in_reach(point))
            throw core::InputError("complex", "", "a point lies far outside the domain", "");
        new_vertex(domain_.snapped(point));
    }
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const auto& [a, b, c] = triangles[t].vertices;
        if (std::max({a, b, c}) >= points.size()) reject_triangle(t, "names a vertex that does not exist");
        if (a == b || b == c || c == a) reject_triangle(t, "names a vertex twice");
        std::array<Point2, 3> places;
        for (std::size_t i = 0; i < 3; ++i)
            places[i] = position(VertexId(triangles[t].vertices[i])) + domain_.translation(triangles[t].cells[i]);
        if (!geometry::is_counterclockwise(places[0], places[1], places[2]))
            reject_triangle(t, "is not counterclockwise");
    }
    require_manifold(points.size(), triangles);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const TriangleInput& triangle = triangles[t];
        std::array<OpenMesh::VertexHandle, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) corners[i] = OpenMesh::VertexHandle(static_cast<int>(triangle.vertices[i]));
        const auto face = mesh_.add_face(corners[0], corners[1], corners[2]);
        if (!face.is_valid()) reject_triangle(t, "does not fit into an oriented manifold with its neighbours");
        resize_attributes();
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            set_offset(from_kernel(mesh_.find_halfedge(corners[i], corners[j])), triangle.cells[j] - triangle.cells[i]);
        }
        label_[from_kernel(face)] = triangle.label;
    }
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
    // The split keeps half-edge 0 of the old edge leaving from m, so h is now either m -> b or a -> m. The ring of m
    // is, counterclockwise, b, c (if there is a left face), a, d (if there is a right face).
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
    vertices_->compact(read_numbering(mesh_.n_vertices(),
                                      [&](int i) { return mesh_.property(vertex_index, OpenMesh::VertexHandle(i)); }));
    halfedges_->compact(read_numbering(
        mesh_.n_halfedges(), [&](int i) { return mesh_.property(halfedge_index, OpenMesh::HalfedgeHandle(i)); }));
    edges_->compact(
        read_numbering(mesh_.n_edges(), [&](int i) { return mesh_.property(edge_index, OpenMesh::EdgeHandle(i)); }));
    faces_->compact(
        read_numbering(mesh_.n_faces(), [&](int i) { return mesh_.property(face_index, OpenMesh::FaceHandle(i)); }));
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
