// SPDX-License-Identifier: GPL-3.0-or-later
// Improvement of the interface as a surface: short edges are collapsed, long ones split, edges between ill-shaped
// triangles flipped, vertices smoothed within the surface. Source: thesis 4.3.2.2; the decisions are those of surface/.
// Guarantee: topology stays; so do features, but for edges and triangles too small to mean anything, which go whatever
// that does to the shape (4.3.2.1, degeneracy removal), and ends of threads, which are taken back; but for splits, no
// tetrahedron becomes worse than `interface_quality`, or than it is. Vertices on the boundary of the domain stay, and
// edges whose relative length has not changed since they were looked at last, so that what moves rigidly keeps its
// triangles. Cost: linear in the region.
#pragma once

#include "dsc3d/deform/interface_ring.h"
#include "dsc3d/deform/pass_context.h"
#include "dsc3d/deform/thread_end.h"
#include "dsc3d/operations/edge_collapse.h"
#include "dsc3d/operations/edge_removal.h"

namespace dsc::dsc3d {

class InterfaceControl {
public:
    explicit InterfaceControl(const Mesh& mesh);

    /// Leaves the interface as it is now, edge by edge, until an edge gets another length, or another one is wanted.
    void accept(const PassContext& context);
    /// Takes that back.
    void reconsider();

    /// Edges of the interface in the region that have got another length.
    std::vector<EdgeId> changed_edges(PassContext& context) const;
    /// Afterwards the region is what has been changed.
    void run(PassContext& context);

private:
    bool has_changed(const PassContext& context, EdgeId e) const;

    // All of them may find candidates deleted, or in use for another edge since.
    void collapse_short_edges(PassContext& context, std::span<const EdgeId> candidates);
    bool collapse(PassContext& context, EdgeId e);
    bool collapse_to(PassContext& context, EdgeId e, const Point3& place);
    void remove_degenerate_edges(PassContext& context, std::span<const EdgeId> candidates);
    void retract_threads(PassContext& context, std::span<const VertexId> candidates);
    VertexId collapse_thread_end(PassContext& context, VertexId end);
    void pull_thread_end(PassContext& context, VertexId end);
    void remove_caps(PassContext& context, std::span<const EdgeId> candidates);
    bool flip(PassContext& context, EdgeId e, double quality);
    void split_long_edges(PassContext& context, std::span<const EdgeId> candidates);
    void flip_edges(PassContext& context, std::span<const EdgeId> candidates);
    void smooth_vertices(PassContext& context, std::span<const VertexId> candidates);

    EdgeCollapse collapse_;
    EdgeRemoval edge_removal_;
    Proposal proposal_;
    EdgeRing edge_ring_;
    ThreadEnd thread_end_;
    core::Attribute<EdgeId, double> seen_length_;  ///< relative length when it was looked at last; 0: not yet
    InterfaceRing ring_;
    InterfaceRing other_ring_;
};

}  // namespace dsc::dsc3d
