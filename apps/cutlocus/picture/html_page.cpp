// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/picture/html_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "apps/cutlocus/picture/chart_canvas.h"
#include "apps/cutlocus/picture/distance_circles.h"
#include "apps/cutlocus/picture/geodesic_fan.h"
#include "apps/cutlocus/picture/palette.h"
#include "apps/cutlocus/picture/svg_front.h"
#include "io/number.h"

namespace dsc::cutlocus {

using geodesic::Metric;
using geodesic::Point2;
using geodesic::Point3;

namespace {

std::string figure(double value, int digits = 10) { return io::number_text(value, digits); }

std::string vertex_label(const CutVertex& vertex, const geodesic::ChartPeriods& periods) {
    static constexpr std::array names{"end point", "branch point", "end of the search"};
    std::string text = std::string(names[static_cast<std::size_t>(vertex.kind)]) + ", degree " +
                       std::to_string(vertex.degree) + "\n(u, v) = " + point_text(periods.wrapped(vertex.x), periods) +
                       "\ndistance " + figure(vertex.distance) + "\ndirections";
    for (const double theta : vertex.thetas) text += " " + figure(theta, 7);
    return text;
}

std::string plural(std::ptrdiff_t count, const std::string& name) {
    return std::to_string(count) + " " + name + (count == 1 ? "" : "s");
}

std::vector<std::pair<std::string, std::string>> facts(const Metric& metric, const Point2& p, const CutGraph& graph) {
    const geodesic::ChartPeriods& periods = metric.periods();
    const Certificate& certificate = graph.certificate;
    const auto count = [&](VertexKind kind) {
        return std::count_if(graph.vertices.begin(), graph.vertices.end(),
                             [&](const CutVertex& vertex) { return vertex.kind == kind; });
    };
    const auto place = [&](const Extremum& extremum) {
        return figure(extremum.distance) + " at " + point_text(periods.wrapped(extremum.x), periods);
    };
    std::vector<std::pair<std::string, std::string>> table{
        {"p", point_text(p, periods)},
        {"length", figure(graph.length)},
        {"graph", plural(std::ssize(graph.arcs), "arc") + ", " + plural(count(VertexKind::branch), "branch point") +
                      ", " + plural(count(VertexKind::end), "end point")},
    };
    if (!graph.arcs.empty()) {
        table.push_back({"nearest", place(graph.nearest)});
        table.push_back({"farthest", place(graph.farthest)});
    }
    table.push_back({"certificate", certificate.holds() ? "holds" : "fails"});
    for (const std::string& failure : certificate.failures) table.push_back({"", failure});
    if (certificate.total_area) {
        table.push_back({"area", figure(*certificate.total_area)});
        table.push_back({"area error", figure(certificate.relative_area_error(), 3) + " of it"});
    }
    table.push_back({"components", std::to_string(certificate.components)});
    table.push_back({"Betti number", std::to_string(certificate.betti1)});
    table.push_back({"direction gap", figure(certificate.direction_gap, 3)});
    table.push_back({"residual", figure(certificate.residual, 3)});
    return table;
}

/// Takes places of the universal cover to places of a view, rounded to what can be seen.
class Stage {
public:
    Stage(const Metric& metric, const ChartBox& box, bool is_flat, double scale)
        : metric_(metric), box_(box), is_flat_(is_flat), grain_(round_step(1e-5 * scale)) {}

    /// In one run, interrupted at the seams of the chart.
    io::ViewLine run(const Polyline& points) const { return line(is_flat_ ? box_.wrapped(points) : points); }
    std::vector<io::ViewLine> lines(const std::vector<Polyline>& points) const {
        std::vector<io::ViewLine> result;
        for (const Polyline& whole : points) {
            if (!is_flat_) result.push_back(line(whole));
            if (is_flat_)
                for (const Polyline& piece : box_.pieces(whole)) result.push_back(line(piece));
        }
        return result;
    }
    Point3 point(const Point2& x) const { return place(is_flat_ ? box_.places(x).front() : x); }

private:
    io::ViewLine line(const Polyline& points) const {
        io::ViewLine result;
        for (const Point2& x : points) result.push_back(place(x));
        return result;
    }
    Point3 place(const Point2& x) const {
        const Point3 exact = is_flat_ ? Point3(x.x(), x.y(), 0) : metric_.position(x).value_or(Point3::Zero());
        return (exact / grain_).array().round() * grain_;
    }

    const Metric& metric_;
    const ChartBox& box_;
    bool is_flat_;
    double grain_;
};

/// The box of the chart as a grid in space, closed where the chart is periodic.
io::ViewSurface surface(const Metric& metric, const ChartBox& box) {
    constexpr std::uint32_t columns = 160, rows = 100;
    const geodesic::Vector2 size = box.upper() - box.lower();
    const bool closes_u = metric.periods().u.has_value(), closes_v = metric.periods().v.has_value();
    const std::uint32_t width = columns + (closes_u ? 0 : 1), height = rows + (closes_v ? 0 : 1);
    io::ViewSurface result{.name = "surface", .opacity = 0.85};
    for (std::uint32_t k = 0; k < height; ++k)
        for (std::uint32_t i = 0; i < width; ++i)
            result.vertices.push_back(
                *metric.position(box.lower() + Point2(size.x() * i / columns, size.y() * k / rows)));
    const auto at = [&](std::uint32_t i, std::uint32_t k) { return (k % height) * width + i % width; };
    for (std::uint32_t k = 0; k < rows; ++k) {
        for (std::uint32_t i = 0; i < columns; ++i) {
            result.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
            result.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
        }
    }
    return result;
}

io::ViewSurface rectangle(const ChartBox& box) {
    const Point2 a = box.lower(), b = box.upper();
    return {.name = "chart",
            .vertices = {{a.x(), a.y(), 0}, {b.x(), a.y(), 0}, {b.x(), b.y(), 0}, {a.x(), b.y(), 0}},
            .triangles = {{0, 1, 2}, {0, 2, 3}},
            .colour = "#f4f6f8"};
}

/// Everything that is shown, in the universal cover.
class Scene {
public:
    Scene(const Metric& metric, const Point2& p, const CutLocus& locus)
        : metric_(metric),
          p_(p),
          locus_(locus),
          cut_(locus),
          scale_(cut_.limit()),
          table_(geodesic_fan(metric, p, cut_,
                              {.directions = 64, .step = scale_ / 64, .largest_gap = scale_ / 80, .max_rays = 1000})),
          box_(metric.periods(), Point2(0, 0), table_lines(table_)) {
        const std::vector<FanRay> drawn =
            geodesic_fan(metric, p, cut_, {.directions = 72, .step = scale_ / 64, .largest_gap = 100 * scale_});
        geodesics_ = lines_of(drawn);
        for (const double radius : round_radii(locus.graph.arcs.empty() ? scale_ : locus.graph.farthest.distance, 22))
            for (const Polyline& line : distance_circle(table_, locus.graph, metric.periods(), radius))
                circles_.push_back(fine(line));
        for (const CutArc& arc : locus.graph.arcs) {
            Polyline line;
            for (const CutSample& sample : arc.samples) line.push_back(sample.x);
            arcs_.push_back(fine(line));
        }
        for (const FrontSnapshot& snapshot : locus.front.snapshots)
            fronts_.push_back(fine(front_line(snapshot, metric.periods())));
    }

    io::HtmlView view(bool is_flat) const {
        const double size = is_flat ? (box_.upper() - box_.lower()).minCoeff() : scale_;
        const Stage stage(metric_, box_, is_flat, size);
        io::HtmlView view{.name = is_flat ? "chart" : "surface", .is_flat = is_flat};
        view.surfaces.push_back(is_flat ? rectangle(box_) : surface(metric_, box_));
        view.lines.push_back({"cut locus", stage.lines(arcs_), palette::locus_colour, 3.5});
        view.lines.push_back({"distance circles", stage.lines(circles_), palette::circle_colour, 1});
        view.lines.push_back({"geodesics", stage.lines(geodesics_), "#777777", 1, false});
        add_points(stage, view);
        if (!fronts_.empty()) {
            io::ViewSeries series{.name = "front", .colour = palette::front_colour, .width = 2.5};
            for (std::size_t i = 0; i < fronts_.size(); ++i) {
                series.times.push_back(locus_.front.snapshots[i].t);
                series.frames.push_back(stage.lines({fronts_[i]}));
            }
            view.series.push_back(std::move(series));
        }
        view.fan = fan(stage);
        return view;
    }

private:
    static std::vector<Polyline> table_lines(const std::vector<FanRay>& fan) {
        std::vector<Polyline> lines;
        for (const FanRay& ray : fan) lines.push_back(ray.line(0, ray.length, ray.step));
        return lines;
    }
    std::vector<Polyline> lines_of(const std::vector<FanRay>& fan) const {
        std::vector<Polyline> lines;
        for (const FanRay& ray : fan) lines.push_back(fine(ray.line(0, ray.length, scale_ / 200)));
        return lines;
    }
    /// As many points as the eye needs on a screen, in the chart.
    Polyline fine(const Polyline& line) const {
        const double side = (box_.upper() - box_.lower()).maxCoeff();
        return thinned(line, 2e-4 * side, side / 48);
    }

    void add_points(const Stage& stage, io::HtmlView& view) const {
        view.points.push_back({"p", {stage.point(p_)}, {"p = " + point_text(p_, metric_.periods())}, "#000000", 12});
        const auto add = [&](VertexKind kind, const char* name, const char* colour) {
            io::ViewPoints points{.name = name, .colour = colour, .size = 9};
            for (const CutVertex& vertex : locus_.graph.vertices) {
                if (vertex.kind != kind) continue;
                points.positions.push_back(stage.point(vertex.x));
                points.labels.push_back(vertex_label(vertex, metric_.periods()));
            }
            if (!points.positions.empty()) view.points.push_back(std::move(points));
        };
        add(VertexKind::branch, "branch points", palette::vertex_colour);
        add(VertexKind::end, "end points", "#f28482");
        add(VertexKind::frontier, "end of the search", "#888888");
    }

    /// The table of geodesics that a click looks up.
    io::ViewFan fan(const Stage& stage) const {
        io::ViewFan fan{.name = "geodesic to a place"};
        for (const FanRay& ray : table_) {
            Polyline points;
            std::vector<double> distances;
            for (const geodesic::GeodesicState& state : ray.states) {
                points.push_back(state.x);
                distances.push_back(std::round(1e6 * state.t) / 1e6);
            }
            const io::ViewLine line = stage.run(points);
            // At a seam the line has three points more: leaving, none, entering.
            std::vector<double> values;
            std::size_t i = 0;
            for (std::size_t k = 0; k < line.size(); ++k) {
                const bool is_at_seam = (k + 1 < line.size() && !line[k + 1].allFinite()) || !line[k].allFinite() ||
                                        (k > 0 && !line[k - 1].allFinite());
                values.push_back(distances[std::min(i, distances.size() - 1)]);
                if (!is_at_seam) ++i;
            }
            fan.rays.push_back(line);
            fan.values.push_back(std::move(values));
            const double degrees = ray.theta * 180 / std::numbers::pi;
            fan.labels.push_back("direction " + figure(std::round(1e6 * ray.theta) / 1e6, 7) + " (" +
                                 figure(std::round(100 * degrees) / 100, 5) + "°)");
        }
        return fan;
    }

    const Metric& metric_;
    Point2 p_;
    const CutLocus& locus_;
    CutDistance cut_;
    double scale_;
    std::vector<FanRay> table_;
    ChartBox box_;
    std::vector<Polyline> geodesics_, circles_, arcs_, fronts_;
};

/// What the page does at first: the slider stands where the front has begun to stop, and p is seen at the side, so that
/// the cut locus, which tends to lie opposite, is seen too.
std::string opening(const Metric& metric, const Point2& p, const io::HtmlPage& page) {
    std::string script = "const count = " + std::to_string(page.views.size()) + R"(;
for (let i = count - 1; i >= 0; --i) {
  dscView.show(i);
  const slider = document.querySelector('#time input');
  if (!slider) continue;
  slider.value = Math.round(0.6 * slider.max);
  slider.oninput();
}
)";
    const std::optional<Point3> place = metric.position(p);
    if (!place) return script;
    Point3 lower = page.views.front().surfaces.front().vertices.front(), upper = lower;
    for (const Point3& x : page.views.front().surfaces.front().vertices) {
        lower = lower.cwiseMin(x);
        upper = upper.cwiseMax(x);
    }
    const Point3 center = (lower + upper) / 2, way = *place - center;
    const double azimuth = std::atan2(way.y(), way.x()) - std::numbers::pi / 2;
    script += "const center = new THREE.Vector3(" + figure(center.x()) + ", " + figure(center.y()) + ", " +
              figure(center.z()) + "), azimuth = " + figure(azimuth) + R"(;
const camera = dscView.camera();
const offset = camera.position.clone().sub(center);
const reach = Math.hypot(offset.x, offset.y);
camera.position.set(reach * Math.cos(azimuth), reach * Math.sin(azimuth), offset.z).add(center);
camera.lookAt(center);
dscView.draw();
)";
    return script;
}

}  // namespace

io::HtmlPage html_page(const Metric& metric, const Point2& p, const CutLocus& locus, const ChartStyle& style) {
    const Scene scene(metric, p, locus);
    io::HtmlPage page;
    page.title = "Cut locus of p = " + point_text(p, metric.periods());
    page.facts = facts(metric, p, locus.graph);
    if (!style.surface.empty()) page.facts.insert(page.facts.begin(), {"surface", style.surface});
    if (metric.position(p)) page.views.push_back(scene.view(false));
    page.views.push_back(scene.view(true));
    page.time_name = "distance";
    page.script = opening(metric, p, page);
    return page;
}

void write_html(const std::filesystem::path& path, const Metric& metric, const Point2& p, const CutLocus& locus,
                const ChartStyle& style) {
    io::write_html_page(path, html_page(metric, p, locus, style));
}

}  // namespace dsc::cutlocus
