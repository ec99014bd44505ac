// SPDX-License-Identifier: GPL-3.0-or-later
// Motion of one vertex towards its target, as far as its link allows.
// Source: thesis 4.3, algorithm 5. Guarantee: every tetrahedron stays positive by exact predicate, and none becomes
// worse than asked for, or than the worst of the star is. Cost: linear in the star.
#pragma once

#include "dsc3d/operations/rated_mesh.h"

namespace dsc::dsc3d {

struct MoveToLinkParameters {
    double least_quality;       ///< no tetrahedron becomes worse than this, or than the worst one is
    double approach;            ///< share of the way to the link that is tried first where the target is beyond it
    double least_share = 0.05;  ///< of the whole way: shorter moves are not worth it
};

/// True when v is at its target afterwards.
bool move_to_link(RatedMesh& mesh, VertexId v, const Point3& target, const MoveToLinkParameters& parameters);

}  // namespace dsc::dsc3d
