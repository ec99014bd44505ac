// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices off the interface whose star has a small angle: they are put where the smallest angle of the star is
// largest, or removed, whichever leaves the larger one. Source: thesis 4.3.1 (mesh quality improvement); the search is
// by compass steps, as the angle has no derivative where it is largest. Guarantee: the smallest angle of what is
// changed grows; faces stay strictly counterclockwise by exact predicate; the interface stays. Cost: some 50 looks at
// each poor star, linear in the active set for the others.
#pragma once

#include "dsc2d/deform/pass_context.h"

namespace dsc::dsc2d {

/// Smallest angle of the faces at v with v moved by `shift`; negative when one of them would turn over [rad].
double min_angle_of_star(const Complex& complex, VertexId v, const Point2& shift = Point2::Zero());

/// One sweep over the active vertices, when the parameters have a poor angle.
void mend_poor_stars(PassContext& context);

}  // namespace dsc::dsc2d
