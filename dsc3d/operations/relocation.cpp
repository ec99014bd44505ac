// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/relocation.h"

#include <algorithm>

namespace dsc::dsc3d {

bool Relocation::propose(RatedMesh& mesh, VertexId v, EdgeId e, Proposal& proposal) {
    const Complex& complex = mesh.complex();
    if (mesh.surface().motion(v) != VertexMotion::free || complex.is_surface(e)) return false;
    gather_ring(complex, e, ring_);
    for (const TetId t : ring_.tets)
        if (complex.has_vertex(t, v)) return false;
    if (!close_star(mesh, v, proposal)) return false;

    proposal.gone = VertexId();
    proposal.moved = v;
    proposal.place = 0.5 * (mesh.position(ring_.a) + mesh.position(ring_.b));
    const auto rate = [&](const TetVertices& corners) {
        const auto at = [&](std::size_t i) { return corners[i] == v ? proposal.place : mesh.position(corners[i]); };
        return geometry::quality(mesh.measure(), at(0), at(1), at(2), at(3), mesh.bias());
    };
    for (const TetId t : ring_.tets) {
        proposal.removed.push_back(t);
        proposal.quality_before = std::min(proposal.quality_before, mesh.quality(t));
        for (const VertexId end : {ring_.a, ring_.b}) {
            NewTet part = {complex.vertices(t), complex.label(t)};
            part.vertices[static_cast<std::size_t>(complex.index_of(t, end))] = v;
            proposal.quality_after = std::min(proposal.quality_after, rate(part.vertices));
            proposal.added.push_back(part);
        }
    }
    return true;
}

// The collapse of v that leaves the best worst tetrahedron.
bool Relocation::close_star(RatedMesh& mesh, VertexId v, Proposal& proposal) {
    const Complex& complex = mesh.complex();
    edges_.clear();
    for (const TetId t : mesh.walker().star(v))
        for (const EdgeId e : complex.edges(t))
            if (complex.vertices(e)[0] == v || complex.vertices(e)[1] == v) edges_.push_back(e);
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    bool is_possible = false;
    for (const EdgeId e : edges_) {
        const EdgeVertices& ends = complex.vertices(e);
        if (!collapse_.propose(mesh, e, ends[0] == v ? ends[1] : ends[0], 0.0, closing_)) continue;
        if (is_possible && closing_.quality_after <= proposal.quality_after) continue;
        std::swap(proposal, closing_);
        is_possible = true;
    }
    return is_possible;
}

}  // namespace dsc::dsc3d
