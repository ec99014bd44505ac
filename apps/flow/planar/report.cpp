// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/planar/report.h"

#include <fmt/core.h>

#include <algorithm>

#include "apps/flow/names.h"
#include "core/assert.h"
#include "core/version.h"
#include "io/number.h"

namespace dsc::flow::planar {

using io::Json;

namespace {

Json point_json(const Point2& p) { return Json(std::vector<double>(p.begin(), p.end())); }

Json label_json(const dsc2d::LabelStatistics& label) {
    return Json::object({{"label", label.label},
                         {"triangles", label.triangles},
                         {"area", label.area},
                         {"interface_length", label.interface_length},
                         {"boundary_length", label.boundary_length},
                         {"components", label.components},
                         {"holes", label.holes}});
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

Json unfinished_json(const Unfinished& motion) {
    return Json::object({{"place", point_json(motion.place)},
                         {"remaining", point_json(motion.remaining)},
                         {"contact", motion.is_in_contact}});
}

Json step_json(const StepRecord& step) {
    Json labels = Json::array(), unfinished = Json::array(), milliseconds = Json::object();
    for (const dsc2d::LabelStatistics& label : step.labels) labels.push_back(label_json(label));
    for (const Unfinished& motion : step.unfinished) unfinished.push_back(unfinished_json(motion));
    for (const auto& [phase, time] : step.milliseconds) milliseconds[phase] = time;
    return Json::object({{"step", step.step},
                         {"time", step.time},
                         {"vertices", step.vertices},
                         {"triangles", step.triangles},
                         {"interface_edges", step.interface_edges},
                         {"unchanged_share", step.unchanged_share},
                         {"labels", labels},
                         {"min_angle", step.min_angle},
                         {"max_angle", step.max_angle},
                         {"inverted", step.inverted},
                         {"complete", step.is_complete},
                         {"substeps", step.substeps},
                         {"unfinished", unfinished},
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
                         {"dimension", 2},
                         {"domain", Json::array({point_json(result.domain.min()), point_json(result.domain.max())})},
                         {"torus", result.is_torus},
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
    row("triangles", [](const StepRecord& step) { return std::to_string(step.triangles); });
    row("interface edges", [](const StepRecord& step) { return std::to_string(step.interface_edges); });
    row("unchanged edges, %", [](const StepRecord& step) { return fmt::format("{:.2f}", 100 * step.unchanged_share); });
    row("smallest angle, degrees", [](const StepRecord& step) { return fmt::format("{:.3f}", step.min_angle); });
    row("inverted", [](const StepRecord& step) { return std::to_string(step.inverted); });
    for (const dsc2d::LabelStatistics& label : first.labels) {
        const auto of = [&](const StepRecord& step, const auto& figure) {
            const auto found = std::ranges::find(step.labels, label.label, &dsc2d::LabelStatistics::label);
            return found == step.labels.end() ? std::string("-") : figure(*found);
        };
        const std::string name = "label " + std::to_string(label.label) + ": ";
        row(name + "area", [&](const StepRecord& step) {
            return of(step, [](const auto& found) { return io::number_text(found.area, 10); });
        });
        row(name + "components, holes", [&](const StepRecord& step) {
            return of(step, [](const auto& found) { return fmt::format("{}, {}", found.components, found.holes); });
        });
    }
    const auto incomplete = std::ranges::count(result.steps, false, &StepRecord::is_complete);
    text += fmt::format("{}; {} steps, {} of them with motion left over, {} events, {:.2f} s\n", result.reason,
                        result.steps.size() - 1, incomplete, result.events.size(), result.seconds);
    return text;
}

}  // namespace dsc::flow::planar
