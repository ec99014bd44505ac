// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/flips.h"

#include <algorithm>

namespace dsc::dsc3d {

namespace {

VertexId opposite_vertex(const Complex& complex, TetId t, FaceId f) {
    return complex.vertices(t)[static_cast<std::size_t>(complex.index_of(t, f))];
}

EdgeRing ring_of(const Complex& complex, EdgeId e) {
    EdgeRing ring;
    gather_ring(complex, e, ring);
    return ring;
}

// The part of the ring from link[begin] to link[begin + 2] gives way to the tetrahedra at the edge that joins these
// two.
void cut_corner(const Complex& complex, const EdgeRing& ring, std::size_t begin, Flip& flip) {
    const std::size_t n = ring.tets.size();
    const TetId first = ring.tets[begin], second = ring.tets[(begin + 1) % n];
    const VertexId x = ring.link[begin], y = ring.link[begin + 1], z = ring.link[(begin + 1) % n + 1];
    flip.remove(first);
    flip.remove(second);
    flip.add({x, y, z, ring.b}, complex.label(first));
    flip.add({x, z, y, ring.a}, complex.label(first));
}

bool has_one_label(const Complex& complex, const EdgeRing& ring, std::size_t begin) {
    return complex.label(ring.tets[begin]) == complex.label(ring.tets[(begin + 1) % ring.tets.size()]);
}

std::size_t place(Diagonal diagonal) { return diagonal == Diagonal::link_0_2 ? 0 : 1; }

}  // namespace

bool Flip::is_positive(const Mesh& mesh) const {
    const std::span<const NewTet> tets = added();
    return std::all_of(tets.begin(), tets.end(), [&](const NewTet& tet) { return mesh.is_positive(tet.vertices); });
}

bool can_flip_2_3(const Complex& complex, FaceId f, StarWalker& walker) {
    if (complex.is_surface(f)) return false;
    const auto [above, below] = complex.tets(f);
    const VertexId a = opposite_vertex(complex, above, f), b = opposite_vertex(complex, below, f);
    return a != b && !walker.edge_between(a, b).is_valid();
}

Flip flip_2_3(const Complex& complex, FaceId f) {
    const auto [above, below] = complex.tets(f);
    const VertexId a = opposite_vertex(complex, above, f), b = opposite_vertex(complex, below, f);
    const FaceVertices v = complex.oriented_face(above, complex.index_of(above, f));
    Flip flip;
    flip.remove(above);
    flip.remove(below);
    for (std::size_t i = 0; i < 3; ++i) flip.add({a, b, v[i], v[(i + 1) % 3]}, complex.label(above));
    return flip;
}

bool can_flip_3_2(const Complex& complex, EdgeId e, StarWalker& walker) {
    if (complex.is_surface(e)) return false;
    const EdgeRing ring = ring_of(complex, e);
    if (ring.tets.size() != 3) return false;
    const std::span<const TetId> star = walker.star(ring.link[0]);
    return std::none_of(star.begin(), star.end(), [&](TetId t) {
        return complex.has_vertex(t, ring.link[1]) && complex.has_vertex(t, ring.link[2]);
    });
}

Flip flip_3_2(const Complex& complex, EdgeId e) {
    const EdgeRing ring = ring_of(complex, e);
    const int label = complex.label(ring.tets[0]);
    Flip flip;
    for (const TetId t : ring.tets) flip.remove(t);
    flip.add({ring.link[0], ring.link[1], ring.link[2], ring.b}, label);
    flip.add({ring.link[0], ring.link[2], ring.link[1], ring.a}, label);
    return flip;
}

bool can_flip_4_4(const Complex& complex, EdgeId e, Diagonal diagonal, StarWalker& walker) {
    if (complex.is_boundary(e)) return false;
    const EdgeRing ring = ring_of(complex, e);
    const std::size_t begin = place(diagonal);
    return ring.tets.size() == 4 && has_one_label(complex, ring, begin) && has_one_label(complex, ring, begin + 2) &&
           !walker.edge_between(ring.link[begin], ring.link[begin + 2]).is_valid();
}

Flip flip_4_4(const Complex& complex, EdgeId e, Diagonal diagonal) {
    const EdgeRing ring = ring_of(complex, e);
    Flip flip;
    cut_corner(complex, ring, place(diagonal), flip);
    cut_corner(complex, ring, place(diagonal) + 2, flip);
    return flip;
}

bool can_flip_2_2(const Complex& complex, EdgeId e, StarWalker& walker) {
    if (!complex.is_boundary(e)) return false;
    const EdgeRing ring = ring_of(complex, e);
    return ring.tets.size() == 2 && has_one_label(complex, ring, 0) &&
           !walker.edge_between(ring.link[0], ring.link[2]).is_valid();
}

Flip flip_2_2(const Complex& complex, EdgeId e) {
    Flip flip;
    cut_corner(complex, ring_of(complex, e), 0, flip);
    return flip;
}

}  // namespace dsc::dsc3d
