// SPDX-License-Identifier: GPL-3.0-or-later
// Detail control off the interface: edges that are too long are halved, so that there are vertices that can give way;
// edges that are too short are collapsed. Source: thesis 4.3.2.1 ("detail control"; edges that join the interface to
// itself or to the boundary). Guarantee: interfaces stay, the boundary is
// divided anew only where it is flat. Cost: linear in the region.
#pragma once

#include "dsc3d/deform/pass_context.h"
#include "dsc3d/operations/edge_collapse.h"

namespace dsc::dsc3d {

class DetailControl {
public:
    void split_long_edges(PassContext& context);
    void collapse_short_edges(PassContext& context);
    /// Those that are shorter than `relative_length`, in wanted lengths, and not longer than `length`.
    void collapse_edges(PassContext& context, double relative_length, double length);

    /// Wanted lengths off the interface follow what has moved in the region.
    static void update_lengths(PassContext& context);

private:
    EdgeCollapse collapse_;
    Proposal proposal_;
};

}  // namespace dsc::dsc3d
