// SPDX-License-Identifier: GPL-3.0-or-later
// The manifold incidence simplicial complex: vertices, edges, faces and tetrahedra with the boundary relation and one
// element of the coboundary of each, without coordinates.
//
//     tetrahedron -> 4 faces and 4 vertices (face i is opposite vertex i), label
//     face        -> 3 edges (edge i is opposite vertex i), 1 or 2 tetrahedra
//     edge        -> 2 vertices, 1 face
//     vertex      -> 1 edge
//
// A simplex is oriented by the order of its vertices; face i of a tetrahedron [v0 v1 v2 v3] carries the induced
// orientation (-1)^i [v0 .. without vi ..]. Every change is one `replace`: some tetrahedra give way to others. Edges
// and faces follow by themselves: those still in use keep their handles and attributes. A boundary face has one
// tetrahedron; an interface face separates two labels; an edge or vertex is so when one of its faces is.
//
// Source: thesis 2.1.3, 2.2.2, with the fixed-size relations it asks for in 2.2.3. Guarantee: after every change all
// relations, flags and attributes are consistent; handles of simplices that were not removed stay valid until
// compact(). Cost: queries are array reads; replace is linear in the cavity and allocates nothing in the long run;
// about 110 bytes per tetrahedron in all.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/assert.h"
#include "core/attribute.h"
#include "core/handles.h"
#include "dsc3d/complex/local_table.h"

namespace dsc::dsc3d {

using core::EdgeId;
using core::FaceId;
using core::TetId;
using core::VertexId;

using TetVertices = std::array<VertexId, 4>;
using FaceVertices = std::array<VertexId, 3>;
using EdgeVertices = std::array<VertexId, 2>;

/// A tetrahedron to be made: its oriented vertices and its label.
struct NewTet {
    TetVertices vertices;
    int label = 0;
};

class Complex {
public:
    Complex();
    Complex(Complex&&) = default;
    Complex& operator=(Complex&&) = default;

    /// Precondition: vertices 0 .. vertex_count - 1 all occur, in no tetrahedron twice. Throws core::InputError, naming
    /// `source` and the tetrahedron, unless every face is shared by at most two tetrahedra on either side of it, and
    /// the links of edges and vertices are circles, paths, spheres and discs.
    Complex(std::uint32_t vertex_count, std::span<const NewTet> tets, const std::string& source = "mesh");

    /// Sizes of the arrays; they count deleted simplices until compact().
    std::uint32_t vertex_capacity() const { return size32(vertex_edge_); }
    std::uint32_t edge_capacity() const { return size32(edge_vertices_); }
    std::uint32_t face_capacity() const { return size32(face_edges_); }
    std::uint32_t tet_capacity() const { return size32(tet_vertices_); }
    std::uint32_t vertex_count() const { return vertex_capacity() - size32(free_vertices_); }
    std::uint32_t edge_count() const { return edge_capacity() - size32(free_edges_); }
    std::uint32_t face_count() const { return face_capacity() - size32(free_faces_); }
    std::uint32_t tet_count() const { return tet_capacity() - size32(free_tets_); }
    /// True also for a vertex that no tetrahedron uses yet.
    bool is_deleted(VertexId v) const { return !vertex_edge_[v.index()].is_valid(); }
    bool is_deleted(EdgeId e) const { return !edge_face_[e.index()].is_valid(); }
    bool is_deleted(FaceId f) const { return !face_tets_[f.index()][0].is_valid(); }
    bool is_deleted(TetId t) const { return !tet_faces_[t.index()][0].is_valid(); }

    // Boundary relation
    const TetVertices& vertices(TetId t) const { return tet_vertices_[t.index()]; }
    const std::array<FaceId, 4>& faces(TetId t) const { return tet_faces_[t.index()]; }
    const std::array<EdgeId, 3>& edges(FaceId f) const { return face_edges_[f.index()]; }
    const EdgeVertices& vertices(EdgeId e) const { return edge_vertices_[e.index()]; }
    FaceVertices vertices(FaceId f) const;
    /// The edges of t in the order 01, 02, 03, 12, 13, 23 of its vertices.
    std::array<EdgeId, 6> edges(TetId t) const;

    // Partial coboundary relation
    /// The second one is invalid on the boundary.
    const std::array<TetId, 2>& tets(FaceId f) const { return face_tets_[f.index()]; }
    FaceId face(EdgeId e) const { return edge_face_[e.index()]; }
    EdgeId edge(VertexId v) const { return vertex_edge_[v.index()]; }
    TetId tet(EdgeId e) const { return tets(face(e))[0]; }
    TetId tet(VertexId v) const { return tet(edge(v)); }

    /// The tetrahedron on the other side of f, invalid on the boundary.
    TetId across(FaceId f, TetId t) const {
        const std::array<TetId, 2>& sides = tets(f);
        DSC_ASSERT(sides[0] == t || sides[1] == t);
        return sides[0] == t ? sides[1] : sides[0];
    }
    /// The tetrahedron that shares the face opposite vertex i of t, invalid on the boundary.
    TetId neighbour(TetId t, int i) const { return across(faces(t)[static_cast<std::size_t>(i)], t); }
    /// The place of v in t; precondition: v is a vertex of t.
    int index_of(TetId t, VertexId v) const {
        const TetVertices& corners = vertices(t);
        int i = 0;
        while (corners[static_cast<std::size_t>(i)] != v) {
            ++i;
            DSC_ASSERT(i < 4);
        }
        return i;
    }
    bool has_vertex(TetId t, VertexId v) const {
        const TetVertices& corners = vertices(t);
        return corners[0] == v || corners[1] == v || corners[2] == v || corners[3] == v;
    }
    /// The place of f in t; precondition: f is a face of t.
    int index_of(TetId t, FaceId f) const {
        const std::array<FaceId, 4>& sides = faces(t);
        int i = 0;
        while (sides[static_cast<std::size_t>(i)] != f) {
            ++i;
            DSC_ASSERT(i < 4);
        }
        return i;
    }
    /// Face i of t in its induced orientation: seen from outside, counterclockwise when t is positive.
    FaceVertices oriented_face(TetId t, int i) const;

    // Labels and flags
    int label(TetId t) const { return tet_label_[t.index()]; }
    void set_label(TetId t, int label);
    bool is_boundary(FaceId f) const { return !tets(f)[1].is_valid(); }
    bool is_interface(FaceId f) const {
        const std::array<TetId, 2>& sides = tets(f);
        return sides[1].is_valid() && label(sides[0]) != label(sides[1]);
    }
    bool is_boundary(EdgeId e) const { return edge_faces_[e.index()].boundary != 0; }
    bool is_interface(EdgeId e) const { return edge_faces_[e.index()].interface != 0; }
    bool is_boundary(VertexId v) const { return vertex_faces_[v.index()].boundary != 0; }
    bool is_interface(VertexId v) const { return vertex_faces_[v.index()].interface != 0; }
    /// On the boundary of a region: of the whole complex or of a label.
    bool is_surface(FaceId f) const { return is_boundary(f) || is_interface(f); }
    bool is_surface(EdgeId e) const { return is_boundary(e) || is_interface(e); }
    bool is_surface(VertexId v) const { return is_boundary(v) || is_interface(v); }
    /// Number of boundary and interface faces at e.
    std::uint32_t surface_degree(EdgeId e) const {
        return edge_faces_[e.index()].boundary + edge_faces_[e.index()].interface;
    }

    // Change
    /// A new vertex, to be used by the next replace; its handle may be one that was freed before.
    VertexId add_vertex();

    /// What the last replace did. Handles of removed simplices are not reused by the same replace.
    struct Change {
        std::vector<TetId> added_tets;  ///< in the order given
        std::vector<TetId> removed_tets;
        std::vector<FaceId> added_faces;
        std::vector<EdgeId> added_edges;
        std::vector<VertexId> removed_vertices;
    };

    /// Removes tetrahedra and makes others in one step. Preconditions: the result is a manifold complex again; vertices
    /// that no longer have a tetrahedron are removed. The change is valid until the next one.
    const Change& replace(std::span<const TetId> removed, std::span<const NewTet> added);

    /// Renumbers all simplices without gaps, in their present order; all handles change, attributes follow. Linear.
    void compact();
    /// Renumbers all simplices without gaps, in a new order of the vertices, of which `vertices` has each one in use;
    /// the others come by the least of their vertices, so that what is near in that order is near in memory.
    void renumber(std::span<const VertexId> vertices);
    /// The same with an order of the tetrahedra too.
    void renumber(std::span<const VertexId> vertices, std::span<const TetId> tets);

    // Attributes
    const std::shared_ptr<core::AttributeRegistry<VertexId>>& vertex_attributes() const { return vertex_attributes_; }
    const std::shared_ptr<core::AttributeRegistry<EdgeId>>& edge_attributes() const { return edge_attributes_; }
    const std::shared_ptr<core::AttributeRegistry<FaceId>>& face_attributes() const { return face_attributes_; }
    const std::shared_ptr<core::AttributeRegistry<TetId>>& tet_attributes() const { return tet_attributes_; }

    /// Bytes of the arrays of the complex, without attributes.
    std::size_t memory() const;

private:
    enum class FaceKind : std::uint8_t { none, interior, boundary, interface };
    /// Number of surface faces at an edge or vertex.
    template <class Count>
    struct SurfaceFaces {
        Count boundary = 0;
        Count interface = 0;
    };
    struct CavityFace {
        FaceId face;
        FaceKind kind_before = FaceKind::none;
    };
    struct CavityEdge {
        EdgeId edge;
        bool is_used = false;
    };

    template <class Vector>
    static std::uint32_t size32(const Vector& values) {
        return static_cast<std::uint32_t>(values.size());
    }

    /// Arrays keep room for an eighth more: doubling would cost more memory than improvement and deformation ever use.
    static std::size_t with_room(std::size_t count) { return count + count / 8 + 16; }
    template <class Vector>
    static void grow(Vector& values) {
        if (values.size() == values.capacity()) values.reserve(with_room(values.size()));
        values.emplace_back();
    }

    struct Order;
    void reorder_vertices(const Order& order);
    void reorder_edges(const Order& order);
    void reorder_faces(const Order& order);
    void reorder_tets(const Order& order);

    void build_tets(std::span<const NewTet> tets);
    void build_faces(std::uint32_t vertex_count, const std::string& source);
    void build_edges(std::uint32_t vertex_count);
    void require_manifold(const std::string& source) const;

    FaceKind kind(FaceId f) const;
    void count_face(const FaceVertices& corners, const std::array<EdgeId, 3>& edges, FaceKind kind, int change);
    void count_surface_faces();
    void gather_cavity(std::span<const TetId> removed);
    void detach(std::span<const TetId> removed);
    void attach(std::span<const NewTet> added);
    void settle_faces();
    void settle_edges_and_vertices();
    FaceId cavity_face(const FaceVertices& corners);
    EdgeId cavity_edge(VertexId a, VertexId b);
    TetId new_tet();
    FaceId new_face();
    EdgeId new_edge();

    std::vector<TetVertices> tet_vertices_;
    std::vector<std::array<FaceId, 4>> tet_faces_;
    std::vector<int> tet_label_;
    std::vector<std::array<EdgeId, 3>> face_edges_;
    std::vector<std::array<TetId, 2>> face_tets_;
    std::vector<EdgeVertices> edge_vertices_;
    std::vector<FaceId> edge_face_;
    std::vector<SurfaceFaces<std::uint16_t>> edge_faces_;
    std::vector<EdgeId> vertex_edge_;
    std::vector<SurfaceFaces<std::uint32_t>> vertex_faces_;

    std::vector<TetId> free_tets_;
    std::vector<FaceId> free_faces_;
    std::vector<EdgeId> free_edges_;
    std::vector<VertexId> free_vertices_;

    std::shared_ptr<core::AttributeRegistry<VertexId>> vertex_attributes_;
    std::shared_ptr<core::AttributeRegistry<EdgeId>> edge_attributes_;
    std::shared_ptr<core::AttributeRegistry<FaceId>> face_attributes_;
    std::shared_ptr<core::AttributeRegistry<TetId>> tet_attributes_;

    // Scratch of replace, kept so that it allocates only once.
    LocalTable<3, CavityFace> cavity_faces_;
    LocalTable<2, CavityEdge> cavity_edges_;
    std::vector<VertexId> cavity_vertices_;
    Change change_;
};

}  // namespace dsc::dsc3d
