// SPDX-License-Identifier: GPL-3.0-or-later
// The edge lengths that the interface should have, from what is asked for on the command line. Source: thesis 4.3.2.2;
// surface/sizing.h. Cost: n log n in the interface.
#pragma once

#include <string>

#include "apps/flow/flow.h"

namespace dsc::flow {

/// The motion with wanted lengths for every step. `text`: "uniform" (the same length everywhere), "curvature",
/// "thickness", or an expression in x, y, z, t, whose values are lengths. Wanted lengths are at most `edge_length`, by
/// curvature at least a quarter of it, by thickness half, by expression a hundredth. Throws core::InputError for an
/// expression that can't be read; the motion then throws core::UsageError at time 0 and core::RunError later for a
/// length that is not positive.
Targets with_sizing(Targets motion, const std::string& text, double edge_length);

}  // namespace dsc::flow
