// SPDX-License-Identifier: GPL-3.0-or-later
// The active set of a step: the tetrahedra whose shape, connectivity or label has changed since they were looked at
// last. Every pass visits them only, so that a step costs what moves, not what is there. Source: thesis 4.3.1.
// Guarantee: the order is that in which they were added. Cost: linear in what is asked for.
#pragma once

#include <span>
#include <vector>

#include "core/marks.h"
#include "dsc3d/operations/rated_mesh.h"

namespace dsc::dsc3d {

class Region {
public:
    void clear() { tets_.clear(); }
    void assign(std::span<const TetId> tets) { tets_.assign(tets.begin(), tets.end()); }
    void add(std::span<const TetId> tets) { tets_.insert(tets_.end(), tets.begin(), tets.end()); }
    void add_star(RatedMesh& mesh, VertexId v);
    /// Each tetrahedron once, without those that are deleted.
    void settle(const Complex& complex);

    /// Valid until the region changes; some may be deleted until settle().
    std::span<const TetId> tets() const { return tets_; }
    /// Precondition of the next four: no tetrahedron of the region is deleted. Each once.
    std::vector<VertexId> vertices(const Complex& complex);
    std::vector<VertexId> interface_vertices(const Complex& complex);
    std::vector<EdgeId> edges_off_interface(const Complex& complex);
    std::vector<EdgeId> interface_edges(const Complex& complex);

private:
    std::vector<TetId> tets_;
    core::Marks<TetId> seen_tets_;
    core::Marks<VertexId> seen_vertices_;
    core::Marks<EdgeId> seen_edges_;
};

}  // namespace dsc::dsc3d
