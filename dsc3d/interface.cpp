// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/interface.h"

namespace dsc::dsc3d {

Interface::Interface(const Mesh& mesh) {
    const Complex& complex = mesh.complex();
    std::vector<std::uint32_t> number(complex.vertex_capacity());
    for (std::uint32_t i = 0; i < complex.vertex_capacity(); ++i) {
        const VertexId v(i);
        if (complex.is_deleted(v) || !complex.is_interface(v)) continue;
        number[i] = static_cast<std::uint32_t>(vertices.size());
        vertices.push_back(v);
        data.surface.vertices.push_back(mesh.position(v));
    }
    for (std::uint32_t i = 0; i < complex.face_capacity(); ++i) {
        const FaceId f(i);
        if (complex.is_deleted(f) || !complex.is_interface(f)) continue;
        // Its normal points out of the tetrahedron with the higher label.
        std::array<TetId, 2> sides = complex.tets(f);
        if (complex.label(sides[0]) < complex.label(sides[1])) std::swap(sides[0], sides[1]);
        const FaceVertices corners = complex.oriented_face(sides[0], complex.index_of(sides[0], f));
        faces.push_back(f);
        data.surface.triangles.push_back(
            {number[corners[0].index()], number[corners[1].index()], number[corners[2].index()]});
        data.sides.push_back({complex.label(sides[1]), complex.label(sides[0])});
    }
}

}  // namespace dsc::dsc3d
