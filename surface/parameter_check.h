// SPDX-License-Identifier: GPL-3.0-or-later
// How the parameters of this folder say that a field is out of its range.
#pragma once

#include <string>

#include "core/errors.h"

namespace dsc::surface {

/// Throws core::UsageError unless `condition` holds. "feature_angle: has to be in (0, 90)".
inline void require_range(bool condition, const char* field, const char* range) {
    if (!condition) throw core::UsageError(std::string(field) + ": has to be " + range);
}

}  // namespace dsc::surface
