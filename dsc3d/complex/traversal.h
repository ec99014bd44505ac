// SPDX-License-Identifier: GPL-3.0-or-later
// Walks on a complex: the ring of tetrahedra around an edge, the star and the link of a vertex.
// Source: thesis 2.1.1 (star, link), 2.2.2 (partial coboundary). Guarantee: the order depends on the complex only.
// Cost: linear in what is found; buffers are reused, so that nothing is allocated in the long run.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dsc3d/complex/complex.h"

namespace dsc::dsc3d {

/// The tetrahedra at an edge ab in the order in which they follow each other, and the link of the edge.
struct EdgeRing {
    VertexId a, b;
    std::vector<TetId> tets;
    /// Tetrahedron i is [a b link[i] link[i + 1]], oriented; in a closed ring link[tets.size()] is link[0] again.
    std::vector<VertexId> link;
    bool is_closed = false;
};

/// Fills `ring`; on the boundary it goes from one boundary face to the other.
void gather_ring(const Complex& complex, EdgeId e, EdgeRing& ring);

/// Walks the stars of vertices of one complex; what a call returns is valid until the next call.
class StarWalker {
public:
    explicit StarWalker(const Complex& complex) : complex_(&complex) {}

    /// The tetrahedra at v.
    std::span<const TetId> star(VertexId v);

    /// The tetrahedra at v as far as visit(t) returns true for each; empty when it did not for one of them, and then
    /// the rest of the star was not looked at.
    template <class Visit>
    std::span<const TetId> star_while(VertexId v, Visit&& visit) {
        next_epoch();
        star_.clear();
        add(complex_->tet(v));
        for (std::size_t i = 0; i < star_.size(); ++i) {
            const TetId t = star_[i];
            if (!visit(t)) return {};
            const TetVertices& corners = complex_->vertices(t);
            for (int k = 0; k < 4; ++k) {
                if (corners[static_cast<std::size_t>(k)] == v) continue;
                const TetId next = complex_->neighbour(t, k);
                if (next.is_valid() && tet_stamp_[next.index()] != epoch_) add(next);
            }
        }
        return star_;
    }

    /// The tetrahedra at a with, in `others`, their vertices other than a: once each.
    std::span<const TetId> star(VertexId a, std::vector<VertexId>& others);

    /// The edge that joins a and b; invalid when there is none.
    EdgeId edge_between(VertexId a, VertexId b);

private:
    void next_epoch();
    void add(TetId t) {
        tet_stamp_[t.index()] = epoch_;
        star_.push_back(t);
    }

    const Complex* complex_;
    std::vector<TetId> star_;
    std::vector<std::uint32_t> tet_stamp_;
    std::vector<std::uint32_t> vertex_stamp_;
    std::uint32_t epoch_ = 0;
};

}  // namespace dsc::dsc3d
