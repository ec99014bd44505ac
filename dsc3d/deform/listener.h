// SPDX-License-Identifier: GPL-3.0-or-later
// The reports of a step, and who listens to it, in space: see motion/listener.h.
#pragma once

#include "motion/listener.h"

namespace dsc::dsc3d {

using Contact = motion::Contact<3>;
using Event = motion::Event<3>;
using StepReport = motion::StepReport<3>;

class Listener : public motion::Listener<3> {
public:
    /// Before each substep, of `wanted` when nothing is late: nothing is half-done then, and what this throws ends the
    /// step there. A later step is one from where things are.
    virtual void on_substep(int substep, int wanted) { static_cast<void>(substep), static_cast<void>(wanted); }
};

}  // namespace dsc::dsc3d
