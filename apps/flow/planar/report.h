// SPDX-License-Identifier: GPL-3.0-or-later
// The result of a flow in the plane as JSON (report.json) and as text to read.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "apps/flow/planar/step_record.h"
#include "apps/flow/report.h"
#include "apps/flow/time_steps.h"
#include "io/json.h"

namespace dsc::flow::planar {

struct FlowResult {
    Eigen::AlignedBox2d domain;
    bool is_torus = false;
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

}  // namespace dsc::flow::planar
