// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/certificate.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>

namespace dsc::cutlocus {

namespace {

int count_components(const CutGraph& graph) {
    std::vector<std::size_t> parent(graph.vertices.size());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto root = [&](std::size_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    int components = static_cast<int>(graph.vertices.size());
    for (const CutArc& arc : graph.arcs) {
        const std::size_t a = root(static_cast<std::size_t>(arc.start)), b = root(static_cast<std::size_t>(arc.end));
        if (a == b) continue;
        parent[a] = b;
        --components;
    }
    return components;
}

/// The sides of the arcs as intervals of directions, in order round the circle: the largest gap or overlap between one
/// and the next. Frontier vertices leave gaps on purpose.
double largest_direction_gap(const CutGraph& graph) {
    struct Side {
        double begin, end;
        bool ends_at_frontier;
    };
    std::vector<Side> sides;
    for (const CutArc& arc : graph.arcs) {
        const CutSample &first = arc.samples.front(), &last = arc.samples.back();
        const bool starts = graph.vertices[static_cast<std::size_t>(arc.start)].kind == VertexKind::frontier;
        const bool ends = graph.vertices[static_cast<std::size_t>(arc.end)].kind == VertexKind::frontier;
        const double begin1 = wrapped_angle(first.theta1), begin2 = wrapped_angle(last.theta2);
        sides.push_back({begin1, begin1 + (last.theta1 - first.theta1), ends});
        sides.push_back({begin2, begin2 + (first.theta2 - last.theta2), starts});
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.begin < b.begin; });
    double largest = 0;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        if (sides[i].ends_at_frontier) continue;
        const bool is_last = i + 1 == sides.size();
        const double next = is_last ? sides[0].begin + 2 * std::numbers::pi : sides[i + 1].begin;
        largest = std::max(largest, std::abs(next - sides[i].end));
    }
    return largest;
}

/// True if the end of an arc is a vertex: same place up to whole periods, and both directions arrive there.
bool ends_in(const geodesic::Metric& metric, const CutSample& end, const CutVertex& vertex, double tolerance) {
    if (metric.periods().wrapped(end.x - vertex.x).cwiseAbs().maxCoeff() > tolerance) return false;
    const auto arrives = [&](double theta) {
        return std::any_of(vertex.thetas.begin(), vertex.thetas.end(), [&](double arrival) {
            return std::abs(std::remainder(theta - arrival, 2 * std::numbers::pi)) <= tolerance;
        });
    };
    return arrives(end.theta1) && arrives(end.theta2);
}

std::string sentence(const char* format, double a, double b) {
    char text[160];
    std::snprintf(text, sizeof text, format, a, b);
    return text;
}

}  // namespace

void certify(const geodesic::Metric& metric, CutGraph& graph, const CertificateParameters& parameters) {
    Certificate& certificate = graph.certificate;
    certificate.failures.clear();
    for (const Doubt& doubt : graph.doubts)
        certificate.failures.push_back(sentence("near direction %.6f: ", doubt.theta, 0) + doubt.reason);
    certificate.components = count_components(graph);
    certificate.betti1 =
        static_cast<int>(graph.arcs.size()) - static_cast<int>(graph.vertices.size()) + certificate.components;
    certificate.direction_gap = largest_direction_gap(graph);
    if (certificate.direction_gap > parameters.direction_tolerance)
        certificate.failures.push_back(
            sentence("the sides of the arcs leave a gap or an overlap of %.3g rad (allowed %.3g) between directions",
                     certificate.direction_gap, parameters.direction_tolerance));
    for (const CutArc& arc : graph.arcs)
        if (!ends_in(metric, arc.samples.front(), graph.vertices[static_cast<std::size_t>(arc.start)],
                     parameters.end_tolerance) ||
            !ends_in(metric, arc.samples.back(), graph.vertices[static_cast<std::size_t>(arc.end)],
                     parameters.end_tolerance))
            certificate.failures.push_back(sentence("the arc from direction %.6f to %.6f does not end in its vertices",
                                                    arc.samples.front().theta1, arc.samples.back().theta1));
    if (!metric.periods().is_torus()) return;

    certificate.total_area = geodesic::total_area(metric);
    if (certificate.components != 1)
        certificate.failures.push_back(sentence("the graph has %.0f components, not %.0f", certificate.components, 1));
    if (certificate.betti1 != 2)
        certificate.failures.push_back(
            sentence("the graph has first Betti number %.0f, not %.0f", certificate.betti1, 2));
    if (!(std::abs(certificate.relative_area_error()) <= parameters.area_tolerance))
        certificate.failures.push_back(sentence("the area is missed by %.3g of itself (allowed %.3g)",
                                                certificate.relative_area_error(), parameters.area_tolerance));
}

}  // namespace dsc::cutlocus
