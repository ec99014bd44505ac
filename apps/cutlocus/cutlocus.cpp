// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/cutlocus.h"

#include <cmath>

#include "apps/cutlocus/certificate.h"
#include "apps/cutlocus/exact_graph.h"
#include "core/errors.h"
#include "core/stopwatch.h"
#include "geodesic/scaled_metric.h"

namespace dsc::cutlocus {

using geodesic::Metric;
using geodesic::Point2;

namespace {

/// The unit of length in which the computation runs, a power of two: the surface then has about the size for which the
/// parameters of the algorithms below are made, whatever the unit it is given in.
double unit_of_length(double size) {
    constexpr double usual_size = 10;
    return std::exp2(std::round(std::log2(size / usual_size)));
}

void add_exact_graph(const Metric& metric, const Point2& p, const CutLocusParameters& parameters,
                     core::Observer& observer, CutLocus& locus) {
    std::vector<DirectionPair> pairs;
    for (const FrontContact& contact : locus.front.contacts) pairs.push_back(contact.pair);
    ExactParameters exact;
    exact.spacing = parameters.spacing;
    exact.tolerance = parameters.tolerance;
    exact.max_distance = parameters.max_distance;
    exact.largest_shift = parameters.largest_shift * locus.front_spacing;
    exact.threads = parameters.threads;
    locus.graph = exact_graph(metric, p, pairs, locus.front.free_directions, exact, observer);
    // The boundary of the disc of directions is off by the tolerance at most.
    CertificateParameters certificate;
    certificate.area_tolerance = std::max(certificate.area_tolerance, parameters.tolerance);
    certify(metric, locus.graph, certificate);
}

/// The result in the unit in which the surface was given.
void multiply_lengths(CutLocus& locus, double unit) {
    CutGraph& graph = locus.graph;
    for (CutVertex& vertex : graph.vertices) vertex.distance *= unit, vertex.residual *= unit;
    for (CutArc& arc : graph.arcs) {
        arc.length *= unit;
        for (CutSample& sample : arc.samples) sample.distance *= unit;
    }
    graph.length *= unit;
    graph.nearest.distance *= unit;
    graph.farthest.distance *= unit;
    Certificate& certificate = graph.certificate;
    certificate.sector_area *= unit * unit;
    if (certificate.total_area) *certificate.total_area *= unit * unit;
    certificate.residual *= unit;
    certificate.smallest_j *= unit;
    for (FrontContact& contact : locus.front.contacts) contact.pair.t *= unit;
    for (LocalStop& stop : locus.front.local_stops) stop.t *= unit;
    for (FrontSnapshot& snapshot : locus.front.snapshots) snapshot.t *= unit;
    locus.front.distance *= unit;
    locus.front_spacing *= unit;
}

CutLocus cut_locus_in_unit(const Metric& metric, const Point2& p, double size, const CutLocusParameters& parameters,
                           core::Observer& observer) {
    CutLocus locus;
    for (int refinement = 0;; ++refinement) {
        const core::Stopwatch front_watch;
        FrontParameters front;
        front.spacing = std::ldexp(parameters.front_spacing * size, -refinement);
        front.time_step = front.spacing / 2;
        front.max_distance = parameters.max_distance;
        front.snapshots = parameters.snapshots;
        locus.front = grow_front(metric, p, front, observer);
        locus.front_seconds += front_watch.seconds();
        locus.front_spacing = front.spacing;
        locus.refinements = refinement;

        const core::Stopwatch exact_watch;
        add_exact_graph(metric, p, parameters, observer, locus);
        locus.exact_seconds += exact_watch.seconds();
        if (locus.graph.certificate.holds() || refinement == parameters.max_refinements) return locus;
    }
}

}  // namespace

void CutLocusParameters::validate() const {
    const auto require = [](bool is_valid, const char* message) {
        if (!is_valid) throw core::UsageError(message);
    };
    require(tolerance >= 1e-11 && tolerance <= 1e-3, "--tolerance must lie between 1e-11 and 1e-3");
    require(spacing > 0 && std::isfinite(spacing), "--spacing must be positive");
    require(!max_distance || (*max_distance > 0 && std::isfinite(*max_distance)), "--max-distance must be positive");
    require(front_spacing >= 1e-4 && front_spacing <= 0.1, "--front-spacing must lie between 1e-4 and 0.1");
    require(max_refinements >= 0, "--max-refinements must not be negative");
}

CutLocus cut_locus(const Metric& metric, const Point2& p, const CutLocusParameters& parameters,
                   core::Observer& observer) {
    parameters.validate();
    if (!metric.periods().is_torus() && !parameters.max_distance)
        throw core::UsageError("a chart that is not periodic in both directions needs --max-distance");
    const double size =
        metric.periods().is_torus() ? std::sqrt(geodesic::total_area(metric)) : *parameters.max_distance;
    const double unit = unit_of_length(size);
    CutLocusParameters in_unit = parameters;
    in_unit.tolerance /= unit;
    in_unit.spacing /= unit;
    if (in_unit.max_distance) *in_unit.max_distance /= unit;
    constexpr double smallest_spacing = 1e-5;  // millions of points on an arc
    if (in_unit.spacing < smallest_spacing)
        throw core::UsageError("--spacing is too small for a surface of this size: at least " +
                               std::to_string(smallest_spacing * unit));
    const geodesic::ScaledMetric scaled(metric, 1 / unit);
    CutLocus locus = cut_locus_in_unit(scaled, p, size / unit, in_unit, observer);
    multiply_lengths(locus, unit);
    return locus;
}

}  // namespace dsc::cutlocus
