// SPDX-License-Identifier: GPL-3.0-or-later
// Laplacian smoothing of the vertices off the interface, with inversion check.
// Source: thesis 4.3.1. Guarantee: a vertex moves only when all its faces stay strictly counterclockwise and the worst
// of them does not become worse. Cost: linear in the active set.
#pragma once

#include "dsc2d/deform/pass_context.h"

namespace dsc::dsc2d {

/// One sweep over the active vertices.
void smooth(PassContext& context);

}  // namespace dsc::dsc2d
