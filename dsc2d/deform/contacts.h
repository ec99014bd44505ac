// SPDX-License-Identifier: GPL-3.0-or-later
// Where parts of the interface are about to touch: short edges across a region, and caps, i.e. faces whose base is an
// interface edge and whose apex is an interface vertex close to it. The topology policy decides what follows: the two
// parts are joined (the edge is collapsed, the base of the cap flipped), or stopped (the base of the cap is split at
// the point nearest the apex; both vertices are locked, the contact is reported). A region that is a single thin face
// vanishes, or is stopped.
// Source: thesis 4.3.1 (interface topology changes), 5.2.2 (head-on self-collision). Guarantee: a contact is reported
// once; locked vertices stay. Cost: linear in the active set.
#pragma once

#include "dsc2d/deform/pass_context.h"

namespace dsc::dsc2d {

/// Finds and treats the contacts at the faces of active interface vertices.
void treat_contacts(PassContext& context);

/// Ends the motion of an interface vertex that the interface keeps from moving. face(blocking) is the face in its way,
/// blocking leaves `v`. False when the face has no other interface vertex.
bool treat_blocked_vertex(PassContext& context, VertexId v, HalfedgeId blocking);

}  // namespace dsc::dsc2d
