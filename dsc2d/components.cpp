// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/components.h"

namespace dsc::dsc2d {

core::DisjointSets components(const Complex& complex) {
    core::DisjointSets parts(complex.face_capacity());
    for (std::uint32_t i = 0; i < complex.edge_capacity(); ++i) {
        const EdgeId e(i);
        if (complex.is_deleted(e) || complex.is_boundary(e) || complex.is_interface(e)) continue;
        const HalfedgeId h = Complex::halfedge(e);
        parts.unite(complex.face(h).index(), complex.face(Complex::opposite(h)).index());
    }
    return parts;
}

}  // namespace dsc::dsc2d
