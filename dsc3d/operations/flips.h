// SPDX-License-Identifier: GPL-3.0-or-later
// The flips 2-3, 3-2, 4-4 and 2-2: the smallest exchanges of tetrahedra that keep all vertices.
//
//     2-3  an inner face gives way to the edge that joins the two vertices opposite to it
//     3-2  an inner edge of three tetrahedra gives way to the face of its link: the inverse of 2-3
//     4-4  an inner edge of four tetrahedra gives way to one of the two diagonals of its link
//     2-2  a boundary edge of two tetrahedra gives way to the other diagonal of its two boundary faces
//
// 4-4 and 2-2 also exchange the two surface faces at the edge, where these are the two sides of the new edge.
// Source: thesis 3.2.2, Fig. 3.3. Guarantee: can_flip_x says, from the connectivity alone, whether the result is a
// manifold complex again whose regions have the same topology. Whether the new tetrahedra are positive, and whether
// surface faces that are exchanged lie in one plane, is a question of geometry: ask the flip before it is done.
// Cost: linear in one star, for the question whether the new edge or face is there already.
//
//     if (can_flip_2_3(mesh.complex(), f, walker)) {
//         const Flip flip = flip_2_3(mesh.complex(), f);
//         if (flip.is_positive(mesh)) flip.apply(mesh.complex());
//     }
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "dsc3d/complex/traversal.h"
#include "dsc3d/mesh.h"

namespace dsc::dsc3d {

/// What a flip takes away and puts in its place; valid until the complex changes.
class Flip {
public:
    std::span<const TetId> removed() const { return {removed_.data(), removed_count_}; }
    std::span<const NewTet> added() const { return {added_.data(), added_count_}; }

    /// Whether the new tetrahedra are positive, by exact predicate.
    bool is_positive(const Mesh& mesh) const;

    const Complex::Change& apply(Complex& complex) const { return complex.replace(removed(), added()); }

    void remove(TetId t) { removed_[removed_count_++] = t; }
    void add(const TetVertices& vertices, int label) { added_[added_count_++] = {vertices, label}; }

private:
    std::array<TetId, 4> removed_;
    std::array<NewTet, 4> added_;
    std::size_t removed_count_ = 0;
    std::size_t added_count_ = 0;
};

/// f lies inside a region, and the vertices opposite to it are not joined.
bool can_flip_2_3(const Complex& complex, FaceId f, StarWalker& walker);
/// Precondition: can_flip_2_3.
Flip flip_2_3(const Complex& complex, FaceId f);

/// e lies inside a region and has three tetrahedra, and the three vertices of its link have no face.
bool can_flip_3_2(const Complex& complex, EdgeId e, StarWalker& walker);
/// Precondition: can_flip_3_2.
Flip flip_3_2(const Complex& complex, EdgeId e);

/// Which vertices of the link of an edge, in the order of gather_ring, the new edge joins.
enum class Diagonal : std::uint8_t { link_0_2, link_1_3 };

/// e is not on the boundary and has four tetrahedra, those on one side of the new edge of one label, and the two
/// vertices are not joined. With two labels, the interface runs along the old and along the new edge.
bool can_flip_4_4(const Complex& complex, EdgeId e, Diagonal diagonal, StarWalker& walker);
/// Precondition: can_flip_4_4. In the new ring, either the new edge's `link_0_2` or its `link_1_3` is the old edge.
Flip flip_4_4(const Complex& complex, EdgeId e, Diagonal diagonal);

/// e lies on the boundary and has two tetrahedra of one label, and the ends of its link, which the new edge joins, are
/// not joined.
bool can_flip_2_2(const Complex& complex, EdgeId e, StarWalker& walker);
/// Precondition: can_flip_2_2.
Flip flip_2_2(const Complex& complex, EdgeId e);

}  // namespace dsc::dsc3d
