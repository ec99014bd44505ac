// SPDX-License-Identifier: GPL-3.0-or-later
// Edge collapse: from(h) is removed, everything that hung on it hangs on to(h).
// Source: thesis 4.3.1 (detail control, degeneracy removal). Guarantee: link condition and orientation are judged
// exactly in the cover, before anything changes. Cost: the product of the two valences at worst, no allocation.
#pragma once

#include <cstdint>

#include "dsc2d/complex.h"

namespace dsc::dsc2d {

enum class CollapseRule : std::uint8_t {
    keep_interface,     ///< only vertices that are not on the interface go: the interface is untouched
    coarsen_interface,  ///< also along an interface edge, from a vertex where two interface edges meet
    change_topology,    ///< also across a region, joining two parts of the interface
};

/// True when from(h) can go: it is neither locked nor on the domain's boundary, the rule allows it, the cover stays
/// simplicial and every changed face stays strictly counterclockwise.
bool can_collapse(const Complex& complex, HalfedgeId h, CollapseRule rule);

/// Precondition: can_collapse. The surviving vertex is the former to(h).
void collapse(Complex& complex, HalfedgeId h);

/// Smallest angle among the faces at from(h) that would survive the collapse, as they would be after it [rad]; pi when
/// none survives. The walk ends early when a face falls below `enough`; then the value is only known to be below it.
double min_angle_after_collapse(const Complex& complex, HalfedgeId h, double enough = 0.0);

}  // namespace dsc::dsc2d
