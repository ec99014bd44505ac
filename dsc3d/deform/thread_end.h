// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a vertex is the end of a thread: a part of its region that is drawn out so thin that its edges around can't
// be collapsed without cutting it off. Where the topology policy forbids that, threads would be left behind by whatever
// draws them, too thin to move, and hold up all that comes near.
// Source: thesis 4.3.2.1 (degeneracy removal), for what is degenerate in two directions. Guarantee: none is found where
// something may be squeezed away, where more than two regions meet, nor in the middle of a thread or at its root. Cost:
// linear in the star.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "dsc3d/deform/pass_context.h"

namespace dsc::dsc3d {

class ThreadEnd {
public:
    /// Whether v ends a thread: of one region it has next to nothing around it, and all its edges on the interface that
    /// are not degenerate go the same way. Then spokes() are its edges on the interface.
    bool find(PassContext& context, VertexId v);
    /// With their lengths, the shortest first.
    std::span<const std::pair<double, EdgeId>> spokes() const { return spokes_; }
    /// The shortest of those that are not degenerate.
    EdgeId shortest_along() const { return shortest_along_; }

private:
    bool is_thin(PassContext& context, VertexId v);
    void gather_spokes(PassContext& context, VertexId v);
    bool goes_one_way(const PassContext& context, VertexId v);

    std::vector<std::pair<int, double>> volumes_;  ///< of each label around the vertex
    std::vector<std::pair<double, EdgeId>> spokes_;
    EdgeId shortest_along_;
};

}  // namespace dsc::dsc3d
