// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/operations/split.h"

#include "core/assert.h"

namespace dsc::dsc2d {

bool can_split_edge_at(const Complex& complex, HalfedgeId h, const Point2& place) {
    const Point2 m = place - complex.position(complex.from(h));
    const Point2 a = Point2::Zero(), b = complex.vector(h);
    const HalfedgeId o = Complex::opposite(h);
    if (!complex.is_boundary(h)) {
        const Point2 c = -complex.vector(complex.prev(h));
        if (!geometry::is_counterclockwise(a, m, c) || !geometry::is_counterclockwise(m, b, c)) return false;
    }
    if (!complex.is_boundary(o)) {
        const Point2 d = complex.vector(complex.next(o));
        if (!geometry::is_counterclockwise(m, a, d) || !geometry::is_counterclockwise(b, m, d)) return false;
    }
    return !complex.is_boundary(Complex::edge(h)) || geometry::orientation(a, b, m) == geometry::Sign::zero;
}

std::optional<Point2> can_split_edge(const Complex& complex, HalfedgeId h, double s) {
    const Point2 place = complex.domain().snapped(complex.position(complex.from(h)) + s * complex.vector(h));
    if (!can_split_edge_at(complex, h, place)) return std::nullopt;
    return place;
}

VertexId split_edge(Complex& complex, HalfedgeId h, const Point2& place) {
    DSC_ASSERT(can_split_edge_at(complex, h, place));
    return complex.split_edge_unchecked(h, place);
}

bool can_split_face(const Complex& complex, HalfedgeId h, const Point2& place) {
    const Point2 m = place - complex.position(complex.from(h));
    const Point2 a = Point2::Zero(), b = complex.vector(h), c = -complex.vector(complex.prev(h));
    return geometry::is_counterclockwise(a, b, m) && geometry::is_counterclockwise(b, c, m) &&
           geometry::is_counterclockwise(c, a, m);
}

VertexId split_face(Complex& complex, HalfedgeId h, const Point2& place) {
    DSC_ASSERT(can_split_face(complex, h, place));
    return complex.split_face_unchecked(h, place);
}

}  // namespace dsc::dsc2d
