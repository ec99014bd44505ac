// SPDX-License-Identifier: GPL-3.0-or-later
// The result of the program flow as JSON (report.json) and as text to read.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "apps/common/names.h"
#include "apps/flow/options.h"
#include "apps/flow/step_record.h"
#include "apps/flow/time_steps.h"
#include "io/json.h"

namespace dsc::flow {

enum class FlowEnd { done, vanished, cancelled, stopped };

inline constexpr std::array end_names{
    apps::Name{"done", FlowEnd::done},
    apps::Name{"vanished", FlowEnd::vanished},
    apps::Name{"cancelled", FlowEnd::cancelled},
    apps::Name{"stopped", FlowEnd::stopped},
};

struct FlowResult {
    Eigen::AlignedBox3d domain;
    double edge_length = 0;
    TimeSteps time;
    std::vector<StepRecord> steps;  ///< the first one is the state at the start
    std::vector<FlowEvent> events;
    FlowEnd end = FlowEnd::done;
    std::string reason;  ///< one sentence: why it ended
    double seconds = 0;
};

io::Json report_json(const FlowResult& result, const io::Json& given);

/// The state at the start and at the end side by side, and how the run ended.
std::string report_text(const FlowResult& result);

}  // namespace dsc::flow
