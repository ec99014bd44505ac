// SPDX-License-Identifier: GPL-3.0-or-later
// What several tests of the 3D engine need.
#pragma once

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "dsc3d/complex/validate.h"
#include "dsc3d/mesh.h"

namespace dsc::tests {

template <class ComplexOrMesh>
void require_valid(const ComplexOrMesh& complex) {
    const std::vector<std::string> problems = validate(complex);
    if (!problems.empty()) FAIL(problems.size() << " violations, first: " << problems.front());
}

/// The handles in use.
template <class Handle>
std::vector<Handle> handles(const dsc3d::Complex& complex, std::uint32_t capacity) {
    std::vector<Handle> found;
    for (std::uint32_t i = 0; i < capacity; ++i)
        if (!complex.is_deleted(Handle(i))) found.emplace_back(i);
    return found;
}
inline auto vertices(const dsc3d::Complex& c) { return handles<core::VertexId>(c, c.vertex_capacity()); }
inline auto edges(const dsc3d::Complex& c) { return handles<core::EdgeId>(c, c.edge_capacity()); }
inline auto faces(const dsc3d::Complex& c) { return handles<core::FaceId>(c, c.face_capacity()); }
inline auto tets(const dsc3d::Complex& c) { return handles<core::TetId>(c, c.tet_capacity()); }

/// An oriented tetrahedron up to even permutations: the one that comes first among them.
inline dsc3d::TetVertices oriented(dsc3d::TetVertices v) {
    const auto first = static_cast<std::size_t>(std::min_element(v.begin(), v.end()) - v.begin());
    if (first != 0) {
        std::swap(v[0], v[first]);
        std::swap(v[first == 1 ? 2 : 1], v[first == 3 ? 2 : 3]);
    }
    std::rotate(v.begin() + 1, std::min_element(v.begin() + 1, v.end()), v.end());
    return v;
}

/// The oriented tetrahedra with their labels: what two complexes with the same vertices have to agree in.
using LabelledTets = std::set<std::pair<dsc3d::TetVertices, int>>;
inline LabelledTets labelled_tets(const dsc3d::Complex& complex) {
    LabelledTets found;
    for (const core::TetId t : tets(complex)) found.emplace(oriented(complex.vertices(t)), complex.label(t));
    return found;
}

inline double volume(const dsc3d::Mesh& mesh, const dsc3d::TetVertices& v) {
    const geometry::Point3& a = mesh.position(v[0]);
    return (mesh.position(v[1]) - a).cross(mesh.position(v[2]) - a).dot(mesh.position(v[3]) - a) / 6;
}

/// Volume by label; their sum is that of the domain.
inline std::map<int, double> volumes(const dsc3d::Mesh& mesh) {
    std::map<int, double> sum;
    for (const core::TetId t : tets(mesh.complex()))
        sum[mesh.complex().label(t)] += volume(mesh, mesh.complex().vertices(t));
    return sum;
}

/// Area of the boundary and the interfaces, by the two labels at a face (-1 for nothing).
inline std::map<std::pair<int, int>, double> surface_areas(const dsc3d::Mesh& mesh) {
    const dsc3d::Complex& complex = mesh.complex();
    std::map<std::pair<int, int>, double> sum;
    for (const core::FaceId f : faces(complex)) {
        if (!complex.is_surface(f)) continue;
        const auto [first, second] = complex.tets(f);
        const int inner = complex.label(first), outer = second.is_valid() ? complex.label(second) : -1;
        const dsc3d::FaceVertices v = complex.vertices(f);
        const geometry::Point3& a = mesh.position(v[0]);
        sum[std::minmax(inner, outer)] += (mesh.position(v[1]) - a).cross(mesh.position(v[2]) - a).norm() / 2;
    }
    return sum;
}

template <class Key>
void require_same(const std::map<Key, double>& before, const std::map<Key, double>& after, double tolerance) {
    double size = 0;
    for (const auto& [key, value] : before) size += std::abs(value);
    REQUIRE(before.size() == after.size());
    for (const auto& [key, value] : before) {
        const auto found = after.find(key);
        REQUIRE(found != after.end());
        if (!(std::abs(value - found->second) <= tolerance * size))
            FAIL("changed by " << value - found->second << " from " << value);
    }
}

/// The edge that joins a and b; invalid when there is none.
inline core::EdgeId edge_between(const dsc3d::Complex& complex, core::VertexId a, core::VertexId b) {
    for (const core::EdgeId e : edges(complex)) {
        const dsc3d::EdgeVertices& ends = complex.vertices(e);
        if ((ends[0] == a && ends[1] == b) || (ends[0] == b && ends[1] == a)) return e;
    }
    return {};
}

}  // namespace dsc::tests
