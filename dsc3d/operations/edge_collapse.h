// SPDX-License-Identifier: GPL-3.0-or-later
// Edge collapse b -> a: the tetrahedra at the edge vanish, all others at b get a instead of b, and b is gone.
//
// It keeps topology when Lk(e) = Lk(a) ∩ Lk(b) in the complex coned off at its surface by a point of its own, in the
// surface coned off at its seams, where more than two sheets meet, and when it does not join two ends of seams (Dey,
// Edelsbrunner, Guha, Nekhayev, "Topology preserving edge contraction").
// A vertex of the surface may go when the surface is flat there and the edge runs along it: within a patch, or along a
// straight ridge. Source: thesis 3.3.2. Cost: linear in the stars of a and b.
#pragma once

#include <span>
#include <vector>

#include "dsc3d/operations/rated_mesh.h"
#include "dsc3d/operations/surface_link.h"

namespace dsc::dsc3d {

class EdgeCollapse {
public:
    /// Whether the collapse of e towards `kept` leaves a simplicial complex of the same topology, and so regions and
    /// interfaces. Knows no geometry.
    bool keeps_topology(const Complex& complex, EdgeId e, VertexId kept, StarWalker& walker);

    /// Whether the surface allows that the other end of e goes: it lies inside, or the surface is flat along e.
    bool keeps_surface(const RatedMesh& mesh, EdgeId e, VertexId kept);

    /// Fills `proposal` when the collapse keeps topology and surface and its worst tetrahedron is better than
    /// min(worst before, `enough`).
    bool propose(RatedMesh& mesh, EdgeId e, VertexId kept, double enough, Proposal& proposal);

    /// Collapses e to a vertex at `place`, whether or not the surface stays; `kept` is its handle. False, and nothing
    /// is changed, when that would change the topology, or make a tetrahedron worse than min(worst before, `enough`).
    /// Precondition: on the boundary, both ends lie on the patch of the faces at the other end, and so does the place.
    bool collapse_at(RatedMesh& mesh, EdgeId e, VertexId kept, const Point3& place, double enough);

private:
    bool take_patches(const RatedMesh& mesh, VertexId kept, VertexId gone);
    bool keeps_topology_of_surface(const Complex& complex, EdgeId e, VertexId kept, VertexId gone,
                                   std::span<const TetId> star_of_kept);

    std::vector<VertexId> around_kept_;
    std::vector<VertexId> around_gone_;
    std::vector<VertexId> common_;
    std::vector<VertexId> link_;
    std::vector<EdgeVertices> common_edges_;
    std::vector<TetId> star_of_gone_;
    SurfaceLink surface_of_kept_;
    SurfaceLink surface_of_gone_;
    EdgeRing ring_;
    Proposal proposal_;
};

}  // namespace dsc::dsc3d
