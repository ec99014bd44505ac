// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/picture/polyline.h"

#include <algorithm>
#include <cmath>

namespace dsc::cutlocus {

using geodesic::Point2;
using geodesic::Vector2;

namespace {

double distance_to_segment(const Point2& x, const Point2& a, const Point2& b) {
    const Vector2 way = b - a;
    const double squared = way.squaredNorm();
    const double s = squared > 0 ? std::clamp((x - a).dot(way) / squared, 0.0, 1.0) : 0.0;
    return (x - a - s * way).norm();
}

}  // namespace

Polyline thinned(std::span<const Point2> line, double tolerance, double longest_segment) {
    if (line.size() < 3) return {line.begin(), line.end()};
    std::vector<char> is_kept(line.size(), 0);
    is_kept.front() = is_kept.back() = 1;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, line.size() - 1}};
    while (!open.empty()) {
        const auto [first, last] = open.back();
        open.pop_back();
        if (last - first < 2) continue;
        std::size_t farthest = first;
        double deviation = tolerance;
        for (std::size_t i = first + 1; i < last; ++i) {
            const double d = distance_to_segment(line[i], line[first], line[last]);
            if (d > deviation) deviation = d, farthest = i;
        }
        if (farthest == first) {
            if ((line[last] - line[first]).norm() <= longest_segment) continue;
            farthest = (first + last) / 2;
        }
        is_kept[farthest] = 1;
        open.push_back({first, farthest});
        open.push_back({farthest, last});
    }
    Polyline result;
    for (std::size_t i = 0; i < line.size(); ++i)
        if (is_kept[i]) result.push_back(line[i]);
    return result;
}

double round_step(double lower_bound) {
    const double power = std::pow(10.0, std::floor(std::log10(lower_bound)));
    for (const double factor : {1.0, 2.0, 2.5, 5.0})
        if (factor * power >= lower_bound * (1 - 1e-9)) return factor * power;
    return 10 * power;
}

}  // namespace dsc::cutlocus
