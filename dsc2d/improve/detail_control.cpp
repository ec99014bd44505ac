// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/improve/detail_control.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "dsc2d/improve/poor_stars.h"
#include "dsc2d/operations/collapse.h"
#include "dsc2d/operations/split.h"
#include "geometry/triangle.h"

namespace dsc::dsc2d {

namespace {

// Twice the area that the interface loses or wins when v goes; nothing where more than two of its edges meet.
std::optional<double> loss_without(const Complex& complex, VertexId v) {
    Point2 sides[2];
    if (complex.interface_degree(v) != 2) return std::nullopt;
    int count = 0;
    for (const HalfedgeId h : complex.outgoing(v))
        if (complex.is_interface(h)) sides[count++] = complex.vector(h);
    return std::abs(geometry::cross(sides[0], sides[1]));
}

// The way to collapse a short edge of the interface that changes its shape least: corners stay.
HalfedgeId best_way(const Complex& complex, HalfedgeId h) {
    HalfedgeId best;
    double least = std::numeric_limits<double>::infinity();
    for (const HalfedgeId way : {h, Complex::opposite(h)}) {
        const std::optional<double> loss = loss_without(complex, complex.from(way));
        if (!loss || *loss >= least || !can_collapse(complex, way, CollapseRule::coarsen_interface)) continue;
        least = *loss;
        best = way;
    }
    return best;
}

void halve_long_edge(PassContext& context, HalfedgeId h) {
    Complex& complex = context.complex;
    const auto place = can_split_edge(complex, h, 0.5);
    if (!place) return;
    const VertexId a = complex.from(h), b = complex.to(h);
    const VertexId m = split_edge(complex, h, *place);
    context.listener.on_interface_split(m, a, b, 0.5);
    ++context.report.counts.edge_splits;
    context.active.add(m);
}

}  // namespace

void thin_out(PassContext& context) {
    Complex& complex = context.complex;
    const double min_edge = context.absolute(context.parameters.steiner_min_edge);
    for (std::size_t i = 0; i < context.active.size(); ++i) {
        const VertexId v = context.active[i];
        if (complex.is_deleted(v) || !context.is_steiner(v)) continue;
        HalfedgeId shortest;
        double shortest_squared = min_edge * min_edge;
        for (const HalfedgeId h : complex.outgoing(v)) {
            const double squared = complex.vector(h).squaredNorm();
            if (squared >= shortest_squared) continue;
            shortest_squared = squared;
            shortest = h;
        }
        if (!shortest.is_valid() || !can_collapse(complex, shortest, CollapseRule::keep_interface)) continue;
        const double bound = std::min(context.parameters.steiner_min_angle, min_angle_of_star(complex, v));
        if (min_angle_after_collapse(complex, shortest) >= bound) context.collapse_and_tell(shortest);
    }
}

void split_needles(PassContext& context) {
    if (!context.parameters.needle_angle) return;
    Complex& complex = context.complex;
    const double min_length = context.absolute(context.parameters.needle_min_length);
    const std::size_t count = context.active.size();
    for (std::size_t i = 0; i < count; ++i) {
        const VertexId v = context.active[i];
        if (complex.is_deleted(v)) continue;
        HalfedgeId longest;
        double longest_squared = min_length * min_length;
        for (const HalfedgeId h : complex.outgoing(v)) {
            if (complex.is_boundary(h)) continue;
            const Point2 u = complex.vector(h), w = complex.vector(complex.rotated(h));
            if (geometry::min_angle(Point2::Zero(), u, w) >= *context.parameters.needle_angle) continue;
            for (const HalfedgeId side : {h, complex.next(h), complex.prev(h)}) {
                const double squared = complex.vector(side).squaredNorm();
                if (squared <= longest_squared || complex.is_interface(side)) continue;
                longest_squared = squared;
                longest = side;
            }
        }
        if (!longest.is_valid()) continue;
        const auto place = can_split_edge(complex, longest, 0.5);
        if (!place) continue;
        context.active.add(split_edge(complex, longest, *place));
        ++context.report.counts.edge_splits;
    }
}

void respace_interface(PassContext& context) {
    Complex& complex = context.complex;
    const Parameters& parameters = context.parameters;
    const double longest = parameters.interface_max_edge ? context.absolute(*parameters.interface_max_edge)
                                                         : std::numeric_limits<double>::infinity();
    const double shortest = parameters.interface_min_edge ? context.absolute(*parameters.interface_min_edge) : 0.0;
    if (!parameters.interface_max_edge && !parameters.interface_min_edge) return;
    for (std::size_t i = 0; i < context.active.size(); ++i) {
        const VertexId v = context.active[i];
        if (complex.is_deleted(v) || !complex.is_interface(v)) continue;
        HalfedgeId too_long, too_short;
        for (const HalfedgeId h : complex.outgoing(v)) {
            if (!complex.is_interface(h)) continue;
            const double length = complex.length(h);
            if (length > longest) too_long = h;
            if (length >= shortest) continue;
            if (const HalfedgeId way = best_way(complex, h); way.is_valid()) too_short = way;
        }
        if (too_short.is_valid()) {
            context.collapse_and_tell(too_short);
        } else if (too_long.is_valid()) {
            halve_long_edge(context, too_long);
        }
    }
}

}  // namespace dsc::dsc2d
