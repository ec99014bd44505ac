// SPDX-License-Identifier: GPL-3.0-or-later
// Edge removal: the tetrahedra around an edge ab give way to two tetrahedra, one at a and one at b, per triangle of the
// best triangulation of the edge's link. Generalizes the 3-2, 4-4 and 2-2 flips. On the boundary and on interfaces it
// works where the two surface faces at the edge belong to one flat patch: they are exchanged for the other two.
// Source: thesis 3.2.2, 3.3; Shewchuk, "Two discrete optimization algorithms for the topological improvement of
// tetrahedral meshes"; Klincsek's dynamic program. Cost: n^3 / 3 ratings for a ring of n, fewer with a threshold.
#pragma once

#include <optional>

#include "dsc3d/operations/rated_mesh.h"

namespace dsc::dsc3d {

class EdgeRemoval {
public:
    /// Longer rings are left alone: an edge of so many tetrahedra never makes a good set of new ones.
    static constexpr int max_ring = 24;

    /// Fills `proposal` with the best way to remove e whose worst tetrahedron is better than `wanted`, if there is one;
    /// by default better than the worst of those that go.
    bool propose(RatedMesh& mesh, EdgeId e, Proposal& proposal, std::optional<double> wanted = {});

    /// The same for an interface edge between two triangles, whether or not they are in one plane: the surface moves
    /// over the tetrahedron of the two. Precondition: interfaces have no patches.
    bool propose_flip(RatedMesh& mesh, EdgeId e, Proposal& proposal, double wanted);

private:
    bool add_surface_arcs(RatedMesh& mesh, double threshold, Proposal& proposal);
    bool add_arc(const RatedMesh& mesh, std::size_t begin, std::size_t vertices, double threshold, Proposal& proposal);

    EdgeRing ring_;
    VertexId c_, d_;  ///< what the new surface edge joins
};

}  // namespace dsc::dsc3d
