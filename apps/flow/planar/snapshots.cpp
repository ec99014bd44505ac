// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/planar/snapshots.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "apps/flow/report_parts.h"
#include "core/assert.h"
#include "dsc2d/interface.h"
#include "io/number.h"

namespace dsc::flow::planar {

using dsc2d::Complex;
using dsc2d::InterfaceCurve;

namespace {

Eigen::Vector3d lifted(const Point2& p) { return {p.x(), p.y(), 0}; }

// The translation that takes a place into the period of the domain.
Point2 into_domain(const dsc2d::Domain& domain, const Point2& place) {
    const Point2 shares = domain.basis().inverse() * (place - domain.origin());
    dsc2d::LatticeVector cell = dsc2d::LatticeVector::Zero();
    for (int k = 0; k < 2; ++k)
        if (domain.is_periodic(k)) cell[k] = -static_cast<int>(std::floor(shares[k]));
    return domain.translation(cell);
}

io::ViewLine drawn(const Complex& complex, const InterfaceCurve& curve) {
    const Point2 shift = into_domain(complex.domain(), curve.points.front().place);
    io::ViewLine line;
    for (const dsc2d::CurvePoint& point : curve.points) line.push_back(lifted(point.place + shift));
    return line;
}

io::ViewLines box_lines(const Eigen::AlignedBox2d& box) {
    const Point2 low = box.min(), high = box.max();
    io::ViewLine outline;
    for (const Point2& p : {low, Point2(high.x(), low.y()), high, Point2(low.x(), high.y()), low})
        outline.push_back(lifted(p));
    return {.name = "domain", .lines = {outline}, .colour = "#909090", .width = 1};
}

io::ViewLines mesh_lines(const Complex& complex) {
    io::ViewLines mesh{.name = "mesh at the end", .colour = "#b8c4cc", .width = 1, .is_visible = false};
    for (std::uint32_t i = 0; i < complex.edge_capacity(); ++i) {
        const core::EdgeId e(i);
        if (complex.is_deleted(e) || complex.is_interface(e)) continue;
        const core::HalfedgeId h = Complex::halfedge(e);
        const Point2 from = complex.position(complex.from(h));
        const Point2 begin = from + into_domain(complex.domain(), from);
        mesh.lines.push_back({lifted(begin), lifted(begin + complex.vector(h))});
    }
    return mesh;
}

}  // namespace

DrawnCurves::Interface DrawnCurves::interface(const Complex& complex) {
    Interface curves;
    for (const InterfaceCurve& curve : dsc2d::interface_curves(complex))
        curves.push_back({{curve.right, curve.left}, drawn(complex, curve)});
    return curves;
}

io::PolyData DrawnCurves::poly_data(const Interface& curves) {
    io::PolyData data;
    io::VtkData left{.name = "left_label"}, right{.name = "right_label"};
    for (const DrawnCurve& curve : curves) {
        const bool is_loop = curve.line.front() == curve.line.back();
        const auto first = static_cast<std::uint32_t>(data.points.size());
        data.points.insert(data.points.end(), curve.line.begin(), curve.line.end() - (is_loop ? 1 : 0));
        std::vector<std::uint32_t>& indices = data.lines.emplace_back(data.points.size() - first);
        std::iota(indices.begin(), indices.end(), first);
        if (is_loop) indices.push_back(first);
        right.values.push_back(curve.labels[0]);
        left.values.push_back(curve.labels[1]);
    }
    data.cell_data = {left, right};
    return data;
}

std::vector<io::ViewSeries> Snapshots::series() const {
    std::map<std::array<int, 2>, io::ViewSeries> by_labels;
    for (const Frame& frame : frames())
        for (const DrawnCurve& curve : frame.interface) by_labels.try_emplace(curve.labels);
    std::vector<io::ViewSeries> result;
    for (auto& [labels, series] : by_labels) {
        series.name = sides_name(labels[0], labels[1]);
        series.colour = label_colour(labels[1]);
        series.width = 2.5;
        for (const Frame& frame : frames()) {
            series.times.push_back(frame.time);
            std::vector<io::ViewLine>& lines = series.frames.emplace_back();
            for (const DrawnCurve& curve : frame.interface)
                if (curve.labels == labels) lines.push_back(curve.line);
        }
        result.push_back(std::move(series));
    }
    return result;
}

io::HtmlPage html_page(const FlowResult& result, const Complex& last, const Snapshots& snapshots,
                       const std::string& title) {
    DSC_ASSERT(!result.steps.empty());
    io::HtmlPage page{.title = title};
    const StepRecord &start = result.steps.front(), &end = result.steps.back();
    const auto add = [&](const std::string& name, const auto& figure) {
        page.facts.emplace_back(name, figure(start) + " → " + figure(end));
    };
    add("triangles", [](const StepRecord& step) { return std::to_string(step.triangles); });
    add("interface edges", [](const StepRecord& step) { return std::to_string(step.interface_edges); });
    add("smallest angle", [](const StepRecord& step) { return fmt::format("{:.2f}°", step.min_angle); });
    for (const dsc2d::LabelStatistics& label : start.labels) {
        const std::string name = "area of label " + std::to_string(label.label);
        const auto area = [](const auto& found) { return io::number_text(found.area, 6); };
        add(name, [&](const StepRecord& step) { return label_figure(step, label.label, area, "0"); });
    }
    page.facts.emplace_back("events", std::to_string(result.events.size()));
    page.facts.emplace_back("end", result.reason);
    io::HtmlView view{.name = "interface", .is_flat = true};
    view.series = snapshots.series();
    view.lines = {box_lines(result.domain), mesh_lines(last)};
    if (auto events = event_points(result.events)) view.points.push_back(std::move(*events));
    page.views.push_back(std::move(view));
    return page;
}

}  // namespace dsc::flow::planar
