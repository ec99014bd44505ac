// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/improve/smoothing.h"

#include <algorithm>
#include <limits>

#include "dsc2d/operations/move_vertex.h"
#include "geometry/triangle.h"

namespace dsc::dsc2d {

namespace {

// Worst quality of the star with its centre moved by `shift`.
double worst_quality(const Complex& complex, VertexId v, const Point2& shift) {
    double worst = std::numeric_limits<double>::infinity();
    for (const HalfedgeId h : complex.outgoing(v))
        worst = std::min(worst, geometry::mean_ratio(shift, complex.vector(h), complex.vector(complex.rotated(h))));
    return worst;
}

}  // namespace

void smooth(PassContext& context) {
    Complex& complex = context.complex;
    const std::size_t count = context.active.size();
    for (std::size_t i = 0; i < count; ++i) {
        const VertexId v = context.active[i];
        if (complex.is_deleted(v) || !context.is_steiner(v)) continue;
        Point2 sum = Point2::Zero();
        int valence = 0;
        for (const HalfedgeId h : complex.outgoing(v)) {
            sum += complex.vector(h);
            ++valence;
        }
        const Point2 place = complex.domain().snapped(complex.position(v) + sum / valence);
        const Point2 shift = place - complex.position(v);
        if (worst_quality(complex, v, shift) <= worst_quality(complex, v, Point2::Zero())) continue;
        if (!can_move_vertex(complex, v, place)) continue;
        complex.set_position_unchecked(v, place);
        ++context.report.counts.smoothings;
    }
}

}  // namespace dsc::dsc2d
