// SPDX-License-Identifier: GPL-3.0-or-later
// The result of the program improve as text to read and as JSON (keys: docs/improve.md).
#pragma once

#include <optional>
#include <string>

#include "apps/improve/mesh_statistics.h"
#include "dsc3d/improve/improve.h"
#include "io/json.h"

namespace dsc::improve {

/// A mesh that was judged, and improved unless only a report was asked for.
struct Improvement {
    std::string input;
    std::optional<std::string> output;  ///< where the mesh went
    dsc3d::ImproveParameters parameters;
    MeshStatistics before;
    std::optional<MeshStatistics> after;
    std::optional<dsc3d::ImproveReport> run;
    double read_seconds = 0;
    double total_seconds = 0;
};

/// Figures before and after side by side, the histogram of all dihedral angles, how the run ended.
std::string report_text(const Improvement& improvement);

io::Json report_json(const Improvement& improvement);

/// One sentence: why the run ended.
std::string end_reason(const Improvement& improvement);

}  // namespace dsc::improve
