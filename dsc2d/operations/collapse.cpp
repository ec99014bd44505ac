// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/operations/collapse.h"

#include <algorithm>
#include <numbers>

#include "core/assert.h"
#include "geometry/triangle.h"

namespace dsc::dsc2d {

namespace {

bool is_allowed(const Complex& complex, HalfedgeId h, CollapseRule rule) {
    const VertexId a = complex.from(h);
    if (!complex.is_interface(a)) return true;
    switch (rule) {
        case CollapseRule::keep_interface: return false;
        case CollapseRule::coarsen_interface:
            // A side edge on the interface would merge with an edge at to(h) and change the region between them.
            return complex.is_interface(h) && complex.interface_degree(a) == 2 &&
                   !complex.is_interface(complex.prev(h)) && !complex.is_interface(complex.next(Complex::opposite(h)));
        case CollapseRule::change_topology: return true;
    }
    return false;
}

// In the cover, the ends may share only the two apexes of their edge, and to(h) may not become its own neighbour.
bool keeps_cover_simplicial(const Complex& complex, HalfedgeId h) {
    const VertexId b = complex.to(h);
    const LatticeVector to_b = complex.offset(h);
    const HalfedgeId left = complex.rotated(h);
    const HalfedgeId right = complex.next(Complex::opposite(h));
    for (const HalfedgeId out : complex.outgoing(complex.from(h))) {
        if (out == h || out == left || out == right) continue;
        const VertexId w = complex.to(out);
        if (w == b) return false;
        const LatticeVector seen_from_b = complex.offset(out) - to_b;
        for (const HalfedgeId other : complex.outgoing(b))
            if (complex.to(other) == w && complex.offset(other) == seen_from_b) return false;
    }
    return true;
}

bool keeps_orientation(const Complex& complex, HalfedgeId h) {
    const Point2 b = complex.vector(h);
    for (const HalfedgeId out : complex.outgoing(complex.from(h))) {
        const HalfedgeId following = complex.rotated(out);
        if (out == h || following == h) continue;
        if (!geometry::is_counterclockwise(b, complex.vector(out), complex.vector(following))) return false;
    }
    return true;
}

}  // namespace

bool can_collapse(const Complex& complex, HalfedgeId h, CollapseRule rule) {
    const VertexId a = complex.from(h);
    if (complex.is_locked(a) || complex.is_boundary(a)) return false;
    return is_allowed(complex, h, rule) && keeps_orientation(complex, h) && keeps_cover_simplicial(complex, h);
}

void collapse(Complex& complex, HalfedgeId h) {
    DSC_ASSERT(can_collapse(complex, h, CollapseRule::change_topology));
    complex.collapse_unchecked(h);
}

double min_angle_after_collapse(const Complex& complex, HalfedgeId h, double enough) {
    const Point2 b = complex.vector(h);
    double smallest = std::numbers::pi;
    for (const HalfedgeId out : complex.outgoing(complex.from(h))) {
        const HalfedgeId following = complex.rotated(out);
        if (out == h || following == h) continue;
        smallest = std::min(smallest, geometry::min_angle(b, complex.vector(out), complex.vector(following)));
        if (smallest < enough) break;
    }
    return smallest;
}

}  // namespace dsc::dsc2d
