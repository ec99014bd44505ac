// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/picture/svg_chart.h"

#include <algorithm>

#include "apps/cutlocus/picture/distance_circles.h"
#include "apps/cutlocus/picture/geodesic_fan.h"
#include "apps/cutlocus/picture/palette.h"
#include "io/number.h"

namespace dsc::cutlocus {

using geodesic::Metric;
using geodesic::Point2;

namespace {

std::vector<Polyline> lines_of(const std::vector<FanRay>& fan, double spacing) {
    std::vector<Polyline> lines;
    for (const FanRay& ray : fan) lines.push_back(ray.line(0, ray.length, spacing));
    return lines;
}

/// The rays that were put in where others had drifted apart, from there on; stubs are left out.
std::vector<Polyline> even_lines_of(const std::vector<FanRay>& fan, double spacing) {
    constexpr double shortest = 12;  // spacings
    std::vector<Polyline> lines;
    for (const FanRay& ray : fan)
        if (ray.apart_at == 0 || ray.length - ray.apart_at > shortest * spacing)
            lines.push_back(ray.line(ray.apart_at, ray.length, spacing));
    return lines;
}

std::vector<Polyline> lines_of(const CutGraph& graph) {
    std::vector<Polyline> lines;
    for (const CutArc& arc : graph.arcs) {
        Polyline& line = lines.emplace_back();
        for (const CutSample& sample : arc.samples) line.push_back(sample.x);
    }
    return lines;
}

std::vector<Point2> places_of(const CutGraph& graph, VertexKind kind) {
    std::vector<Point2> places;
    for (const CutVertex& vertex : graph.vertices)
        if (vertex.kind == kind) places.push_back(vertex.x);
    return places;
}

std::string circles_name(const std::vector<double>& radii) {
    return radii.empty() ? "distance circles" : "distance circles, " + io::number_text(radii.front(), 6) + " apart";
}

void draw_vertices(ChartCanvas& canvas, const CutGraph& graph, const Point2& p) {
    canvas.marks("p", palette::generator, {p});
    canvas.legend_mark("p", palette::generator);
    const auto draw = [&](VertexKind kind, const MarkStyle& style, const char* name) {
        const std::vector<Point2> places = places_of(graph, kind);
        if (places.empty()) return;
        canvas.marks(name, style, places);
        canvas.legend_mark(name, style);
    };
    draw(VertexKind::branch, palette::branch, "branch point");
    draw(VertexKind::end, palette::end, "end point");
    draw(VertexKind::frontier, palette::frontier, "end of the search");
}

}  // namespace

std::string chart_title(const std::string& what, const Metric& metric, const Point2& p, const ChartStyle& style) {
    if (!style.has_title) return {};
    constexpr std::size_t longest = 60;
    const bool has_surface = !style.surface.empty() && style.surface.size() <= longest;
    return what + point_text(p, metric.periods()) + (has_surface ? ", " + style.surface : "");
}

std::string svg_chart(const Metric& metric, const Point2& p, const CutLocus& locus, const ChartStyle& style) {
    const CutDistance cut(locus);
    const double scale = cut.limit();
    const double spacing = scale / 400;
    const std::vector<FanRay> drawn =
        geodesic_fan(metric, p, cut, {.directions = style.geodesics, .step = scale / 64, .largest_gap = scale / 18});
    const std::vector<FanRay> dense =
        geodesic_fan(metric, p, cut, {.directions = 360, .step = scale / 64, .largest_gap = scale / 150});
    const std::vector<double> radii =
        round_radii(locus.graph.arcs.empty() ? scale : locus.graph.farthest.distance, style.circles);
    std::vector<Polyline> circles;
    for (const double radius : radii)
        for (Polyline& line : distance_circle(dense, locus.graph, metric.periods(), radius))
            circles.push_back(std::move(line));

    const std::vector<Polyline> rays = even_lines_of(drawn, spacing);
    ChartCanvas canvas(ChartBox(metric.periods(), Point2(0, 0), lines_of(dense, scale)),
                       {.width = style.width, .title = chart_title("Cut locus of p = ", metric, p, style)});
    canvas.begin_chart(0);
    canvas.lines("geodesics", palette::geodesics, rays);
    canvas.lines("distance circles", palette::circles, circles);
    canvas.lines("cut locus", palette::locus, lines_of(locus.graph));
    if (!locus.graph.arcs.empty()) canvas.legend_line("cut locus", palette::locus);
    canvas.legend_line("geodesics", palette::geodesics);
    canvas.legend_line(circles_name(radii), palette::circles);
    draw_vertices(canvas, locus.graph, p);
    return canvas.text();
}

std::string svg_geodesics(const Metric& metric, const Point2& p, const CutLocus& locus, const ChartStyle& style) {
    const CutDistance cut(locus);
    const double scale = cut.limit();
    const double length = 1.6 * scale;
    const std::vector<FanRay> drawn =
        geodesic_fan(metric, p, cut,
                     {.directions = style.geodesics, .step = scale / 64, .largest_gap = 2 * length, .length = length});
    const std::vector<FanRay> dense = geodesic_fan(
        metric, p, cut,
        {.directions = 720, .step = scale / 64, .largest_gap = scale / 100, .max_rays = 2000, .length = length});
    const std::vector<double> radii = round_radii(1.1 * scale, style.circles);
    std::vector<Polyline> circles;
    for (const double radius : radii) circles.push_back(geodesic_circle(dense, radius));
    const std::vector<Polyline> conjugates = conjugate_locus(dense);

    ChartCanvas canvas(ChartBox(metric.periods(), p, lines_of(dense, scale)),
                       {.width = style.width, .title = chart_title("Geodesics from p = ", metric, p, style)});
    canvas.begin_chart(0);
    canvas.lines("geodesics", palette::geodesics, lines_of(drawn, scale / 400), false);
    canvas.lines("distance circles", palette::circles, circles, false);
    canvas.lines("conjugate locus", palette::conjugates, conjugates, false);
    canvas.marks("p", palette::generator, {p});
    canvas.legend_line("geodesics", palette::geodesics);
    canvas.legend_line(circles_name(radii), palette::circles);
    canvas.legend_line("first conjugate points", palette::conjugates);
    canvas.legend_mark("p", palette::generator);
    return canvas.text();
}

}  // namespace dsc::cutlocus
