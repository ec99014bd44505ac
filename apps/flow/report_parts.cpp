// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/report_parts.h"

#include <fmt/core.h>

#include <array>
#include <cstdlib>

namespace dsc::flow {

using io::Json;

Json counts_json(const motion::StepCounts& counts) {
    return Json::object({{"moves", counts.moves},
                         {"blocked_moves", counts.blocked_moves},
                         {"flips", counts.flips},
                         {"collapses", counts.collapses},
                         {"edge_splits", counts.edge_splits},
                         {"face_splits", counts.face_splits},
                         {"smoothings", counts.smoothings},
                         {"topology_changes", counts.topology_changes}});
}

Json milliseconds_json(const std::vector<std::pair<std::string, double>>& milliseconds) {
    Json json = Json::object();
    for (const auto& [phase, time] : milliseconds) json[phase] = time;
    return json;
}

FigureTable::FigureTable() { add("", "start", "end"); }

void FigureTable::add(const std::string& name, const std::string& start, const std::string& end) {
    text_ += fmt::format("{:<32}{:>16}{:>16}\n", name, start, end);
}

std::string end_line(const std::string& reason, std::size_t steps, std::size_t incomplete, std::size_t events,
                     double seconds) {
    return fmt::format("{}; {} steps, {} of them with motion left over, {} events, {:.2f} s\n", reason, steps,
                       incomplete, events, seconds);
}

std::string label_colour(int label) {
    constexpr std::array colours = {"#8a9aa8", "#4a7ab5", "#d98032", "#5a9e57", "#b05a8f", "#c9b03a"};
    return colours[static_cast<std::size_t>(std::abs(label)) % colours.size()];
}

std::string sides_name(int low, int high) { return "between " + std::to_string(low) + " and " + std::to_string(high); }

}  // namespace dsc::flow
