// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/local_length.h"

#include <algorithm>
#include <limits>

namespace dsc::dsc3d {

LocalLength::LocalLength(const Mesh& mesh, double on_interface, double growth)
    : growth_(growth), length_(mesh.complex().vertex_attributes(), on_interface) {
    const Complex& complex = mesh.complex();
    constexpr double unknown = std::numeric_limits<double>::infinity();
    bool has_interface = false;
    for (std::uint32_t i = 0; i < complex.vertex_capacity(); ++i)
        has_interface = has_interface || (!complex.is_deleted(VertexId(i)) && complex.is_interface(VertexId(i)));
    if (!has_interface) return;
    for (std::uint32_t i = 0; i < complex.vertex_capacity(); ++i)
        if (!complex.is_deleted(VertexId(i)) && !complex.is_interface(VertexId(i))) length_[VertexId(i)] = unknown;
    for (bool has_changed = true; has_changed;) {
        has_changed = false;
        for (std::uint32_t i = 0; i < complex.edge_capacity(); ++i) {
            if (complex.is_deleted(EdgeId(i))) continue;
            const auto [a, b] = complex.vertices(EdgeId(i));
            const double rise = growth_ * (mesh.position(a) - mesh.position(b)).norm();
            for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
                if (length_[from] + rise >= length_[to]) continue;
                length_[to] = length_[from] + rise;
                has_changed = true;
            }
        }
    }
}

void LocalLength::update(RatedMesh& mesh, std::span<const VertexId> vertices) {
    const Complex& complex = mesh.complex();
    const auto allowed = [&](VertexId v) {
        double length = std::numeric_limits<double>::infinity();
        for (const TetId t : mesh.walker().star(v))
            for (const VertexId u : complex.vertices(t))
                if (u != v)
                    length = std::min(length, length_[u] + growth_ * (mesh.position(u) - mesh.position(v)).norm());
        return length;
    };
    for (const VertexId v : vertices)
        if (!complex.is_interface(v)) length_[v] = allowed(v);
    // Those that come early may have followed neighbours that have become smaller since.
    for (bool has_changed = true; has_changed;) {
        has_changed = false;
        for (const VertexId v : vertices) {
            if (complex.is_interface(v)) continue;
            const double length = allowed(v);
            if (length >= length_[v]) continue;
            length_[v] = length;
            has_changed = true;
        }
    }
}

}  // namespace dsc::dsc3d
