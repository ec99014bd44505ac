// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/improve/detail_control.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "dsc2d/operations/collapse.h"
#include "dsc2d/operations/split.h"
#include "geometry/triangle.h"

namespace dsc::dsc2d {

namespace {

double min_angle_of_star(const Complex& complex, VertexId v) {
    double smallest = std::numbers::pi;
    for (const HalfedgeId h : complex.outgoing(v))
        smallest = std::min(smallest, geometry::min_angle(Point2::Zero(), complex.vector(h),
                                                          complex.vector(complex.rotated(h))));
    return smallest;
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

void insert_in_needles(PassContext& context) {
    if (!context.parameters.needle_angle) return;
    Complex& complex = context.complex;
    const double min_length = context.absolute(context.parameters.needle_min_length);
    const std::size_t count = context.active.size();
    for (std::size_t i = 0; i < count; ++i) {
        const VertexId v = context.active[i];
        if (complex.is_deleted(v)) continue;
        HalfedgeId needle;
        for (const HalfedgeId h : complex.outgoing(v)) {
            if (complex.is_boundary(h)) continue;
            const Point2 u = complex.vector(h), w = complex.vector(complex.rotated(h));
            const double longest = std::max({u.squaredNorm(), w.squaredNorm(), (w - u).squaredNorm()});
            if (longest < min_length * min_length) continue;
            if (geometry::min_angle(Point2::Zero(), u, w) < *context.parameters.needle_angle) needle = h;
        }
        if (!needle.is_valid()) continue;
        const Point2 to_barycentre = (complex.vector(needle) + complex.vector(complex.rotated(needle))) / 3.0;
        const Point2 place = complex.domain().snapped(complex.position(v) + to_barycentre);
        if (!can_split_face(complex, needle, place)) continue;
        context.active.add(split_face(complex, needle, place));
        ++context.report.counts.face_splits;
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
            if (length < shortest && can_collapse(complex, h, CollapseRule::coarsen_interface)) too_short = h;
        }
        if (too_short.is_valid()) {
            context.collapse_and_tell(too_short);
        } else if (too_long.is_valid()) {
            halve_long_edge(context, too_long);
        }
    }
}

}  // namespace dsc::dsc2d
