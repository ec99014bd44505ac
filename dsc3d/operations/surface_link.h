// SPDX-License-Identifier: GPL-3.0-or-later
// How the surface (boundary and interfaces) looks around one of its vertices: the link of the vertex in it, a graph.
// Where three or more sheets meet in an edge, that edge is a seam; a vertex inside a sheet has a circle for its link,
// one inside a seam has arcs between the two ends of the seam, every other one is a corner (a point where seams meet or
// end, or where sheets touch). Source: the order of a simplex in Dey, Edelsbrunner, Guha, Nekhayev, "Topology
// preserving edge contraction". Cost: k log k in the number of surface faces at the vertex; buffers are reused.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dsc3d/complex/complex.h"

namespace dsc::dsc3d {

enum class SurfacePlace : std::uint8_t { sheet, seam, corner };

class SurfaceLink {
public:
    /// `star`: the tetrahedra at v, which is a vertex of the surface.
    void gather(const Complex& complex, std::span<const TetId> star, VertexId v);

    /// Vertices joined to v by a surface edge, ascending.
    std::span<const VertexId> vertices() const { return vertices_; }
    /// The edges of the link: with v, the surface faces; each with its lesser vertex first, ascending.
    std::span<const EdgeVertices> edges() const { return edges_; }
    /// Vertices joined to v by a seam, ascending.
    std::span<const VertexId> seams() const { return seams_; }
    SurfacePlace place() const;

private:
    std::span<const EdgeVertices> arcs_at(VertexId x) const;
    std::size_t walk(VertexId from, EdgeVertices along, VertexId& end) const;

    std::vector<EdgeVertices> edges_;
    std::vector<EdgeVertices> arcs_;  ///< both directions of the edges, ascending
    std::vector<VertexId> vertices_;
    std::vector<VertexId> seams_;
};

}  // namespace dsc::dsc3d
