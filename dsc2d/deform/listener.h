// SPDX-License-Identifier: GPL-3.0-or-later
// The reports of a step, and who listens to it, in the plane: see motion/listener.h.
#pragma once

#include "motion/listener.h"

namespace dsc::dsc2d {

using Contact = motion::Contact<2>;
using Event = motion::Event<2>;
using StepReport = motion::StepReport<2>;
using Listener = motion::Listener<2>;

}  // namespace dsc::dsc2d
