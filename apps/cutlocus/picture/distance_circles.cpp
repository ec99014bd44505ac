// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/picture/distance_circles.h"

#include <algorithm>
#include <cmath>

namespace dsc::cutlocus {

using geodesic::ChartPeriods;
using geodesic::GeodesicState;
using geodesic::Point2;
using geodesic::Vector2;

namespace {

enum class EventKind { begins, passes, ends };

/// On the way round the circle of directions: a ray that reaches the radius, or the crossing of the circle and an arc.
struct Event {
    double theta = 0;
    EventKind kind = EventKind::passes;
    Point2 x{0, 0};
};

void add_crossings(const CutArc& arc, const ChartPeriods& periods, double radius, std::vector<Event>& events) {
    const Vector2 translation = periods.translation(arc.lattice);
    for (std::size_t i = 1; i < arc.samples.size(); ++i) {
        const CutSample &a = arc.samples[i - 1], &b = arc.samples[i];
        if ((a.distance > radius) == (b.distance > radius)) continue;
        const double s = (radius - a.distance) / (b.distance - a.distance);
        const Point2 x = (1 - s) * a.x + s * b.x;
        const bool rises = b.distance > radius;
        // theta1 ascends along the arc, theta2 descends.
        events.push_back(
            {wrapped_angle((1 - s) * a.theta1 + s * b.theta1), rises ? EventKind::begins : EventKind::ends, x});
        events.push_back({wrapped_angle((1 - s) * a.theta2 + s * b.theta2), rises ? EventKind::ends : EventKind::begins,
                          x - translation});
    }
}

/// The circle where no arc crosses it: the whole of it, or as much as the rays reach when no cut locus is known.
std::vector<Polyline> uncut_circle(std::span<const FanRay> fan, double radius) {
    std::vector<Polyline> lines;
    bool is_open = false;
    for (std::size_t i = 0; i <= fan.size(); ++i) {
        const FanRay& ray = fan[i % fan.size()];
        const bool is_reached = ray.length >= radius;
        if (is_reached && !is_open) lines.emplace_back();
        if (is_reached) lines.back().push_back(ray.point(radius));
        is_open = is_reached;
    }
    return lines;
}

}  // namespace

std::vector<Polyline> distance_circle(std::span<const FanRay> fan, const CutGraph& graph, const ChartPeriods& periods,
                                      double radius) {
    std::vector<Event> events;
    for (const CutArc& arc : graph.arcs) add_crossings(arc, periods, radius, events);
    if (events.empty()) return uncut_circle(fan, radius);
    for (const FanRay& ray : fan)
        if (ray.length >= radius) events.push_back({ray.theta, EventKind::passes, ray.point(radius)});
    std::stable_sort(events.begin(), events.end(), [](const Event& a, const Event& b) { return a.theta < b.theta; });

    std::vector<Polyline> lines;
    const auto first =
        std::find_if(events.begin(), events.end(), [](const Event& event) { return event.kind == EventKind::begins; });
    std::rotate(events.begin(), first, events.end());
    bool is_open = false;
    for (const Event& event : events) {
        if (event.kind == EventKind::begins) lines.emplace_back();
        // Rays beyond an end belong to no line: interpolation took them a trifle too far.
        if (event.kind == EventKind::begins || is_open) lines.back().push_back(event.x);
        is_open = event.kind == EventKind::passes ? is_open : event.kind == EventKind::begins;
    }
    return lines;
}

Polyline geodesic_circle(std::span<const FanRay> fan, double radius) {
    Polyline line;
    for (const FanRay& ray : fan) line.push_back(ray.point(radius));
    line.push_back(line.front());
    return line;
}

std::vector<Polyline> conjugate_locus(std::span<const FanRay> fan) {
    std::vector<Polyline> lines;
    bool is_open = false;
    const auto add = [&](const FanRay& ray) {
        const auto beyond = std::find_if(ray.states.begin() + 1, ray.states.end(),
                                         [](const GeodesicState& state) { return state.j <= 0; });
        if (beyond == ray.states.end()) {
            is_open = false;
            return;
        }
        // j is close to linear between two states: j'' = -K j vanishes with j.
        const GeodesicState &a = *(beyond - 1), &b = *beyond;
        const double t = a.t + (b.t - a.t) * a.j / (a.j - b.j);
        if (!is_open) lines.emplace_back();
        lines.back().push_back(ray.point(t));
        is_open = true;
    };
    for (const FanRay& ray : fan) add(ray);
    if (!fan.empty() && is_open) add(fan.front());
    return lines;
}

std::vector<double> round_radii(double largest, int count) {
    const double step = round_step(largest / count);
    std::vector<double> radii;
    for (int i = 1; i * step < largest; ++i) radii.push_back(i * step);
    return radii;
}

}  // namespace dsc::cutlocus
