// SPDX-License-Identifier: GPL-3.0-or-later
// How parameters and input say that they can't be as they are: one line each for what has to hold.
#pragma once

#include <string>

#include "core/errors.h"

namespace dsc::core {

/// Throws UsageError(what) unless the condition holds.
inline void require(bool condition, const char* what) {
    if (!condition) throw UsageError(what);
}

/// The same of a field of some parameters: "feature_angle: has to be in (0, 90)".
inline void require(bool condition, const char* field, const std::string& range) {
    if (!condition) throw UsageError(std::string(field) + ": has to be " + range);
}

}  // namespace dsc::core
