// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/picture/chart_box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace dsc::cutlocus {

using geodesic::ChartPeriods;
using geodesic::Point2;
using geodesic::Vector2;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Extent {
    Point2 lower{infinity, infinity}, upper{-infinity, -infinity};

    void add(const Point2& x) {
        lower = lower.cwiseMin(x);
        upper = upper.cwiseMax(x);
    }
};

std::optional<double> period(const ChartPeriods& periods, int axis) { return axis == 0 ? periods.u : periods.v; }

/// The part of the segment in the box as an interval of its parameter in [0, 1] (Liang and Barsky).
std::optional<std::pair<double, double>> visible_part(const Point2& a, const Point2& b, const Point2& lower,
                                                      const Point2& upper) {
    double begin = 0, end = 1;
    for (int axis = 0; axis < 2; ++axis) {
        const double way = b[axis] - a[axis];
        if (way == 0) {
            if (a[axis] < lower[axis] || a[axis] > upper[axis]) return std::nullopt;
            continue;
        }
        const double at_lower = (lower[axis] - a[axis]) / way, at_upper = (upper[axis] - a[axis]) / way;
        begin = std::max(begin, std::min(at_lower, at_upper));
        end = std::min(end, std::max(at_lower, at_upper));
    }
    if (begin > end) return std::nullopt;
    return std::pair(begin, end);
}

std::vector<Polyline> clipped_line(std::span<const Point2> line, const Vector2& translation, const Point2& lower,
                                   const Point2& upper) {
    std::vector<Polyline> pieces;
    bool is_connected = false;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Point2 a = line[i - 1] + translation, b = line[i] + translation;
        const auto part = visible_part(a, b, lower, upper);
        if (!part) {
            is_connected = false;
            continue;
        }
        if (!is_connected || part->first > 0) pieces.push_back({a + part->first * (b - a)});
        pieces.back().push_back(a + part->second * (b - a));
        is_connected = part->second == 1;
    }
    // A line that only touches a seam leaves a point on its other side.
    std::erase_if(pieces, [&](const Polyline& piece) {
        return std::all_of(piece.begin(), piece.end(), [&](const Point2& x) {
            return ((x - piece.front()).array().abs() <= 1e-5 * (upper - lower).array()).all();
        });
    });
    return pieces;
}

}  // namespace

ChartBox::ChartBox(const ChartPeriods& periods, const Point2& center, std::span<const Polyline> lines)
    : periods_(periods) {
    Extent extent;
    for (const Polyline& line : lines)
        for (const Point2& x : line) extent.add(x);
    for (int axis = 0; axis < 2; ++axis) {
        if (const auto length = period(periods, axis)) {
            lower_[axis] = center[axis] - *length / 2;
            upper_[axis] = center[axis] + *length / 2;
        } else {
            const double size = extent.upper[axis] - extent.lower[axis];
            const double margin = size > 0 && std::isfinite(size) ? 0.04 * size : 1;
            lower_[axis] = (size >= 0 ? extent.lower[axis] : center[axis]) - margin;
            upper_[axis] = (size >= 0 ? extent.upper[axis] : center[axis]) + margin;
        }
    }
    rim_ = 1e-6 * (upper_ - lower_);
}

template <class Function>
void ChartBox::for_each_translation(std::span<const Point2> line, Function&& use) const {
    Extent extent;
    for (const Point2& x : line) extent.add(x);
    int first[2] = {0, 0}, last[2] = {0, 0};
    for (int axis = 0; axis < 2; ++axis) {
        const auto length = period(periods_, axis);
        if (!length) continue;
        first[axis] = static_cast<int>(std::ceil((lower_[axis] - rim_[axis] - extent.upper[axis]) / *length));
        last[axis] = static_cast<int>(std::floor((upper_[axis] + rim_[axis] - extent.lower[axis]) / *length));
    }
    for (int i = first[0]; i <= last[0]; ++i)
        for (int k = first[1]; k <= last[1]; ++k) use(periods_.translation({i, k}));
}

std::vector<Polyline> ChartBox::pieces(std::span<const Point2> line) const {
    std::vector<Polyline> result;
    if (line.empty()) return result;
    for_each_translation(line, [&](const Vector2& translation) {
        for (Polyline& piece : clipped_line(line, translation, lower_ - rim_, upper_ + rim_))
            result.push_back(std::move(piece));
    });
    return result;
}

std::vector<Polyline> ChartBox::clipped(std::span<const Point2> line) const {
    return clipped_line(line, Vector2(0, 0), lower_ - rim_, upper_ + rim_);
}

std::vector<Point2> ChartBox::places(const Point2& point) const {
    std::vector<Point2> result;
    for_each_translation({&point, 1}, [&](const Vector2& translation) {
        const Point2 x = point + translation;
        if (((x - lower_ + rim_).array() >= 0).all() && ((upper_ + rim_ - x).array() >= 0).all()) result.push_back(x);
    });
    return result;
}

Polyline ChartBox::wrapped(std::span<const Point2> line) const {
    const Point2 center = (lower_ + upper_) / 2;
    Polyline result;
    Vector2 before(0, 0);  // the translation that brings the point before into the box
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Vector2 translation = periods_.wrapped(line[i] - center) + center - line[i];
        if (i > 0) {
            struct Crossing {
                double s;
                int axis;
            };
            std::vector<Crossing> crossings;
            const Point2 a = line[i - 1], b = line[i];
            const Vector2 change = translation - before;
            for (int axis = 0; axis < 2; ++axis) {
                const auto length = period(periods_, axis);
                if (!length || std::abs(change[axis]) < *length / 2) continue;
                const double seam = (change[axis] < 0 ? upper_[axis] : lower_[axis]) - before[axis];
                crossings.push_back({std::clamp((seam - a[axis]) / (b[axis] - a[axis]), 0.0, 1.0), axis});
            }
            std::sort(crossings.begin(), crossings.end(), [](const auto& x, const auto& y) { return x.s < y.s; });
            Vector2 present = before;
            for (const Crossing& crossing : crossings) {
                const Point2 x = a + crossing.s * (b - a);
                result.push_back(x + present);
                result.push_back(Point2::Constant(std::numeric_limits<double>::quiet_NaN()));
                present[crossing.axis] += change[crossing.axis];
                result.push_back(x + present);
            }
        }
        result.push_back(line[i] + translation);
        before = translation;
    }
    return result;
}

}  // namespace dsc::cutlocus
