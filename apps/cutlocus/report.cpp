// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/report.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "io/csv.h"

namespace dsc::cutlocus {

using geodesic::GeodesicState;
using geodesic::Metric;
using io::Json;

namespace {

const char* name_of(VertexKind kind) {
    switch (kind) {
        case VertexKind::end: return "end";
        case VertexKind::branch: return "branch";
        case VertexKind::frontier: break;
    }
    return "frontier";
}

double centred(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

Json json_of(const Point2& point) { return Json::array({point.x(), point.y()}); }
Json json_of(const LatticeVector& lattice) { return Json::array({lattice.x(), lattice.y()}); }

Json contacts_json(const Metric& metric, const FrontResult& front) {
    Json contacts = Json::array();
    for (const FrontContact& contact : front.contacts) {
        const Point2 place = metric.periods().wrapped(contact.place1);
        contacts.push_back(Json::object({{"u", place.x()},
                                         {"v", place.y()},
                                         {"distance", contact.pair.t},
                                         {"theta", centred(contact.pair.theta1)},
                                         {"theta2", centred(contact.pair.theta2)},
                                         {"lattice", json_of(contact.pair.lattice)}}));
    }
    return contacts;
}

Json vertices_json(const Metric& metric, const CutGraph& graph) {
    Json vertices = Json::array();
    for (std::size_t i = 0; i < graph.vertices.size(); ++i) {
        const CutVertex& vertex = graph.vertices[i];
        const Point2 place = metric.periods().wrapped(vertex.x);
        vertices.push_back(Json::object({{"id", i},
                                         {"kind", name_of(vertex.kind)},
                                         {"degree", vertex.degree},
                                         {"u", place.x()},
                                         {"v", place.y()},
                                         {"distance", vertex.distance},
                                         {"thetas", Json(vertex.thetas)},
                                         {"conjugate", vertex.kind == VertexKind::end},
                                         {"residual", vertex.residual}}));
    }
    return vertices;
}

Json arcs_json(const CutGraph& graph) {
    Json arcs = Json::array();
    for (std::size_t i = 0; i < graph.arcs.size(); ++i) {
        const CutArc& arc = graph.arcs[i];
        arcs.push_back(Json::object({{"id", i},
                                     {"start", arc.start},
                                     {"end", arc.end},
                                     {"lattice", json_of(arc.lattice)},
                                     {"length", arc.length},
                                     {"points", arc.samples.size()},
                                     {"announced", arc.is_announced}}));
    }
    return arcs;
}

Json failures_json(const Certificate& certificate) {
    Json failures = Json::array();
    for (const std::string& failure : certificate.failures) failures.push_back(failure);
    return failures;
}

Json header_json(const Question& question) {
    return Json::object({{"metric", question.metric_name},
                         {"metric_params", question.metric_parameters},
                         {"p", json_of(question.point)},
                         {"frame", "theta from d/du towards d/dv, metric angle in the orthonormal frame at p"}});
}

std::string text_of(const Point2& point) {
    // Rounded first, so that no "-0.000000000" appears.
    const auto rounded = [](double value) { return std::round(value * 1e9) / 1e9 + 0.0; };
    return fmt::format("({:.9f}, {:.9f})", rounded(point.x()), rounded(point.y()));
}

}  // namespace

void write_locus_csv(const std::string& path, const Metric& metric, const CutGraph& graph) {
    io::CsvWriter table(path, {"u", "v", "distance", "theta", "theta2", "arc"});
    for (std::size_t i = 0; i < graph.arcs.size(); ++i)
        for (const CutSample& sample : graph.arcs[i].samples) {
            const Point2 place = metric.periods().wrapped(sample.x);
            table.row({place.x(), place.y(), sample.distance, centred(sample.theta1), centred(sample.theta2),
                       static_cast<double>(i)});
        }
    table.commit();
}

void write_stops_csv(const std::string& path, const Metric& metric, const FrontResult& front) {
    io::CsvWriter table(path, {"u", "v", "distance", "theta", "theta2", "arc"});
    for (const FrontContact& contact : front.contacts) {
        const Point2 across = contact.place2 + metric.periods().translation(contact.pair.lattice);
        const Point2 place = metric.periods().wrapped((contact.place1 + across) / 2);
        table.row(
            {place.x(), place.y(), contact.pair.t, centred(contact.pair.theta1), centred(contact.pair.theta2), -1});
    }
    for (const LocalStop& stop : front.local_stops) {
        const Point2 place = metric.periods().wrapped(stop.place);
        table.row({place.x(), place.y(), stop.t, centred(stop.theta), centred(stop.theta), -1});
    }
    table.commit();
}

Json locus_json(const Metric& metric, const Question& question, const CutLocus& locus, double seconds) {
    const CutGraph& graph = locus.graph;
    const Certificate& certificate = graph.certificate;
    std::size_t points = 0;
    for (const CutArc& arc : graph.arcs) points += arc.samples.size();
    Json report = header_json(question);
    report["betti1"] = certificate.betti1;
    report["components"] = certificate.components;
    report["n_vertices"] = graph.vertices.size();
    report["n_arcs"] = graph.arcs.size();
    report["area_injectivity_domain"] = certificate.sector_area;
    if (certificate.total_area) {
        report["area_surface"] = *certificate.total_area;
        report["area_rel_err"] = certificate.relative_area_error();
    }
    report["length"] = graph.length;
    if (!graph.arcs.empty()) {
        report["min_distance"] = graph.nearest.distance;
        report["min_at"] = json_of(metric.periods().wrapped(graph.nearest.x));
        report["max_distance"] = graph.farthest.distance;
        report["max_at"] = json_of(metric.periods().wrapped(graph.farthest.x));
    }
    report["points"] = points;
    report["seconds"] = seconds;
    report["certificate"] = Json::object({{"holds", certificate.holds()},
                                          {"failures", failures_json(certificate)},
                                          {"worst_residual", certificate.residual},
                                          {"smallest_j", certificate.smallest_j},
                                          {"direction_gap", certificate.direction_gap}});
    report["vertices"] = vertices_json(metric, graph);
    report["arcs"] = arcs_json(graph);
    report["front"] = Json::object({{"spacing", locus.front_spacing},
                                    {"refinements", locus.refinements},
                                    {"steps", locus.front.steps},
                                    {"vertices", locus.front.vertices},
                                    {"seconds", locus.front_seconds},
                                    {"exact_seconds", locus.exact_seconds}});
    report["contacts"] = contacts_json(metric, locus.front);
    return report;
}

Json front_json(const Metric& metric, const Question& question, const FrontResult& front, double seconds) {
    Json report = header_json(question);
    report["method"] = "front";
    report["steps"] = front.steps;
    report["front_vertices"] = front.vertices;
    report["distance"] = front.distance;
    report["seconds"] = seconds;
    report["contacts"] = contacts_json(metric, front);
    return report;
}

Json distance_json(const Point2& target, const std::vector<GeodesicState>& geodesics) {
    std::vector<double> thetas;
    for (const GeodesicState& state : geodesics) thetas.push_back(state.theta);
    return Json::object({{"point", json_of(target)}, {"distance", geodesics.front().t}, {"thetas", Json(thetas)}});
}

std::string locus_summary(const Metric& metric, const Question& question, const CutLocus& locus, double seconds) {
    const CutGraph& graph = locus.graph;
    const Certificate& certificate = graph.certificate;
    std::string text = fmt::format("cut locus of p = {} on {}\n", text_of(question.point), question.metric_name);
    text +=
        fmt::format("{} vertices, {} arcs, length {:.9f}\n", graph.vertices.size(), graph.arcs.size(), graph.length);
    for (std::size_t i = 0; i < graph.vertices.size(); ++i) {
        const CutVertex& vertex = graph.vertices[i];
        text += fmt::format("  vertex {:<3} {:<8} degree {}  at {}  distance {:.9f}\n", i, name_of(vertex.kind),
                            vertex.degree, text_of(metric.periods().wrapped(vertex.x)), vertex.distance);
    }
    for (std::size_t i = 0; i < graph.arcs.size(); ++i) {
        const CutArc& arc = graph.arcs[i];
        text += fmt::format("  arc    {:<3} from {} to {}  lattice ({}, {})  length {:.9f}{}\n", i, arc.start, arc.end,
                            arc.lattice.x(), arc.lattice.y(), arc.length,
                            arc.is_announced ? "" : "  (announced by no contact)");
    }
    if (!graph.arcs.empty())
        text += fmt::format("nearest {:.9f} at {}, farthest {:.9f} at {}\n", graph.nearest.distance,
                            text_of(metric.periods().wrapped(graph.nearest.x)), graph.farthest.distance,
                            text_of(metric.periods().wrapped(graph.farthest.x)));
    text += certificate.holds() ? "certificate holds: " : "certificate FAILS: ";
    text += fmt::format("{} component{}, first Betti number {}, ", certificate.components,
                        certificate.components == 1 ? "" : "s", certificate.betti1);
    if (certificate.total_area)
        text += fmt::format("area {:.9f} (relative error {:.1e}), ", certificate.sector_area,
                            certificate.relative_area_error());
    text += fmt::format("residual {:.1e}\n", certificate.residual);
    for (const std::string& failure : certificate.failures) text += "  " + failure + "\n";
    text += fmt::format("{:.2f} s: front {:.2f} s ({} contacts), exact {:.2f} s\n", seconds, locus.front_seconds,
                        locus.front.contacts.size(), locus.exact_seconds);
    return text;
}

std::string front_summary(const Question& question, const FrontResult& front, double seconds) {
    return fmt::format(
        "front of p = {} on {}\n{} contacts, {} steps, {} vertices, stopped at distance {:.6f}\n{:.2f} s\n",
        text_of(question.point), question.metric_name, front.contacts.size(), front.steps, front.vertices,
        front.distance, seconds);
}

std::string distance_summary(const Point2& target, const std::vector<GeodesicState>& geodesics) {
    std::string text = fmt::format("distance to {}: {:.12f}, {} minimising geodesic{}\n", text_of(target),
                                   geodesics.front().t, geodesics.size(), geodesics.size() == 1 ? "" : "s");
    for (const GeodesicState& state : geodesics) text += fmt::format("  direction {:.12f}\n", state.theta);
    return text;
}

}  // namespace dsc::cutlocus
