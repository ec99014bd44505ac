// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/components.h"

namespace dsc::dsc3d {

core::DisjointSets components(const Complex& complex) {
    core::DisjointSets parts(complex.tet_capacity());
    for (std::uint32_t i = 0; i < complex.face_capacity(); ++i) {
        const FaceId f(i);
        if (!complex.is_deleted(f) && !complex.is_surface(f))
            parts.unite(complex.tets(f)[0].index(), complex.tets(f)[1].index());
    }
    return parts;
}

}  // namespace dsc::dsc3d
