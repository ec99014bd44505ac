// SPDX-License-Identifier: GPL-3.0-or-later
// Volume, components and interface of a label, computed from the tetrahedra alone.
#pragma once

#include <algorithm>
#include <set>
#include <vector>

#include <Eigen/Geometry>

#include "dsc3d/mesh.h"

namespace dsc::tests {

inline double volume_of_label(const dsc3d::Mesh& mesh, int label) {
    double volume = 0;
    for (std::uint32_t i = 0; i < mesh.complex().tet_capacity(); ++i) {
        const dsc3d::TetId t(i);
        if (mesh.complex().is_deleted(t) || mesh.complex().label(t) != label) continue;
        const dsc3d::TetVertices& v = mesh.complex().vertices(t);
        const dsc3d::Point3& a = mesh.position(v[0]);
        volume += (mesh.position(v[1]) - a).dot((mesh.position(v[2]) - a).cross(mesh.position(v[3]) - a)) / 6;
    }
    return volume;
}

/// Parts of a label that are connected through faces.
inline int components_of_label(const dsc3d::Complex& complex, int label) {
    std::set<dsc3d::TetId> open;
    for (std::uint32_t i = 0; i < complex.tet_capacity(); ++i)
        if (!complex.is_deleted(dsc3d::TetId(i)) && complex.label(dsc3d::TetId(i)) == label)
            open.insert(dsc3d::TetId(i));
    int components = 0;
    while (!open.empty()) {
        ++components;
        std::vector<dsc3d::TetId> front = {*open.begin()};
        open.erase(open.begin());
        while (!front.empty()) {
            const dsc3d::TetId t = front.back();
            front.pop_back();
            for (int i = 0; i < 4; ++i) {
                const dsc3d::TetId next = complex.neighbour(t, i);
                if (next.is_valid() && open.erase(next) != 0) front.push_back(next);
            }
        }
    }
    return components;
}

/// The triangles between different labels, by their vertices in ascending order.
inline std::set<dsc3d::FaceVertices> interface_triangles(const dsc3d::Complex& complex) {
    std::set<dsc3d::FaceVertices> triangles;
    for (std::uint32_t i = 0; i < complex.face_capacity(); ++i) {
        const dsc3d::FaceId f(i);
        if (complex.is_deleted(f) || !complex.is_interface(f)) continue;
        dsc3d::FaceVertices corners = complex.vertices(f);
        std::sort(corners.begin(), corners.end());
        triangles.insert(corners);
    }
    return triangles;
}

}  // namespace dsc::tests
