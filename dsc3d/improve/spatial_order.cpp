// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/improve/spatial_order.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <vector>

namespace dsc::dsc3d {

namespace {

constexpr std::uint32_t new_simplex = std::numeric_limits<std::uint32_t>::max();

// Bit b of x becomes bit 3 b.
std::uint64_t spread(std::uint64_t x) {
    x = (x | x << 32) & 0x001F00000000FFFF;
    x = (x | x << 16) & 0x001F0000FF0000FF;
    x = (x | x << 8) & 0x100F00F00F00F00F;
    x = (x | x << 4) & 0x10C30C30C30C30C3;
    x = (x | x << 2) & 0x1249249249249249;
    return x;
}

// The handles in use, by their keys; equal ones in their present order.
template <class Handle, class Key>
std::vector<Handle> sorted_by(const Complex& complex, std::uint32_t capacity, const core::Attribute<Handle, Key>& key) {
    std::vector<Handle> order;
    for (std::uint32_t i = 0; i < capacity; ++i)
        if (!complex.is_deleted(Handle(i))) order.push_back(Handle(i));
    std::sort(order.begin(), order.end(),
              [&](Handle a, Handle b) { return key[a] != key[b] ? key[a] < key[b] : a < b; });
    return order;
}

// Vertices along a Morton curve of 2^21 cells to a side.
std::vector<VertexId> morton_order(const Mesh& mesh) {
    const Complex& complex = mesh.complex();
    Eigen::AlignedBox3d box;
    for (std::uint32_t i = 0; i < complex.vertex_capacity(); ++i)
        if (!complex.is_deleted(VertexId(i))) box.extend(mesh.position(VertexId(i)));
    const double cells = ((1 << 21) - 1) / box.sizes().maxCoeff();
    core::Attribute<VertexId, std::uint64_t> code(complex.vertex_attributes());
    for (std::uint32_t i = 0; i < complex.vertex_capacity(); ++i) {
        if (complex.is_deleted(VertexId(i))) continue;
        const Eigen::Vector3d place = cells * (mesh.position(VertexId(i)) - box.min());
        for (int axis = 0; axis < 3; ++axis)
            code[VertexId(i)] |= spread(static_cast<std::uint64_t>(place[axis])) << axis;
    }
    return sorted_by(complex, complex.vertex_capacity(), code);
}

}  // namespace

SpatialOrder::SpatialOrder(Mesh& mesh)
    : mesh_(mesh),
      vertex_place_(mesh.complex().vertex_attributes(), new_simplex),
      tet_place_(mesh.complex().tet_attributes(), new_simplex) {
    Complex& complex = mesh.complex();
    for (std::uint32_t i = 0; i < complex.vertex_capacity(); ++i) vertex_place_[VertexId(i)] = i;
    for (std::uint32_t i = 0; i < complex.tet_capacity(); ++i) tet_place_[TetId(i)] = i;
    complex.renumber(morton_order(mesh));
}

void SpatialOrder::restore() {
    Complex& complex = mesh_.complex();
    complex.renumber(sorted_by(complex, complex.vertex_capacity(), vertex_place_),
                     sorted_by(complex, complex.tet_capacity(), tet_place_));
}

}  // namespace dsc::dsc3d
