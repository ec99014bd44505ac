// SPDX-License-Identifier: GPL-3.0-or-later
// A run for programs (JSON), for readers (text) and as a page. Guarantee: what failed is in all of them.
#pragma once

#include <string>

#include "apps/fluid/run.h"
#include "apps/fluid/scene.h"
#include "io/html_view.h"
#include "io/json.h"

namespace dsc::fluid_app {

io::Json report_json(const Scene& scene, const RunResult& result, const io::Json& given);

/// Start and end side by side, and how it ended.
std::string report_text(const RunResult& result);

/// The surface over time with a slider.
io::HtmlPage html_page(const Scene& scene, const RunResult& result, const Series& series);

}  // namespace dsc::fluid_app
