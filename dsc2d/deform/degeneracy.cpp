// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/deform/degeneracy.h"

#include <array>
#include <cmath>

#include "dsc2d/operations/collapse.h"
#include "geometry/triangle.h"

namespace dsc::dsc2d {

namespace {

// u and w are the edges from one corner. The smallest angle lies opposite the shortest edge, between the longest two.
bool is_degenerate(double sine_bound, double area_bound, const Point2& u, const Point2& w) {
    const double twice_area = geometry::cross(u, w);
    if (twice_area < 2.0 * area_bound) return true;
    const double uu = u.squaredNorm(), ww = w.squaredNorm(), oo = (w - u).squaredNorm();
    const double longest_two = uu <= ww && uu <= oo ? ww * oo : ww <= oo ? uu * oo : uu * ww;
    return twice_area * twice_area < sine_bound * sine_bound * longest_two;
}

// One collapse at a degenerate face; false when nothing can be done.
bool remove_face(PassContext& context, HalfedgeId h) {
    Complex& complex = context.complex;
    const std::array<HalfedgeId, 3> sides = {h, complex.next(h), complex.prev(h)};
    HalfedgeId shortest = sides[0];
    for (const HalfedgeId side : sides)
        if (complex.vector(side).squaredNorm() < complex.vector(shortest).squaredNorm()) shortest = side;
    for (const VertexId end : {complex.from(shortest), complex.to(shortest)})
        if (context.is_steiner(end) && remove_steiner_vertex(context, end)) return true;

    const bool may_change = motion::allows_change(context.parameters.topology, complex.label(complex.face(h)),
                                                  context.parameters.background_label);
    if (!may_change) return false;
    const std::array<HalfedgeId, 2> ways = {shortest, Complex::opposite(shortest)};
    for (const HalfedgeId way : ways)
        if (complex.is_interface(way) && can_collapse(complex, way, CollapseRule::coarsen_interface)) {
            context.collapse_and_tell(way);
            return true;
        }
    // Only a face that the interface surrounds on two sides may vanish with a piece of the interface.
    int interface_sides = 0;
    for (const HalfedgeId side : sides) interface_sides += complex.is_interface(side) ? 1 : 0;
    if (interface_sides < 2) return false;
    for (const HalfedgeId way : ways)
        if (can_collapse(complex, way, CollapseRule::change_topology)) {
            context.collapse_and_tell(way);
            ++context.report.counts.topology_changes;
            return true;
        }
    return false;
}

}  // namespace

bool remove_steiner_vertex(PassContext& context, VertexId v) {
    const Complex& complex = context.complex;
    HalfedgeId best;
    double best_angle = 0.0;
    for (const HalfedgeId h : complex.outgoing(v)) {
        const double angle = min_angle_after_collapse(complex, h, best_angle);
        if (angle <= best_angle || !can_collapse(complex, h, CollapseRule::keep_interface)) continue;
        best_angle = angle;
        best = h;
    }
    if (!best.is_valid()) return false;
    context.collapse_and_tell(best);
    return true;
}

void remove_degeneracies(PassContext& context) {
    Complex& complex = context.complex;
    const double sine_bound = std::sin(context.parameters.degenerate_angle);
    const double area_bound =
        context.parameters.degenerate_area * context.parameters.edge_length * context.parameters.edge_length;
    const std::size_t count = context.active.size();
    for (std::size_t i = 0; i < count; ++i) {
        const VertexId v = context.active[i];
        if (complex.is_deleted(v)) continue;
        for (const HalfedgeId h : complex.outgoing(v)) {
            if (complex.is_boundary(h)) continue;
            if (!is_degenerate(sine_bound, area_bound, complex.vector(h), complex.vector(complex.rotated(h))))
                continue;
            if (remove_face(context, h)) break;  // the ring is another one now
        }
    }
}

}  // namespace dsc::dsc2d
