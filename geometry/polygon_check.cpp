// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/polygon_check.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "geometry/triangle.h"

namespace dsc::geometry {

namespace {

struct Segment {
    Point2 a, b;
    PolygonSide side;
    std::uint32_t sides;  ///< of its polygon

    double low() const { return std::min(a.x(), b.x()); }
    double high() const { return std::max(a.x(), b.x()); }
    bool is_followed_by(const Segment& other) const {
        return side.polygon == other.side.polygon && (side.side + 1) % sides == other.side.side;
    }
};

// Of three points on a line, b lies between the other two or on one of them.
bool is_between(const Point2& a, const Point2& b, const Point2& c) {
    return std::min(a.x(), c.x()) <= b.x() && b.x() <= std::max(a.x(), c.x()) && std::min(a.y(), c.y()) <= b.y() &&
           b.y() <= std::max(a.y(), c.y());
}

Point2 crossing(const Segment& s, const Segment& t) {
    const Point2 u = s.b - s.a, v = t.b - t.a;
    return s.a + cross(Point2(t.a - s.a), v) / cross(u, v) * u;
}

// The second follows the first: the corner between them is theirs, more is not.
bool folds_back(const Segment& s, const Segment& t) {
    if (s.a == s.b || t.a == t.b) return true;
    return orientation(s.a, s.b, t.b) == Sign::zero && (s.b - s.a).dot(t.b - t.a) < 0;
}

std::optional<Point2> meeting(const Segment& s, const Segment& t) {
    if (s.is_followed_by(t)) return folds_back(s, t) ? std::optional(s.b) : std::nullopt;
    if (t.is_followed_by(s)) return folds_back(t, s) ? std::optional(t.b) : std::nullopt;
    const Sign a = orientation(s.a, s.b, t.a), b = orientation(s.a, s.b, t.b);
    const Sign c = orientation(t.a, t.b, s.a), d = orientation(t.a, t.b, s.b);
    if (a == Sign::zero && is_between(s.a, t.a, s.b)) return t.a;
    if (b == Sign::zero && is_between(s.a, t.b, s.b)) return t.b;
    if (c == Sign::zero && is_between(t.a, s.a, t.b)) return s.a;
    if (d == Sign::zero && is_between(t.a, s.b, t.b)) return s.b;
    if (a == Sign::zero || b == Sign::zero || c == Sign::zero || d == Sign::zero || a == b || c == d)
        return std::nullopt;
    return crossing(s, t);
}

auto order(const SideMeeting& m) { return std::tuple(m.first.polygon, m.first.side, m.second.polygon, m.second.side); }

}  // namespace

std::optional<SideMeeting> first_meeting(std::span<const std::vector<Point2>> polygons) {
    std::vector<Segment> segments;
    for (std::uint32_t p = 0; p < polygons.size(); ++p) {
        const auto sides = static_cast<std::uint32_t>(polygons[p].size());
        for (std::uint32_t i = 0; i < sides; ++i)
            segments.push_back({polygons[p][i], polygons[p][(i + 1) % sides], {p, i}, sides});
    }
    std::vector<std::uint32_t> by_low(segments.size());
    std::iota(by_low.begin(), by_low.end(), 0U);
    std::ranges::stable_sort(by_low, {}, [&](std::uint32_t i) { return segments[i].low(); });
    std::optional<SideMeeting> first;
    for (std::size_t i = 0; i < by_low.size(); ++i) {
        for (std::size_t j = i + 1; j < by_low.size(); ++j) {
            const std::uint32_t low = std::min(by_low[i], by_low[j]), high = std::max(by_low[i], by_low[j]);
            if (segments[by_low[j]].low() > segments[by_low[i]].high()) break;
            const std::optional<Point2> place = meeting(segments[low], segments[high]);
            if (!place) continue;
            const SideMeeting found = {segments[low].side, segments[high].side, *place};
            if (!first || order(found) < order(*first)) first = found;
        }
    }
    return first;
}

double signed_area(std::span<const Point2> polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        twice += cross(Point2(polygon[i] - polygon[0]), Point2(polygon[(i + 1) % polygon.size()] - polygon[0]));
    return twice / 2;
}

bool contains(std::span<const Point2> polygon, const Point2& place) {
    bool is_inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        if ((a.y() > place.y()) == (b.y() > place.y())) continue;
        const Sign side = orientation(a, b, place);
        if ((side == Sign::positive) == (b.y() > a.y())) is_inside = !is_inside;
    }
    return is_inside;
}

}  // namespace dsc::geometry
