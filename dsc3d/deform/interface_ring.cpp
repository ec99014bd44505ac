// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/interface_ring.h"

#include <algorithm>

namespace dsc::dsc3d {

surface::OneRing InterfaceRing::gather(RatedMesh& mesh, VertexId v) {
    const Complex& complex = mesh.complex();
    triangles_.clear();
    for (const TetId t : mesh.walker().star(v)) {
        for (int i = 0; i < 4; ++i) {
            if (complex.vertices(t)[static_cast<std::size_t>(i)] == v) continue;
            const TetId next = complex.neighbour(t, i);
            // Each face once, from the side of its higher label.
            if (!next.is_valid() || complex.label(next) >= complex.label(t)) continue;
            FaceVertices face = complex.oriented_face(t, i);
            std::rotate(face.begin(), std::find(face.begin(), face.end(), v), face.end());
            triangles_.push_back({mesh.position(face[1]), mesh.position(face[2])});
        }
    }
    return {mesh.position(v), triangles_};
}

}  // namespace dsc::dsc3d
