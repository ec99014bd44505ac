// SPDX-License-Identifier: GPL-3.0-or-later
// Degeneracy removal: faces that are nearly flat go by collapse of an edge.
// Source: thesis 4.3.1. Guarantee: away from changes that the topology policy allows, the interface keeps its shape up
// to the size of a degenerate face. Cost: linear in the active set, plus the valence squared at a degenerate face.
#pragma once

#include "dsc2d/deform/pass_context.h"

namespace dsc::dsc2d {

/// Removes what can be removed of the degenerate faces at active vertices.
void remove_degeneracies(PassContext& context);

/// Removes a vertex off the interface by the collapse that leaves the best smallest angle; false when there is none.
bool remove_steiner_vertex(PassContext& context, VertexId v);

}  // namespace dsc::dsc2d
