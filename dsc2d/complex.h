// SPDX-License-Identifier: GPL-3.0-or-later
// The 2D deformable simplicial complex: a triangulation of a Domain with an integer label per face; the interface is
// the set of edges between different labels.
//
// Positions are coordinates of the universal cover and are never wrapped. Every half-edge carries an integer lattice
// vector, opposite on the two sides and summing to zero round each face, so that edges and faces may cross the seam
// anywhere: vector(h) = position(to) + translation(offset(h)) - position(from). Two vertices may be joined by several
// edges with different vectors (the complex is simplicial in the cover); an edge never joins a vertex to itself.
//
// Source: thesis 4.3, 5.2.1. Guarantee: labels, interface flags and attributes follow every operation of
// dsc2d/operations; handles stay valid until compact(). Cost: queries are a few array reads.
//
//     Complex complex = structured_complex(Domain::box({0, 0}, {1, 1}), 10, 10);
//     insert_polygon(complex, circle, /*label=*/1);
//     for (core::HalfedgeId h : complex.outgoing(v)) use(complex.vector(h));
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/attribute.h"
#include "core/handles.h"
#include "dsc2d/domain.h"
#include "dsc2d/mesh_kernel.h"

namespace dsc::dsc2d {

using core::EdgeId;
using core::FaceId;
using core::HalfedgeId;
using core::VertexId;

/// A triangle of the input: vertex indices in counterclockwise order and the lattice cell of each corner.
struct TriangleInput {
    std::array<std::uint32_t, 3> vertices;
    std::array<LatticeVector, 3> cells;
    int label = 0;
};

struct ComplexArrays;

class Complex {
public:
    /// Points are rounded to the grid of the domain. Throws core::InputError that names the triangle or vertex, from 0
    /// on, when the triangles don't form an oriented manifold without repeated edges, or one is not strictly
    /// counterclockwise.
    Complex(const Domain& domain, std::span<const Point2> points, std::span<const TriangleInput> triangles);
    /// The complex that has these arrays. Throws core::InputError that names an array when a number in it is out of its
    /// range; that they belong together is a precondition.
    Complex(const Domain& domain, const ComplexArrays& arrays);
    Complex(Complex&&) = default;
    Complex& operator=(Complex&&) = default;

    const Domain& domain() const { return domain_; }

    /// Sizes of the arrays; they count deleted elements until compact().
    std::uint32_t vertex_capacity() const { return static_cast<std::uint32_t>(mesh_.n_vertices()); }
    std::uint32_t edge_capacity() const { return static_cast<std::uint32_t>(mesh_.n_edges()); }
    std::uint32_t face_capacity() const { return static_cast<std::uint32_t>(mesh_.n_faces()); }
    bool is_deleted(VertexId v) const { return mesh_.status(to_kernel(v)).deleted(); }
    bool is_deleted(EdgeId e) const { return mesh_.status(to_kernel(e)).deleted(); }
    bool is_deleted(FaceId f) const { return mesh_.status(to_kernel(f)).deleted(); }
    std::uint32_t vertex_count() const { return vertex_capacity() - deleted_vertices_; }
    std::uint32_t face_count() const { return face_capacity() - deleted_faces_; }

    // Incidence
    HalfedgeId halfedge(VertexId v) const { return from_kernel(mesh_.halfedge_handle(to_kernel(v))); }
    HalfedgeId halfedge(FaceId f) const { return from_kernel(mesh_.halfedge_handle(to_kernel(f))); }
    static HalfedgeId halfedge(EdgeId e) { return HalfedgeId(e.index() << 1); }
    static HalfedgeId opposite(HalfedgeId h) { return HalfedgeId(h.index() ^ 1u); }
    static EdgeId edge(HalfedgeId h) { return EdgeId(h.index() >> 1); }
    HalfedgeId next(HalfedgeId h) const { return from_kernel(mesh_.next_halfedge_handle(to_kernel(h))); }
    HalfedgeId prev(HalfedgeId h) const { return from_kernel(mesh_.prev_halfedge_handle(to_kernel(h))); }
    VertexId to(HalfedgeId h) const { return from_kernel(mesh_.to_vertex_handle(to_kernel(h))); }
    VertexId from(HalfedgeId h) const { return to(opposite(h)); }
    /// Invalid for a boundary half-edge.
    FaceId face(HalfedgeId h) const { return from_kernel(mesh_.face_handle(to_kernel(h))); }
    /// The next outgoing half-edge of from(h), counterclockwise.
    HalfedgeId rotated(HalfedgeId h) const { return opposite(prev(h)); }
    bool is_boundary(HalfedgeId h) const { return !face(h).is_valid(); }
    bool is_boundary(EdgeId e) const { return is_boundary(halfedge(e)) || is_boundary(opposite(halfedge(e))); }
    bool is_boundary(VertexId v) const { return is_boundary(halfedge(v)); }

    class OutgoingRange;
    /// The outgoing half-edges of v, counterclockwise; the complex must not be changed while walking.
    OutgoingRange outgoing(VertexId v) const;

    // Geometry
    const Point2& position(VertexId v) const { return mesh_.point(to_kernel(v)); }
    const LatticeVector& offset(HalfedgeId h) const { return offset_[h]; }
    /// From from(h) to to(h), exact [length].
    Point2 vector(HalfedgeId h) const {
        const LatticeVector& cell = offset_[h];
        const Point2 difference = position(to(h)) - position(from(h));
        return cell.x() == 0 && cell.y() == 0 ? difference : Point2(difference + domain_.translation(cell));
    }
    double length(HalfedgeId h) const { return vector(h).norm(); }
    /// The corners of a face in the cover, starting at from(halfedge(f)), in the period of that vertex.
    std::array<Point2, 3> corners(FaceId f) const;
    double area(FaceId f) const;

    // Labels and interface
    int label(FaceId f) const { return label_[f]; }
    void set_label(FaceId f, int label);
    bool is_interface(EdgeId e) const { return is_interface_[e] != 0; }
    bool is_interface(HalfedgeId h) const { return is_interface(edge(h)); }
    bool is_interface(VertexId v) const { return interface_degree_[v] != 0; }
    /// Number of interface edges at v: 0 inside a region, 2 on a curve, more at a junction.
    int interface_degree(VertexId v) const { return interface_degree_[v]; }

    /// A locked vertex is never moved nor removed by any pass.
    bool is_locked(VertexId v) const { return is_locked_[v] != 0; }
    void lock(VertexId v) { is_locked_[v] = 1; }
    void unlock(VertexId v) { is_locked_[v] = 0; }

    // Storage
    const std::shared_ptr<core::AttributeRegistry<VertexId>>& vertex_attributes() const { return vertices_; }
    const std::shared_ptr<core::AttributeRegistry<HalfedgeId>>& halfedge_attributes() const { return halfedges_; }
    const std::shared_ptr<core::AttributeRegistry<EdgeId>>& edge_attributes() const { return edges_; }
    const std::shared_ptr<core::AttributeRegistry<FaceId>>& face_attributes() const { return faces_; }
    /// Share of deleted vertices in the arrays, in [0, 1).
    double garbage_fraction() const;
    /// Removes deleted elements; all handles change, attributes follow. Linear.
    void compact();
    ComplexArrays arrays() const;

    // Unchecked building blocks; use dsc2d/operations, which judge a change before they call these.

    /// Precondition: every face at v stays counterclockwise; `position` lies on the grid and in reach.
    void set_position_unchecked(VertexId v, const Point2& position) { mesh_.set_point(to_kernel(v), position); }
    /// Moves the cover coordinates of v by a lattice vector; geometry and incidence stay as they are.
    void reanchor(VertexId v, const LatticeVector& cell);
    void flip_unchecked(HalfedgeId h, int label_of_both);
    /// New vertex m on edge(h), in the period of from(h); returns m.
    VertexId split_edge_unchecked(HalfedgeId h, const Point2& position);
    /// New vertex m in face(h), in the period of from(h); returns m.
    VertexId split_face_unchecked(HalfedgeId h, const Point2& position);
    /// from(h) goes, to(h) stays.
    void collapse_unchecked(HalfedgeId h);

private:
    explicit Complex(const Domain& domain);
    VertexId new_vertex(const Point2& position);
    void resize_attributes();
    void set_offset(HalfedgeId h, const LatticeVector& cell);
    void set_interface(EdgeId e, bool flag);
    void refresh_interface(EdgeId e);

    Domain domain_;
    MeshKernel mesh_;
    std::shared_ptr<core::AttributeRegistry<VertexId>> vertices_;
    std::shared_ptr<core::AttributeRegistry<HalfedgeId>> halfedges_;
    std::shared_ptr<core::AttributeRegistry<EdgeId>> edges_;
    std::shared_ptr<core::AttributeRegistry<FaceId>> faces_;
    core::Attribute<HalfedgeId, LatticeVector> offset_;
    core::Attribute<FaceId, int> label_;
    core::Attribute<EdgeId, std::uint8_t> is_interface_;
    core::Attribute<VertexId, std::uint16_t> interface_degree_;
    core::Attribute<VertexId, std::uint8_t> is_locked_;
    std::uint32_t deleted_vertices_ = 0;
    std::uint32_t deleted_faces_ = 0;
};

class Complex::OutgoingRange {
public:
    class Iterator {
    public:
        Iterator(const Complex* complex, HalfedgeId h) : complex_(complex), first_(h), current_(h) {}
        HalfedgeId operator*() const { return current_; }
        Iterator& operator++() {
            current_ = complex_->rotated(current_);
            is_started_ = true;
            return *this;
        }
        bool operator!=(const Iterator&) const { return !is_started_ || current_ != first_; }

    private:
        const Complex* complex_;
        HalfedgeId first_;
        HalfedgeId current_;
        bool is_started_ = false;
    };
    OutgoingRange(const Complex* complex, HalfedgeId first) : complex_(complex), first_(first) {}
    Iterator begin() const { return {complex_, first_}; }
    Iterator end() const { return {complex_, first_}; }

private:
    const Complex* complex_;
    HalfedgeId first_;
};

inline Complex::OutgoingRange Complex::outgoing(VertexId v) const { return {this, halfedge(v)}; }

}  // namespace dsc::dsc2d
