// SPDX-License-Identifier: GPL-3.0-or-later
// The result of the program flow as JSON (report.json) and as text to read.
#pragma once

#include <string>

#include "apps/flow/result.h"
#include "apps/flow/step_record.h"
#include "io/json.h"

namespace dsc::flow {

using FlowResult = ResultOf<3, StepRecord>;

io::Json report_json(const FlowResult& result, const io::Json& given);

/// The state at the start and at the end side by side, and how the run ended.
std::string report_text(const FlowResult& result);

}  // namespace dsc::flow
