// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/snapshots.h"

#include <fmt/core.h>

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include "apps/flow/report_parts.h"
#include "core/assert.h"
#include "dsc3d/interface.h"
#include "io/number.h"

namespace dsc::flow {

using geometry::InterfaceData;

namespace {

// The triangles between two labels, with the vertices they use.
io::ViewSurfaceFrame part(const InterfaceData& interface, const std::array<int, 2>& labels) {
    constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
    io::ViewSurfaceFrame frame;
    std::vector<std::uint32_t> number(interface.surface.vertices.size(), unused);
    for (std::size_t i = 0; i < interface.sides.size(); ++i) {
        if (interface.sides[i] != labels) continue;
        std::array<std::uint32_t, 3> triangle = interface.surface.triangles[i];
        for (std::uint32_t& v : triangle) {
            if (number[v] == unused) {
                number[v] = static_cast<std::uint32_t>(frame.vertices.size());
                frame.vertices.push_back(interface.surface.vertices[v]);
            }
            v = number[v];
        }
        frame.triangles.push_back(triangle);
    }
    return frame;
}

io::ViewLines box_lines(const Eigen::AlignedBox3d& box) {
    io::ViewLines lines{.name = "domain", .colour = "#909090", .width = 1};
    for (int corner = 0; corner < 8; ++corner) {
        for (int axis = 0; axis < 3; ++axis) {
            if ((corner >> axis & 1) != 0) continue;
            const auto place = [&](int k) { return box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k)); };
            lines.lines.push_back({place(corner), place(corner | 1 << axis)});
        }
    }
    return lines;
}

}  // namespace

InterfaceData DrawnSurface::interface(const dsc3d::Mesh& mesh) { return dsc3d::Interface(mesh).data; }

io::PolyData DrawnSurface::poly_data(const InterfaceData& interface) {
    io::PolyData data{.points = interface.surface.vertices};
    for (const auto& [a, b, c] : interface.surface.triangles) data.polygons.push_back({a, b, c});
    io::VtkData front{.name = "front_label"}, back{.name = "back_label"};
    for (const auto& [in_front, behind] : interface.sides) {
        front.values.push_back(in_front);
        back.values.push_back(behind);
    }
    data.cell_data = {front, back};
    return data;
}

std::vector<io::ViewSurfaceSeries> Snapshots::series() const {
    std::map<std::array<int, 2>, io::ViewSurfaceSeries> by_labels;
    for (const Frame& frame : frames())
        for (const auto& labels : frame.interface.sides) by_labels.try_emplace(labels);
    std::vector<io::ViewSurfaceSeries> result;
    for (auto& [labels, series] : by_labels) {
        series.name = sides_name(labels[0], labels[1]);
        series.colour = label_colour(labels[1]);
        for (const Frame& frame : frames()) {
            series.times.push_back(frame.time);
            series.frames.push_back(part(frame.interface, labels));
        }
        result.push_back(std::move(series));
    }
    return result;
}

io::HtmlPage html_page(const FlowResult& result, const Snapshots& snapshots, const std::string& title) {
    DSC_ASSERT(!result.steps.empty());
    io::HtmlPage page{.title = title};
    const StepRecord &first = result.steps.front(), &last = result.steps.back();
    const auto add = [&](const std::string& name, const auto& figure) {
        page.facts.emplace_back(name, figure(first) + " → " + figure(last));
    };
    add("tetrahedra", [](const StepRecord& step) { return std::to_string(step.tets); });
    add("interface triangles", [](const StepRecord& step) { return std::to_string(step.interface_faces); });
    add("smallest angle", [](const StepRecord& step) { return fmt::format("{:.2f}°", step.min_dihedral); });
    for (const dsc3d::LabelStatistics& label : first.labels) {
        const std::string name = "volume of label " + std::to_string(label.label);
        const auto volume = [](const auto& found) { return io::number_text(found.volume, 6); };
        add(name, [&](const StepRecord& step) { return label_figure(step, label.label, volume, "0"); });
    }
    page.facts.emplace_back("events", std::to_string(result.events.size()));
    page.facts.emplace_back("end", result.reason);
    io::HtmlView view{.name = "interface"};
    view.surface_series = snapshots.series();
    view.lines.push_back(box_lines(result.domain));
    if (auto events = event_points(result.events)) view.points.push_back(std::move(*events));
    page.views.push_back(std::move(view));
    return page;
}

}  // namespace dsc::flow
