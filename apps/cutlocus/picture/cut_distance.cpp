// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/picture/cut_distance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "apps/cutlocus/gluing.h"

namespace dsc::cutlocus {

namespace {}

CutDistance::CutDistance(const CutLocus& locus) : limit_(locus.front.distance) {
    if (locus.graph.arcs.empty()) {
        *this = CutDistance(locus.front);
        return;
    }
    const auto is_frontier = [&](int vertex) {
        return locus.graph.vertices[static_cast<std::size_t>(vertex)].kind == VertexKind::frontier;
    };
    for (const CutArc& arc : locus.graph.arcs) {
        if (arc.samples.empty()) continue;
        Side first, second;
        for (const CutSample& sample : arc.samples) {
            first.thetas.push_back(sample.theta1);
            first.distances.push_back(sample.distance);
        }
        // Along an arc theta1 ascends and theta2 descends.
        for (auto sample = arc.samples.rbegin(); sample != arc.samples.rend(); ++sample) {
            second.thetas.push_back(sample->theta2);
            second.distances.push_back(sample->distance);
        }
        first.ends_at_frontier = is_frontier(arc.end);
        second.ends_at_frontier = is_frontier(arc.start);
        for (Side* side : {&first, &second}) {
            const double shift = wrapped_angle(side->thetas.front()) - side->thetas.front();
            for (double& theta : side->thetas) theta += shift;
            sides_.push_back(std::move(*side));
        }
    }
    std::sort(sides_.begin(), sides_.end(),
              [](const Side& a, const Side& b) { return a.thetas.front() < b.thetas.front(); });
}

CutDistance::CutDistance(const FrontResult& front) : limit_(front.distance) {
    std::vector<std::pair<double, double>> ends;
    for (const FrontContact& contact : front.contacts)
        for (const double theta : {contact.pair.theta1, contact.pair.theta2})
            ends.emplace_back(wrapped_angle(theta), contact.pair.t);
    for (const LocalStop& stop : front.local_stops) ends.emplace_back(wrapped_angle(stop.theta), stop.t);
    if (ends.empty()) return;
    for (const double theta : front.free_directions) ends.emplace_back(wrapped_angle(theta), limit_);
    std::sort(ends.begin(), ends.end());
    ends.emplace_back(ends.front().first + full_turn, ends.front().second);
    Side& side = sides_.emplace_back();
    side.is_smooth = false;
    for (const auto& [theta, distance] : ends) {
        side.thetas.push_back(theta);
        side.distances.push_back(distance);
    }
}

CutDistance::Reach CutDistance::reach(double theta) const {
    if (sides_.empty()) return {limit_, false};
    theta = wrapped_angle(theta);
    const auto after = std::upper_bound(sides_.begin(), sides_.end(), theta,
                                        [](double angle, const Side& side) { return angle < side.thetas.front(); });
    const bool is_before_first = after == sides_.begin();
    const Side& side = is_before_first ? sides_.back() : *(after - 1);
    if (is_before_first) theta += full_turn;
    if (theta <= side.thetas.back()) {
        const double distance = interpolated(side, theta);
        return {distance, distance < limit_ || side.is_smooth};
    }
    if (side.ends_at_frontier) return {limit_, false};
    // What rounding leaves between two arcs, or a piece of the cut locus that was not found.
    const bool is_last = after == sides_.end() || is_before_first;
    const Side& next = is_last ? sides_.front() : *after;
    const double gap = next.thetas.front() + (is_last ? full_turn : 0) - side.thetas.back();
    const double s = gap > 0 ? std::clamp((theta - side.thetas.back()) / gap, 0.0, 1.0) : 0.5;
    return {(1 - s) * side.distances.back() + s * next.distances.front(), true};
}

double CutDistance::interpolated(const Side& side, double theta) {
    const auto& x = side.thetas;
    const auto& y = side.distances;
    if (x.size() < 2) return y.front();
    const std::size_t size = x.size();
    const auto above = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), theta) - x.begin());
    const std::size_t last = std::clamp<std::size_t>(above, 1, size - 1);
    const double width = x[last] - x[last - 1];
    if (width <= 0) return y[last];
    const double linear = y[last - 1] + (y[last] - y[last - 1]) * (theta - x[last - 1]) / width;
    if (size < 4 || !side.is_smooth) return linear;

    const std::size_t begin = std::min(last < 2 ? 0 : last - 2, size - 4);
    double cubic = 0;
    for (std::size_t i = begin; i < begin + 4; ++i) {
        double weight = y[i];
        for (std::size_t k = begin; k < begin + 4; ++k)
            if (k != i) weight *= (theta - x[k]) / (x[i] - x[k]);
        cubic += weight;
    }
    return std::isfinite(cubic) ? cubic : linear;
}

}  // namespace dsc::cutlocus
