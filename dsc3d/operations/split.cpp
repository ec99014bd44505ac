// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/split.h"

#include <algorithm>
#include <span>
#include <vector>

namespace dsc::dsc3d {

namespace {

// The tetrahedra that have the simplex.
std::vector<TetId> star(const Complex& complex, EdgeId e) {
    EdgeRing ring;
    gather_ring(complex, e, ring);
    return ring.tets;
}
std::vector<TetId> star(const Complex& complex, FaceId f) {
    const auto [first, second] = complex.tets(f);
    return second.is_valid() ? std::vector{first, second} : std::vector{first};
}
std::vector<TetId> star(const Complex&, TetId t) { return {t}; }

std::span<const VertexId> corners(const Complex& complex, EdgeId e) { return complex.vertices(e); }
std::span<const VertexId> corners(const Complex& complex, TetId t) { return complex.vertices(t); }
FaceVertices corners(const Complex& complex, FaceId f) { return complex.vertices(f); }

// A tetrahedron at the simplex has one part per vertex of the simplex: the new vertex is put in its place.
template <class Simplex, class Use>
void for_each_part(const Complex& complex, Simplex simplex, Use&& use) {
    const auto replaced = corners(complex, simplex);
    for (const TetId t : star(complex, simplex))
        for (const VertexId v : replaced) use(t, static_cast<std::size_t>(complex.index_of(t, v)));
}

template <class Simplex>
VertexId split_complex(Complex& complex, Simplex simplex) {
    const VertexId m = complex.add_vertex();
    std::vector<NewTet> parts;
    for_each_part(complex, simplex, [&](TetId t, std::size_t place) {
        NewTet part = {complex.vertices(t), complex.label(t)};
        part.vertices[place] = m;
        parts.push_back(part);
    });
    complex.replace(star(complex, simplex), parts);
    return m;
}

template <class Simplex>
bool can_split_mesh(const Mesh& mesh, Simplex simplex, const Point3& position) {
    bool is_positive = true;
    for_each_part(mesh.complex(), simplex, [&](TetId t, std::size_t place) {
        std::array<Point3, 4> p;
        for (std::size_t i = 0; i < 4; ++i) p[i] = i == place ? position : mesh.position(mesh.complex().vertices(t)[i]);
        is_positive = is_positive && geometry::is_positive(p[0], p[1], p[2], p[3]);
    });
    return is_positive;
}

template <class Simplex>
VertexId split_mesh(Mesh& mesh, Simplex simplex, const Point3& position) {
    DSC_ASSERT(can_split_mesh(mesh, simplex, position));
    const VertexId m = split_complex(mesh.complex(), simplex);
    mesh.set_position(m, position);
    return m;
}

}  // namespace

VertexId split(Complex& complex, EdgeId e) { return split_complex(complex, e); }
VertexId split(Complex& complex, FaceId f) { return split_complex(complex, f); }
VertexId split(Complex& complex, TetId t) { return split_complex(complex, t); }

bool can_split(const Mesh& mesh, EdgeId e, const Point3& position) { return can_split_mesh(mesh, e, position); }
bool can_split(const Mesh& mesh, FaceId f, const Point3& position) { return can_split_mesh(mesh, f, position); }
bool can_split(const Mesh& mesh, TetId t, const Point3& position) { return can_split_mesh(mesh, t, position); }

VertexId split(Mesh& mesh, EdgeId e, const Point3& position) { return split_mesh(mesh, e, position); }
VertexId split(Mesh& mesh, FaceId f, const Point3& position) { return split_mesh(mesh, f, position); }
VertexId split(Mesh& mesh, TetId t, const Point3& position) { return split_mesh(mesh, t, position); }

}  // namespace dsc::dsc3d
