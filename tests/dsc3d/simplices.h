// SPDX-License-Identifier: GPL-3.0-or-later
// The textbook's complex, to compare with: sets of simplices, each a set of vertices, with closure, star and link by
// their definitions (thesis 2.1.1). Slow on purpose.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <vector>

#include "dsc3d/complex/complex.h"

namespace dsc::tests {

using Simplex = std::set<std::uint32_t>;
using Simplices = std::set<Simplex>;

template <class Vertices>
Simplex simplex(const Vertices& vertices) {
    Simplex result;
    for (const core::VertexId v : vertices) result.insert(v.index());
    return result;
}
inline Simplex simplex(core::VertexId v) { return {v.index()}; }

inline int dimension(const Simplex& s) { return static_cast<int>(s.size()) - 1; }
inline bool is_face(const Simplex& face, const Simplex& of) {
    return std::includes(of.begin(), of.end(), face.begin(), face.end());
}

/// All non-empty subsets.
inline Simplices closure(const Simplex& s) {
    const std::vector<std::uint32_t> vertices(s.begin(), s.end());
    Simplices faces;
    for (std::size_t mask = 1; mask < (std::size_t{1} << vertices.size()); ++mask) {
        Simplex face;
        for (std::size_t i = 0; i < vertices.size(); ++i)
            if ((mask >> i & 1) != 0) face.insert(vertices[i]);
        faces.insert(face);
    }
    return faces;
}
inline Simplices closure(const Simplices& simplices) {
    Simplices all;
    for (const Simplex& s : simplices) all.merge(closure(s));
    return all;
}

/// Those of `complex` that have s as a face.
inline Simplices star(const Simplices& complex, const Simplex& s) {
    Simplices found;
    for (const Simplex& t : complex)
        if (is_face(s, t)) found.insert(t);
    return found;
}

/// cl(st(s)) - st(cl(s))
inline Simplices link(const Simplices& complex, const Simplex& s) {
    Simplices found = closure(star(complex, s));
    for (const Simplex& face : closure(s))
        for (const Simplex& t : star(complex, face)) found.erase(t);
    return found;
}

inline Simplices filter(const Simplices& simplices, int of_dimension) {
    Simplices found;
    for (const Simplex& s : simplices)
        if (dimension(s) == of_dimension) found.insert(s);
    return found;
}

inline Simplices intersection(const Simplices& a, const Simplices& b) {
    Simplices common;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::inserter(common, common.end()));
    return common;
}

inline int euler_characteristic(const Simplices& complex) {
    int sum = 0;
    for (const Simplex& s : complex) sum += dimension(s) % 2 == 0 ? 1 : -1;
    return sum;
}

/// All simplices of a complex, from its tetrahedra alone.
inline Simplices simplices_of(const dsc3d::Complex& complex) {
    Simplices tets;
    for (std::uint32_t i = 0; i < complex.tet_capacity(); ++i)
        if (!complex.is_deleted(core::TetId(i))) tets.insert(simplex(complex.vertices(core::TetId(i))));
    return closure(tets);
}

/// The faces between two labels or of one tetrahedron, with their edges and vertices, from the tetrahedra alone.
inline Simplices surface_of(const dsc3d::Complex& complex) {
    std::map<Simplex, std::vector<int>> labels_at_face;
    for (std::uint32_t i = 0; i < complex.tet_capacity(); ++i) {
        const core::TetId t(i);
        if (complex.is_deleted(t)) continue;
        for (const Simplex& face : filter(closure(simplex(complex.vertices(t))), 2))
            labels_at_face[face].push_back(complex.label(t));
    }
    Simplices faces;
    for (const auto& [face, labels] : labels_at_face)
        if (labels.size() == 1 || labels[0] != labels[1]) faces.insert(face);
    return closure(faces);
}

}  // namespace dsc::tests
