// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/report.h"

#include <fmt/core.h>

#include <algorithm>

#include "apps/flow/names.h"
#include "core/assert.h"
#include "core/version.h"
#include "io/number.h"

namespace dsc::flow {

using io::Json;

namespace {

Json point_json(const Point3& p) { return Json(std::vector<double>(p.begin(), p.end())); }

Json label_json(const dsc3d::LabelStatistics& label) {
    return Json::object({{"label", label.label},
                         {"tets", label.tets},
                         {"volume", label.volume},
                         {"interface_area", label.interface_area},
                         {"boundary_area", label.boundary_area},
                         {"components", label.components},
                         {"surfaces", label.surfaces},
                         {"genus", label.genus}});
}

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

Json step_json(const StepRecord& step) {
    Json labels = Json::array();
    for (const dsc3d::LabelStatistics& label : step.labels) labels.push_back(label_json(label));
    Json milliseconds = Json::object();
    for (const auto& [phase, time] : step.milliseconds) milliseconds[phase] = time;
    return Json::object({{"step", step.step},
                         {"time", step.time},
                         {"vertices", step.vertices},
                         {"tets", step.tets},
                         {"interface_faces", step.interface_faces},
                         {"unchanged_share", step.unchanged_share},
                         {"labels", labels},
                         {"min_dihedral", step.min_dihedral},
                         {"max_dihedral", step.max_dihedral},
                         {"min_quality", step.min_quality},
                         {"inverted", step.inverted},
                         {"complete", step.is_complete},
                         {"substeps", step.substeps},
                         {"unfinished", step.unfinished},
                         {"largest_remainder", step.largest_remainder},
                         {"operations", counts_json(step.counts)},
                         {"ms", milliseconds}});
}

Json event_json(const FlowEvent& event) {
    return Json::object({{"kind", event.kind},
                         {"step", event.step},
                         {"time", event.time},
                         {"place", point_json(event.place)},
                         {"label", event.label}});
}

}  // namespace

Json report_json(const FlowResult& result, const Json& given) {
    Json steps = Json::array(), events = Json::array();
    for (const StepRecord& step : result.steps) steps.push_back(step_json(step));
    for (const FlowEvent& event : result.events) events.push_back(event_json(event));
    return Json::object({{"program", "flow"},
                         {"version", core::version()},
                         {"options", given},
                         {"domain", Json::array({point_json(result.domain.min()), point_json(result.domain.max())})},
                         {"edge_length", result.edge_length},
                         {"dt", result.time.dt},
                         {"until", result.time.until},
                         {"end", name_of(end_names, result.end)},
                         {"end_reason", result.reason},
                         {"seconds", result.seconds},
                         {"events", events},
                         {"steps", steps}});
}

std::string report_text(const FlowResult& result) {
    DSC_ASSERT(!result.steps.empty());
    const StepRecord &first = result.steps.front(), &last = result.steps.back();
    std::string text = fmt::format("{:<32}{:>16}{:>16}\n", "", "start", "end");
    const auto row = [&](const std::string& name, const auto& figure) {
        text += fmt::format("{:<32}{:>16}{:>16}\n", name, figure(first), figure(last));
    };
    row("time", [](const StepRecord& step) { return io::number_text(step.time, 6); });
    row("tetrahedra", [](const StepRecord& step) { return std::to_string(step.tets); });
    row("interface triangles", [](const StepRecord& step) { return std::to_string(step.interface_faces); });
    row("unchanged triangles, %",
        [](const StepRecord& step) { return fmt::format("{:.2f}", 100 * step.unchanged_share); });
    row("smallest dihedral angle, degrees",
        [](const StepRecord& step) { return fmt::format("{:.3f}", step.min_dihedral); });
    row("worst quality", [](const StepRecord& step) { return io::number_text(step.min_quality, 4); });
    row("inverted", [](const StepRecord& step) { return std::to_string(step.inverted); });
    for (const dsc3d::LabelStatistics& label : first.labels) {
        const auto of = [&](const StepRecord& step, const auto& figure) {
            const auto found = std::ranges::find(step.labels, label.label, &dsc3d::LabelStatistics::label);
            return found == step.labels.end() ? std::string("-") : figure(*found);
        };
        const std::string name = "label " + std::to_string(label.label) + ": ";
        row(name + "volume", [&](const StepRecord& step) {
            return of(step, [](const auto& found) { return io::number_text(found.volume, 10); });
        });
        row(name + "components, genus", [&](const StepRecord& step) {
            return of(step, [](const auto& found) { return fmt::format("{}, {}", found.components, found.genus); });
        });
    }
    const std::size_t incomplete =
        static_cast<std::size_t>(std::ranges::count(result.steps, false, &StepRecord::is_complete));
    text += fmt::format("{}; {} steps, {} of them with motion left over, {} events, {:.2f} s\n", result.reason,
                        result.steps.size() - 1, incomplete, result.events.size(), result.seconds);
    return text;
}

}  // namespace dsc::flow
