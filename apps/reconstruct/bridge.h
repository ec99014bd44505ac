// SPDX-License-Identifier: GPL-3.0-or-later
// What spans a gap in the sampling: the vertices of the interface that have no points near them go to where a thin
// plate would be that is clamped to the surface around the gap, so that the surface goes on with its tangents and bends
// as little as it can. Source: Botsch, Kobbelt (2004), "An intuitive framework for real-time freeform modeling" (the
// clamped plate as a linear system); holes filled so: Liepa (2003), "Filling holes in meshes". Guarantee: the complex
// is valid after every move, the topology of its interface stays; vertices near points stay where they are. Cost: that
// of a sparse factorization of the vertices in gaps, per round.
#pragma once

#include "apps/reconstruct/cloud.h"
#include "apps/reconstruct/workbench.h"
#include "core/observer.h"

namespace dsc::reconstruct {

struct BridgeParameters {
    /// A gap is a connected set of vertices farther than this from all points [spacing of the nearest point]; > 0 ...
    double rim = 1.5;
    double depth = 3;  ///< ... with one that is farther than this, which random sampling leaves next to nowhere; >= rim
    int rounds = 10;   ///< of moving to the plate, in equal steps, so that the tetrahedra can follow; >= 0

    /// Throws core::UsageError naming the field.
    void validate() const;
};

/// The number of vertices in gaps.
std::size_t bridge_gaps(Workbench& bench, const Cloud& cloud, const KdTree& tree, const BridgeParameters& parameters,
                        core::Observer& observer);

}  // namespace dsc::reconstruct
