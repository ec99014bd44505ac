// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/planar/report.h"

#include <fmt/core.h>

#include "apps/flow/report_parts.h"
#include "core/assert.h"
#include "io/number.h"

namespace dsc::flow::planar {

using io::Json;

namespace {

Json label_json(const dsc2d::LabelStatistics& label) {
    return Json::object({{"label", label.label},
                         {"triangles", label.triangles},
                         {"area", label.area},
                         {"interface_length", label.interface_length},
                         {"boundary_length", label.boundary_length},
                         {"components", label.components},
                         {"holes", label.holes}});
}

Json unfinished_json(const Unfinished& motion) {
    return Json::object({{"place", point_json(motion.place)},
                         {"remaining", point_json(motion.remaining)},
                         {"contact", motion.is_in_contact}});
}

Json step_json(const StepRecord& step) {
    Json labels = Json::array(), unfinished = Json::array();
    for (const dsc2d::LabelStatistics& label : step.labels) labels.push_back(label_json(label));
    for (const Unfinished& motion : step.unfinished) unfinished.push_back(unfinished_json(motion));
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
                         {"ms", milliseconds_json(step.milliseconds)}});
}

}  // namespace

Json report_json(const FlowResult& result, const Json& given) {
    Json report = result_json(result, given, step_json);
    report["torus"] = result.is_torus;
    return report;
}

std::string report_text(const FlowResult& result) {
    DSC_ASSERT(!result.steps.empty());
    const StepRecord &first = result.steps.front(), &last = result.steps.back();
    FigureTable table;
    const auto row = [&](const std::string& name, const auto& figure) { table.add(name, figure(first), figure(last)); };
    row("time", [](const StepRecord& step) { return io::number_text(step.time, 6); });
    row("triangles", [](const StepRecord& step) { return std::to_string(step.triangles); });
    row("interface edges", [](const StepRecord& step) { return std::to_string(step.interface_edges); });
    row("unchanged edges, %", [](const StepRecord& step) { return fmt::format("{:.2f}", 100 * step.unchanged_share); });
    row("smallest angle, degrees", [](const StepRecord& step) { return fmt::format("{:.3f}", step.min_angle); });
    row("inverted", [](const StepRecord& step) { return std::to_string(step.inverted); });
    for (const dsc2d::LabelStatistics& label : first.labels) {
        const std::string name = "label " + std::to_string(label.label) + ": ";
        const auto of_label = [&](const std::string& what, const auto& figure) {
            row(name + what, [&](const StepRecord& step) { return label_figure(step, label.label, figure, "-"); });
        };
        of_label("area", [](const auto& found) { return io::number_text(found.area, 10); });
        of_label("components, holes",
                 [](const auto& found) { return fmt::format("{}, {}", found.components, found.holes); });
    }
    return table.text() + end_line(result);
}

}  // namespace dsc::flow::planar
