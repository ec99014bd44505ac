// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/operations/flip.h"

#include "core/assert.h"

namespace dsc::dsc2d {

bool can_flip(const Complex& complex, EdgeId e) {
    if (complex.is_boundary(e)) return false;
    const HalfedgeId h = Complex::halfedge(e), o = Complex::opposite(h);
    if (complex.to(complex.next(h)) == complex.to(complex.next(o))) return false;
    const Point2 a = Point2::Zero(), b = complex.vector(h);
    const Point2 c = -complex.vector(complex.prev(h)), d = complex.vector(complex.next(o));
    return geometry::is_counterclockwise(d, b, c) && geometry::is_counterclockwise(c, a, d);
}

void flip(Complex& complex, EdgeId e) {
    DSC_ASSERT(can_flip(complex, e) && !complex.is_interface(e));
    const HalfedgeId h = Complex::halfedge(e);
    complex.flip_unchecked(h, complex.label(complex.face(h)));
}

void flip_to_label_of(Complex& complex, HalfedgeId h) {
    DSC_ASSERT(can_flip(complex, Complex::edge(h)));
    complex.flip_unchecked(h, complex.label(complex.face(h)));
}

}  // namespace dsc::dsc2d
