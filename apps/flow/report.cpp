// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/report.h"

#include <fmt/core.h>

#include "apps/flow/report_parts.h"
#include "core/assert.h"
#include "io/number.h"

namespace dsc::flow {

using io::Json;

namespace {

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

Json step_json(const StepRecord& step) {
    Json labels = Json::array();
    for (const dsc3d::LabelStatistics& label : step.labels) labels.push_back(label_json(label));
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
                         {"in_contact", step.in_contact},
                         {"largest_remainder", step.largest_remainder},
                         {"operations", counts_json(step.counts)},
                         {"ms", milliseconds_json(step.milliseconds)}});
}

}  // namespace

Json report_json(const FlowResult& result, const Json& given) { return result_json(result, given, step_json); }

std::string report_text(const FlowResult& result) {
    DSC_ASSERT(!result.steps.empty());
    const StepRecord &first = result.steps.front(), &last = result.steps.back();
    FigureTable table;
    const auto row = [&](const std::string& name, const auto& figure) { table.add(name, figure(first), figure(last)); };
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
        const std::string name = "label " + std::to_string(label.label) + ": ";
        const auto of_label = [&](const std::string& what, const auto& figure) {
            row(name + what, [&](const StepRecord& step) { return label_figure(step, label.label, figure, "-"); });
        };
        of_label("volume", [](const auto& found) { return io::number_text(found.volume, 10); });
        of_label("components, genus",
                 [](const auto& found) { return fmt::format("{}, {}", found.components, found.genus); });
    }
    return table.text() + end_line(result);
}

}  // namespace dsc::flow
