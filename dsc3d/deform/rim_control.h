// SPDX-License-Identifier: GPL-3.0-or-later
// The interface next to the walls on which it ends: edges of the contact line, and those that end on it, are collapsed
// when they are too short and split when they are too long; vertices of the line are spaced evenly along it. Source:
// thesis 4.3.2.2, for contact lines. Guarantee: topology stays, and what lies on a wall stays on it; corners of the
// line stay but for edges too small to mean anything, and spikes; no tetrahedron becomes worse than
// `interface_quality`, or than it is. Cost: linear in the edges asked about.
#pragma once

#include <optional>
#include <span>

#include "dsc3d/deform/interface_ring.h"
#include "dsc3d/deform/pass_context.h"
#include "dsc3d/operations/edge_collapse.h"

namespace dsc::dsc3d {

class RimControl {
public:
    /// `edges` of the interface, whose length has changed; those off the walls are left to InterfaceControl. What is
    /// changed is added to the region.
    void run(PassContext& context, std::span<const EdgeId> edges);

private:
    /// The neighbours along the contact line; none at the end of a line, where lines meet, and at corners of a wall.
    std::optional<std::array<VertexId, 2>> neighbours(PassContext& context, VertexId v);
    bool is_corner(PassContext& context, VertexId v);
    /// Of the angle between the two edges of the line at v, which is no end of it; -1 where the line is straight.
    std::optional<double> cosine_at(PassContext& context, VertexId v);

    void collapse_short_edges(PassContext& context, std::span<const EdgeId> edges);
    bool collapse(PassContext& context, EdgeId e);
    bool collapse_to(PassContext& context, EdgeId e, VertexId kept, const Point3& place);
    void remove_spikes(PassContext& context, std::span<const EdgeId> edges);
    void split_long_edges(PassContext& context, std::span<const EdgeId> edges);
    void space_evenly(PassContext& context, std::span<const EdgeId> edges);

    EdgeCollapse collapse_;
    InterfaceRing ring_;
    InterfaceRing other_ring_;
    std::vector<VertexId> along_;
};

}  // namespace dsc::dsc3d
