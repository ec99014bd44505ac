// SPDX-License-Identifier: GPL-3.0-or-later
// Edge collapse b -> a: the tetrahedra at the edge vanish, all others at b get a instead of b, and b is gone.
//
// It keeps a simplicial complex when Lk(e) = Lk(a) ∩ Lk(b), on the surface too: with the boundary coned off by a point
// of its own, and in the surface itself (Dey, Edelsbrunner, Guha, Nekhayev, "Topology preserving edge contraction").
// A vertex of the surface may go when the surface is flat there and the edge runs along it: within a patch, or along a
// straight ridge. Source: thesis 3.3.2. Cost: linear in the stars of a and b.
#pragma once

#include <vector>

#include "dsc3d/operations/rated_mesh.h"

namespace dsc::dsc3d {

class EdgeCollapse {
public:
    /// Whether the collapse of e towards `kept` leaves a simplicial complex of the same topology. Knows no geometry.
    bool keeps_topology(const Complex& complex, EdgeId e, VertexId kept, StarWalker& walker);

    /// Whether the surface allows that the other end of e goes: it lies inside, or the surface is flat along e.
    bool keeps_surface(const RatedMesh& mesh, EdgeId e, VertexId kept);

    /// Fills `proposal` when the collapse keeps topology and surface and its worst tetrahedron is better than
    /// min(worst before, `enough`).
    bool propose(RatedMesh& mesh, EdgeId e, VertexId kept, double enough, Proposal& proposal);

private:
    std::vector<VertexId> around_kept_;
    std::vector<VertexId> around_gone_;
    std::vector<VertexId> common_;
    std::vector<VertexId> link_;
    std::vector<TetId> star_of_gone_;
    EdgeRing ring_;
};

}  // namespace dsc::dsc3d
