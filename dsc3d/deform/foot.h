// SPDX-License-Identifier: GPL-3.0-or-later
// The last of a region's contact with a wall: a patch of boundary faces not much wider than an edge, whose rim still
// contracts, or that is pulled off the wall. No motion of its vertices makes it vanish: its region has to let go.
// Source: thesis 4.3.2.1 (relabelling), for the wall. Guarantee: none is found where the patch rests, slides or grows.
// Cost: linear in the patch, up to its width.
#pragma once

#include <vector>

#include "core/marks.h"
#include "dsc3d/deform/pass_context.h"

namespace dsc::dsc3d {

class Foot {
public:
    /// Whether the patch of its region's boundary faces that has f is a foot. Then tets() are the region's tetrahedra
    /// at its vertices. Precondition: f is a boundary face with a vertex on the interface.
    bool find(PassContext& context, FaceId f);
    std::span<const TetId> tets() const { return tets_; }

private:
    bool gather_patch(PassContext& context, FaceId f);
    bool is_contracting(const PassContext& context) const;
    bool is_pulled_off(const PassContext& context) const;
    void gather_tets(PassContext& context, int label);

    core::Marks<FaceId> seen_faces_;
    core::Marks<VertexId> seen_vertices_;
    core::Marks<TetId> seen_tets_;
    std::vector<FaceId> patch_;
    std::vector<VertexId> vertices_;
    std::vector<TetId> tets_;
    EdgeRing ring_;
};

}  // namespace dsc::dsc3d
