// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/picture/svg_front.h"

#include <algorithm>
#include <cmath>

#include "apps/cutlocus/picture/geodesic_table.h"
#include "apps/cutlocus/picture/palette.h"
#include "core/errors.h"
#include "io/number.h"

namespace dsc::cutlocus {

using geodesic::Metric;
using geodesic::Point2;

namespace {

constexpr int columns = 3, rows = 2;
constexpr std::size_t most_geodesics = 110;  // per picture: more would fill it

/// Snapshots at about equal distances of time, the last one included.
std::vector<const FrontSnapshot*> selection(const std::vector<FrontSnapshot>& snapshots) {
    std::vector<const FrontSnapshot*> chosen;
    const double last = snapshots.back().t;
    for (int i = 1; i <= columns * rows; ++i) {
        const double t = last * i / (columns * rows);
        const auto nearest = std::min_element(snapshots.begin(), snapshots.end(), [&](const auto& a, const auto& b) {
            return std::abs(a.t - t) < std::abs(b.t - t);
        });
        if (chosen.empty() || chosen.back() != &*nearest) chosen.push_back(&*nearest);
    }
    return chosen;
}

std::vector<Polyline> geodesics_to(const FrontSnapshot& snapshot, GeodesicTable& table, double spacing) {
    const std::size_t stride = (snapshot.points.size() + most_geodesics - 1) / most_geodesics;
    std::vector<Polyline> lines;
    for (std::size_t i = 0; i < snapshot.points.size(); i += stride)
        lines.push_back(table.line(table.geodesic_to_vertex(snapshot.points[i]), spacing));
    return lines;
}

}  // namespace

Polyline front_line(const FrontSnapshot& snapshot, const geodesic::ChartPeriods& periods) {
    Polyline line;
    const auto add = [&](const Point2& x) {
        line.push_back(line.empty() ? x : Point2(line.back() + periods.wrapped(x - line.back())));
    };
    for (const Point2& x : snapshot.points) add(x);
    if (!line.empty()) add(snapshot.points.front());
    return line;
}

std::string svg_front(const Metric& metric, const Point2& p, const FrontResult& front, const ChartStyle& style) {
    if (front.snapshots.empty()) throw core::UsageError("a picture of the front needs snapshots of it");
    const CutDistance cut(front);
    const double scale = cut.limit();
    GeodesicTable table(metric, p, cut, scale / 60);
    table.add_stops(front);
    std::vector<Polyline> fronts;
    for (const FrontSnapshot& snapshot : front.snapshots) fronts.push_back(front_line(snapshot, metric.periods()));

    const io::SvgStyle geodesics{.stroke = palette::circle_colour, .stroke_width = 0.5};
    const io::SvgStyle front_style{.stroke = palette::front_colour, .stroke_width = 2};
    const MarkStyle generator{MarkShape::dot, "#000000", 3};
    const std::string title = style.has_title ? "The growing front of p = " + point_text(p, metric.periods()) +
                                                    (style.surface.empty() ? "" : ", " + style.surface)
                                              : "";
    ChartCanvas canvas(ChartBox(metric.periods(), Point2(0, 0), fronts),
                       {.columns = columns,
                        .rows = rows,
                        .width = 1.25 * style.width,
                        .title = chart_title("The growing front of p = ", metric, p, style)});
    int index = 0;
    for (const FrontSnapshot* snapshot : selection(front.snapshots)) {
        canvas.begin_chart(index++, "distance " + io::number_text(std::round(1000 * snapshot->t) / 1000, 4));
        canvas.lines("geodesics", geodesics, geodesics_to(*snapshot, table, scale / 200));
        canvas.lines("front", front_style, {front_line(*snapshot, metric.periods())});
        canvas.marks("p", generator, {p});
    }
    canvas.legend_line("front", front_style);
    canvas.legend_line("geodesics of its vertices", geodesics);
    canvas.legend_mark("p", generator);
    return canvas.text();
}

}  // namespace dsc::cutlocus
