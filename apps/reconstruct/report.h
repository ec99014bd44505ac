// SPDX-License-Identifier: GPL-3.0-or-later
// The result of the program reconstruct as text to read and as JSON (keys: docs/reconstruct.md).
#pragma once

#include <string>

#include "apps/reconstruct/reconstruct.h"
#include "io/json.h"

namespace dsc::reconstruct {

std::string report_text(const Reconstruction& result);

/// `given`: the command line.
io::Json report_json(const Reconstruction& result, const io::Json& given);

}  // namespace dsc::reconstruct
