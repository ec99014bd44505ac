// SPDX-License-Identifier: GPL-3.0-or-later
// Detail control: as many vertices off the interface as the mesh needs, and an interface of even spacing.
// Source: thesis 4.3.1. Guarantee: thin_out and split_needles leave the interface as it is. Cost: linear in the
// active set times the valence.
#pragma once

#include "dsc2d/deform/pass_context.h"

namespace dsc::dsc2d {

/// Collapses short edges at vertices off the interface.
void thin_out(PassContext& context);

/// Halves the longest edge off the interface of needles; the flips that follow make the needles go.
void split_needles(PassContext& context);

/// Halves long and collapses short edges of the interface, where the parameters ask for it.
void respace_interface(PassContext& context);

}  // namespace dsc::dsc2d
