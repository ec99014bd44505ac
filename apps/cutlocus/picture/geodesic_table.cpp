// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/picture/geodesic_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geodesic/connect.h"

namespace dsc::cutlocus {

using geodesic::GeodesicState;
using geodesic::Metric;
using geodesic::Point2;
using geodesic::Vector2;

namespace {

constexpr double tolerance = 1e-10;

std::vector<Polyline> places(const std::vector<FanRay>& fan) {
    std::vector<Polyline> lines;
    for (const FanRay& ray : fan) {
        Polyline& line = lines.emplace_back();
        for (const GeodesicState& state : ray.states) line.push_back(state.x);
    }
    return lines;
}

}  // namespace

GeodesicTable::GeodesicTable(const Metric& metric, const Point2& p, const CutDistance& cut, double spacing)
    : metric_(metric), flow_(metric, p, tolerance), spacing_(spacing), grid_(static_cast<std::size_t>(cells) * cells) {
    const std::vector<FanRay> fan =
        geodesic_fan(metric, p, cut, {.directions = 48, .step = spacing, .largest_gap = spacing, .max_rays = 1500});
    const ChartBox box(metric.periods(), p, places(fan));
    lower_ = box.lower();
    size_ = box.upper() - box.lower();
    for (const FanRay& ray : fan) {
        for (std::size_t i = 1; i < ray.states.size(); ++i) {
            samples_.push_back(ray.states[i]);
            const Point2 at = grid_place(ray.states[i].x);
            grid_[static_cast<std::size_t>(std::floor(at.y()) * cells + std::floor(at.x()))].push_back(
                static_cast<std::uint32_t>(samples_.size() - 1));
        }
    }
}

Point2 GeodesicTable::grid_place(const Point2& x) const {
    const Point2 center = lower_ + size_ / 2;
    const Point2 at = cells * (metric_.periods().wrapped(x - center) + size_ / 2).cwiseQuotient(size_);
    return at.cwiseMax(0).cwiseMin(cells - 1e-9);
}

std::vector<GeodesicTable::Candidate> GeodesicTable::candidates(const Point2& x) const {
    const Point2 at = grid_place(x);
    const int column = static_cast<int>(at.x()), row = static_cast<int>(at.y());
    const geodesic::MetricTensor tensor = metric_.tensor(x);
    const auto is_inside = [](bool is_periodic, int& index) {
        if (is_periodic) index = (index + cells) % cells;
        return index >= 0 && index < cells;
    };
    std::vector<Candidate> found;
    const auto add_cell = [&](int u, int v) {
        if (!is_inside(metric_.periods().u.has_value(), u) || !is_inside(metric_.periods().v.has_value(), v)) return;
        for (const std::uint32_t index : grid_[static_cast<std::size_t>(v * cells + u)])
            found.push_back({index, tensor.norm(metric_.periods().wrapped(x - samples_[index].x))});
    };
    // Rings of cells around that of x: one more than the first that holds a sample.
    int last_ring = cells - 1;
    for (int ring = 0; ring <= last_ring; ++ring) {
        if (ring < last_ring && !found.empty()) last_ring = ring;
        for (int i = -ring; i <= ring; ++i)
            for (int k = -ring; k <= ring; ++k)
                if (std::max(std::abs(i), std::abs(k)) == ring) add_cell(column + i, row + k);
    }
    return found;
}

GeodesicTable::Answer GeodesicTable::geodesic_to(const Point2& x) {
    std::vector<Candidate> near = candidates(x);
    const auto closer = [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; };
    constexpr std::size_t most_tried = 12;
    const std::size_t tried = std::min(near.size(), most_tried);
    std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(tried), near.end(), closer);
    const GeodesicState& sample = samples_[near.front().sample];
    std::optional<Answer> answer;
    for (std::size_t i = 0; i < tried && !answer; ++i) answer = from_sample(samples_[near[i].sample], x);
    // Next to the cut locus the nearest sample may lie beyond it: then the other sheet is the shorter way.
    constexpr double other_sheet = 0.1;
    for (std::size_t i = 1; i < tried; ++i) {
        const GeodesicState& other = samples_[near[i].sample];
        const double turn = std::abs(std::remainder(other.theta - sample.theta, 2 * std::numbers::pi));
        if (near[i].distance > 1.5 * spacing_ || std::min(other.t, sample.t) < 6 * spacing_) continue;
        if (turn * std::min(other.j, sample.j) < 4 * spacing_ && turn < other_sheet) continue;
        const std::optional<Answer> shorter = from_sample(other, x);
        if (!shorter) continue;
        if (!answer || shorter->distance < answer->distance) answer = shorter;
        break;
    }
    return answer.value_or(Answer{sample.theta, sample.t});
}

void GeodesicTable::add_stops(const FrontResult& front) {
    for (const FrontContact& contact : front.contacts) {
        stops_.try_emplace(key(contact.place1), Answer{wrapped_angle(contact.pair.theta1), contact.pair.t});
        stops_.try_emplace(key(contact.place2), Answer{wrapped_angle(contact.pair.theta2), contact.pair.t});
    }
    for (const LocalStop& stop : front.local_stops)
        stops_.try_emplace(key(stop.place), Answer{wrapped_angle(stop.theta), stop.t});
}

GeodesicTable::Answer GeodesicTable::geodesic_to_vertex(const Point2& x) {
    const auto stop = stops_.find(key(x));
    return stop == stops_.end() ? geodesic_to(x) : stop->second;
}

std::pair<long, long> GeodesicTable::key(const Point2& x) const {
    constexpr double grains = 1e9;  // per side of the chart
    // The seam of the wrapping lies away from the places where symmetric cut loci lie.
    const Point2 at = metric_.periods().wrapped(x - lower_ - 0.123 * size_).cwiseQuotient(size_);
    return {std::lround(grains * at.x()), std::lround(grains * at.y())};
}

std::optional<GeodesicTable::Answer> GeodesicTable::from_sample(const GeodesicState& sample, const Point2& x) {
    const Vector2 way = metric_.periods().wrapped(x - sample.x);
    const geodesic::LocalGeometry local = metric_.local_geometry(sample.x);
    // The initial velocity of the geodesic from the sample to x, to second order; along and across that of the sample.
    const auto product = [&](const std::array<double, 3>& symbols) {
        return symbols[0] * way.x() * way.x() + 2 * symbols[1] * way.x() * way.y() + symbols[2] * way.y() * way.y();
    };
    const Vector2 tangent = way + Vector2(product(local.christoffel_u), product(local.christoffel_v)) / 2;
    const double along = local.tensor.inner(tangent, sample.velocity);
    const double across = local.tensor.inner(tangent, local.tensor.rotated(sample.velocity));
    // Newton's method where the terms of second order are not small against those of first order. A distance can't
    // differ from that of the sample by more than the way between them: then it has found a geodesic beyond a conjugate
    // point.
    constexpr double small = 0.2;
    const double j = sample.j;
    if (!(j > 0 && std::abs(across) < small * j && std::abs(sample.j_t * along) < small * j &&
          std::abs(sample.j_theta * across) < small * j * j)) {
        const auto exact =
            geodesic::connect(flow_, sample.x + way, sample.theta, sample.t, {.tolerance = 100 * tolerance});
        if (!exact || std::abs(exact->t - sample.t) > 1.1 * local.tensor.norm(tangent)) return std::nullopt;
        return Answer{wrapped_angle(exact->theta), exact->t};
    }
    // E(theta + a, t + b) - E(theta, t): j a + j_t a b + j_theta a²/2 across, b - j j_t a²/2 along.
    const double angle = across / (j + sample.j_t * along + sample.j_theta * across / (2 * j));
    return Answer{wrapped_angle(sample.theta + angle), sample.t + along + j * sample.j_t * angle * angle / 2};
}

Polyline GeodesicTable::line(const Answer& answer, double spacing) {
    GeodesicState state = flow_.start(answer.theta);
    const int steps = std::max(1, static_cast<int>(std::ceil(answer.distance / spacing)));
    Polyline points{state.x};
    for (int i = 0; i < steps; ++i) {
        flow_.advance(state, answer.distance / steps);
        points.push_back(state.x);
    }
    return points;
}

}  // namespace dsc::cutlocus
