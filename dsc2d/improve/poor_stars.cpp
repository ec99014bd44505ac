// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/improve/poor_stars.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "dsc2d/operations/collapse.h"
#include "dsc2d/operations/move_vertex.h"
#include "geometry/triangle.h"

namespace dsc::dsc2d {

namespace {

/// What is gained has to be more than this: a sweep that changes nothing much would never end [rad].
constexpr double least_gain = 1e-3;

// Where the smallest angle of the star is largest, by compass steps that are halved where none helps.
Point2 best_shift(const Complex& complex, VertexId v, double& angle) {
    constexpr double first_step = 0.25, last_step = 0.02;  // [longest edge at v]
    constexpr double diagonal = 0.5 * std::numbers::sqrt2;
    static const std::array<Point2, 8> directions = {
        Point2(1, 0),  Point2(diagonal, diagonal),   Point2(0, 1),  Point2(-diagonal, diagonal),
        Point2(-1, 0), Point2(-diagonal, -diagonal), Point2(0, -1), Point2(diagonal, -diagonal)};
    double longest = 0;
    for (const HalfedgeId h : complex.outgoing(v)) longest = std::max(longest, complex.length(h));
    Point2 shift = Point2::Zero();
    for (double step = first_step; step > last_step;) {
        Point2 best = shift;
        for (const Point2& direction : directions) {
            const Point2 candidate = shift + step * longest * direction;
            const double found = min_angle_of_star(complex, v, candidate);
            if (found <= angle) continue;
            angle = found;
            best = candidate;
        }
        if (best == shift) step /= 2;
        shift = best;
    }
    return shift;
}

HalfedgeId best_collapse(const Complex& complex, VertexId v, double& angle) {
    HalfedgeId best;
    for (const HalfedgeId h : complex.outgoing(v)) {
        const double found = min_angle_after_collapse(complex, h, angle);
        if (found <= angle || !can_collapse(complex, h, CollapseRule::keep_interface)) continue;
        angle = found;
        best = h;
    }
    return best;
}

}  // namespace

double min_angle_of_star(const Complex& complex, VertexId v, const Point2& shift) {
    double smallest = std::numbers::pi;
    for (const HalfedgeId h : complex.outgoing(v)) {
        const Point2 u = complex.vector(h), w = complex.vector(complex.rotated(h));
        if (geometry::cross(Point2(u - shift), Point2(w - shift)) <= 0) return -1;
        smallest = std::min(smallest, geometry::min_angle(shift, u, w));
    }
    return smallest;
}

void mend_poor_stars(PassContext& context) {
    if (!context.parameters.poor_angle) return;
    Complex& complex = context.complex;
    const std::size_t count = context.active.size();
    for (std::size_t i = 0; i < count; ++i) {
        const VertexId v = context.active[i];
        if (complex.is_deleted(v) || !context.is_steiner(v)) continue;
        const double before = min_angle_of_star(complex, v);
        if (before >= *context.parameters.poor_angle) continue;
        double by_move = before + least_gain, by_collapse = by_move;
        const Point2 place = complex.domain().snapped(complex.position(v) + best_shift(complex, v, by_move));
        const HalfedgeId way = best_collapse(complex, v, by_collapse);
        if (way.is_valid() && by_collapse > by_move) {
            context.collapse_and_tell(way);
        } else if (place != complex.position(v) && can_move_vertex(complex, v, place)) {
            complex.set_position_unchecked(v, place);
            ++context.report.counts.smoothings;
        }
    }
}

}  // namespace dsc::dsc2d
