// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/operations/move_vertex.h"

#include <algorithm>
#include <limits>

#include "core/assert.h"
#include "geometry/triangle.h"

namespace dsc::dsc2d {

bool can_move_vertex(const Complex& complex, VertexId v, const Point2& place) {
    const Point2 m = place - complex.position(v);
    const HalfedgeId first = complex.halfedge(v);
    HalfedgeId h = first;
    Point2 u = complex.vector(h);
    do {
        const HalfedgeId following = complex.rotated(h);
        const Point2 w = complex.vector(following);
        if (!geometry::is_counterclockwise(m, u, w)) return false;
        u = w;
        h = following;
    } while (h != first);
    return true;
}

MoveResult move_vertex(Complex& complex, VertexId v, const Point2& target, const Approach& approach) {
    DSC_ASSERT(!complex.is_boundary(v));
    const Point2 start = complex.position(v);
    const Point2 way = target - start;
    if (way.isZero(0.0)) return {true, 1.0, HalfedgeId()};

    // Twice the area of a face of the star changes linearly along the way; the link is met where the first becomes zero.
    double meeting = std::numeric_limits<double>::infinity();
    const HalfedgeId first = complex.halfedge(v);
    HalfedgeId blocking = first;
    HalfedgeId h = first;
    Point2 u = complex.vector(h);
    do {
        const HalfedgeId following = complex.rotated(h);
        const Point2 w = complex.vector(following);
        const double loss = geometry::cross(way, w - u);
        if (loss > 0.0) {
            const double here = geometry::cross(u, w) / loss;
            if (here < meeting) {
                meeting = here;
                blocking = h;
            }
        }
        u = w;
        h = following;
    } while (h != first);

    if (meeting > 1.0 && can_move_vertex(complex, v, target)) {
        complex.set_position_unchecked(v, target);
        return {true, 1.0, HalfedgeId()};
    }
    const bool at_interface = complex.is_interface(complex.next(blocking));
    double fraction = std::min(1.0, meeting * (at_interface ? approach.to_interface : approach.to_mesh));
    // Below the grid spacing there is nothing left to try.
    const double smallest = complex.domain().quantum() / way.cwiseAbs().maxCoeff();
    for (; fraction > smallest; fraction *= 0.5) {
        const Point2 place = complex.domain().snapped(start + fraction * way);
        if (place == target || !can_move_vertex(complex, v, place)) continue;
        complex.set_position_unchecked(v, place);
        return {false, fraction, blocking};
    }
    return {false, 0.0, blocking};
}

}  // namespace dsc::dsc2d
