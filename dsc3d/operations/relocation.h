// SPDX-License-Identifier: GPL-3.0-or-later
// Relocation: a vertex inside a region leaves its star by the best edge collapse and comes back in the middle of an
// edge elsewhere, whose tetrahedra it divides. It brings a vertex to where a mesh has none that could help, and no
// number of moves and retriangulations leads there; the number of vertices stays.
// Source: thesis 3.2.3 (vertex insertion) and 3.3.2 (edge collapse), as one operation. Guarantee: keeps topology and
// surface. Cost: that of judging a collapse for each edge at the vertex, and the ring of the edge.
#pragma once

#include <vector>

#include "dsc3d/operations/edge_collapse.h"
#include "dsc3d/operations/rated_mesh.h"

namespace dsc::dsc3d {

class Relocation {
public:
    /// Fills `proposal` when v is free and can go without turning a tetrahedron over, and e is an edge inside a region
    /// and none of its tetrahedra is one of v.
    bool propose(RatedMesh& mesh, VertexId v, EdgeId e, Proposal& proposal);

private:
    bool close_star(RatedMesh& mesh, VertexId v, Proposal& proposal);

    EdgeCollapse collapse_;
    EdgeRing ring_;
    std::vector<EdgeId> edges_;
    Proposal closing_;
};

}  // namespace dsc::dsc3d
