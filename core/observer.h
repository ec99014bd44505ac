// SPDX-License-Identifier: GPL-3.0-or-later
// The one seam through which a long computation talks to its caller: progress out, cancellation in.
// Libraries print nothing; a program derives from Observer (apps/common/progress.h) to show a line or to catch Ctrl-C.
// Cost: one virtual call per step of an algorithm, never one per simplex.
#pragma once

#include <string_view>

#include "core/errors.h"

namespace dsc::core {

class Observer {
public:
    virtual ~Observer() = default;

    /// `stage` names what is being done, `fraction` lies in [0, 1], or is negative when the end is not known;
    /// `figure` is a short text of the current state ("front 712 vertices, 40 % locked").
    virtual void progress(std::string_view stage, double fraction, std::string_view figure) {
        static_cast<void>(stage), static_cast<void>(fraction), static_cast<void>(figure);
    }

    /// True when the caller wants the computation to end at the next consistent state.
    virtual bool is_cancelled() const { return false; }

    /// Throws Cancelled when the caller wants to stop; called by algorithms where stopping leaves nothing half-done.
    void check_cancelled() const {
        if (is_cancelled()) throw Cancelled();
    }
};

}  // namespace dsc::core
