// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/distance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/errors.h"
#include "geodesic/connect.h"

namespace dsc::cutlocus {

using geodesic::GeodesicFlow;
using geodesic::GeodesicState;
using geodesic::Metric;

namespace {

/// A place near the target on a geodesic inside the cut locus.
struct Candidate {
    double theta, t, gap;
    Point2 target;  // in the period of that geodesic's end
};

/// The target in the period nearest to x.
Point2 near(const Metric& metric, const Point2& target, const Point2& x) {
    return x + metric.periods().wrapped(target - x);
}

/// The places nearest to the target on geodesics in directions between which the cut locus is finely sampled.
std::vector<Candidate> candidates(const Metric& metric, const Point2& p, const CutGraph& graph, const Point2& target) {
    constexpr int directions_per_arc_side = 200, stops = 100;
    GeodesicFlow flow(metric, p, 1e-6);
    std::vector<Candidate> found;
    const auto search = [&](double theta, double cut) {
        GeodesicState state = flow.start(theta);
        Candidate best{theta, 0, std::numeric_limits<double>::infinity(), p};
        for (int i = 0; i <= stops; ++i) {
            if (i > 0) flow.advance(state, cut / stops);
            const Point2 place = near(metric, target, state.x);
            const double gap = metric.tensor(place).norm(place - state.x);
            if (gap < best.gap) best = {theta, state.t, gap, place};
        }
        found.push_back(best);
    };
    for (const CutArc& arc : graph.arcs) {
        const std::size_t stride = std::max<std::size_t>(1, arc.samples.size() / directions_per_arc_side);
        for (std::size_t i = 0; i < arc.samples.size(); i += stride) {
            search(arc.samples[i].theta1, arc.samples[i].distance);
            search(arc.samples[i].theta2, arc.samples[i].distance);
        }
    }
    std::sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) { return a.gap < b.gap; });
    return found;
}

}  // namespace

std::vector<GeodesicState> minimising_geodesics(const Metric& metric, const Point2& p, const CutGraph& graph,
                                                const Point2& target, double tolerance) {
    constexpr std::size_t tried = 200;  // the nearest candidates
    GeodesicFlow flow(metric, p, 1e-2 * tolerance);
    std::vector<GeodesicState> geodesics;
    if (near(metric, target, p) == p) return {flow.start(0)};
    const std::vector<Candidate> places = candidates(metric, p, graph, target);
    for (std::size_t i = 0; i < std::min(tried, places.size()); ++i) {
        const auto state =
            geodesic::connect(flow, places[i].target, places[i].theta, std::max(places[i].t, tolerance),
                              {.tolerance = 1e-2 * tolerance, .largest_step = 0.25 * graph.farthest.distance});
        if (!state) continue;
        const bool is_known = std::any_of(geodesics.begin(), geodesics.end(), [&](const GeodesicState& known) {
            const double turned = std::abs(std::remainder(known.theta - state->theta, 2 * std::numbers::pi));
            return turned * std::max(1.0, std::abs(state->j)) < std::sqrt(tolerance);
        });
        if (!is_known) geodesics.push_back(*state);
    }
    if (geodesics.empty()) throw core::RunError("no geodesic to the point of --distance was found");
    const double shortest =
        std::min_element(geodesics.begin(), geodesics.end(), [](const auto& a, const auto& b) { return a.t < b.t; })->t;
    std::erase_if(geodesics, [&](const GeodesicState& state) { return state.t > shortest + 10 * tolerance; });
    for (GeodesicState& state : geodesics) state.theta = std::remainder(state.theta, 2 * std::numbers::pi);
    std::sort(geodesics.begin(), geodesics.end(), [](const auto& a, const auto& b) { return a.theta < b.theta; });
    return geodesics;
}

}  // namespace dsc::cutlocus
