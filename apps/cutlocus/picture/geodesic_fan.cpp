// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/picture/geodesic_fan.h"

#include <algorithm>
#include <cmath>
#include <list>

#include "apps/cutlocus/gluing.h"
#include "core/assert.h"

namespace dsc::cutlocus {

using geodesic::GeodesicFlow;
using geodesic::GeodesicState;
using geodesic::Metric;
using geodesic::Point2;

namespace {

FanRay shot(GeodesicFlow& flow, double theta, const CutDistance::Reach& reach, double step) {
    FanRay ray{.theta = theta, .length = reach.distance, .ends_on_locus = reach.is_on_locus, .step = step};
    ray.states.push_back(flow.start(theta));
    GeodesicState state = ray.states.front();
    const int steps = std::max(1, static_cast<int>(std::ceil(reach.distance / step - 1e-6)));
    for (int i = 1; i <= steps; ++i) {
        const double t = i == steps ? reach.distance : i * step;
        flow.advance(state, t - state.t);
        ray.states.push_back(state);
    }
    return ray;
}

/// The length from which on two rays are further apart than `largest`.
std::optional<double> divergence(const Metric& metric, const FanRay& a, const FanRay& b, double largest) {
    const auto is_far = [&](const Point2& x, const Point2& y) {
        return metric.tensor((x + y) / 2).norm(y - x) > largest;
    };
    const std::size_t common = std::min(a.states.size(), b.states.size()) - 1;
    for (std::size_t i = 1; i < common; ++i)
        if (is_far(a.states[i].x, b.states[i].x)) return a.states[i].t;
    if (is_far(a.states.back().x, b.states.back().x)) return std::min(a.length, b.length);
    return std::nullopt;
}

}  // namespace

Point2 FanRay::point(double t) const {
    const auto last = static_cast<double>(states.size() - 2);
    const auto i = static_cast<std::size_t>(std::clamp(std::floor(t / step), 0.0, last));
    const GeodesicState &a = states[i], &b = states[i + 1];
    const double h = b.t - a.t;
    if (h <= 0) return b.x;
    const double s = std::clamp((t - a.t) / h, 0.0, 1.0), r = 1 - s;
    return r * r * (1 + 2 * s) * a.x + s * s * (1 + 2 * r) * b.x + h * s * r * (r * a.velocity - s * b.velocity);
}

Polyline FanRay::line(double begin, double end, double spacing) const {
    const int count = std::max(1, static_cast<int>(std::ceil((end - begin) / spacing - 1e-9)));
    Polyline points;
    for (int i = 0; i <= count; ++i) points.push_back(point(begin + (end - begin) * i / count));
    return points;
}

std::vector<FanRay> geodesic_fan(const Metric& metric, const Point2& p, const CutDistance& cut,
                                 const FanParameters& parameters) {
    DSC_ASSERT(parameters.directions >= 3 && parameters.step > 0 && parameters.largest_gap > 0);
    GeodesicFlow flow(metric, p, parameters.tolerance);
    const auto ray_at = [&](double theta) {
        const CutDistance::Reach reach =
            parameters.length ? CutDistance::Reach{*parameters.length, false} : cut.reach(theta);
        return shot(flow, theta, reach, parameters.step);
    };

    std::list<FanRay> rays;
    for (int i = 0; i < parameters.directions; ++i) rays.push_back(ray_at(full_turn * i / parameters.directions));
    rays.push_back(rays.front());
    rays.back().theta += full_turn;
    // Level by level, so that a limit on the number of rays is felt everywhere alike.
    constexpr int levels = 14;
    for (int level = 0; level < levels; ++level) {
        for (auto ray = rays.begin(), next = std::next(ray); next != rays.end(); ray = next++) {
            if (static_cast<int>(rays.size()) > parameters.max_rays) break;
            const auto apart_at = divergence(metric, *ray, *next, parameters.largest_gap);
            if (apart_at) rays.insert(next, ray_at((ray->theta + next->theta) / 2))->apart_at = *apart_at;
        }
    }
    rays.pop_back();
    return {std::make_move_iterator(rays.begin()), std::make_move_iterator(rays.end())};
}

}  // namespace dsc::cutlocus
