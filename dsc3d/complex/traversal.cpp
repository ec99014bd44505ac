// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/complex/traversal.h"

#include <algorithm>

namespace dsc::dsc3d {

namespace {

// The vertices c, d with which t is the oriented tetrahedron [a b c d].
std::pair<VertexId, VertexId> opposite_edge(const Complex& complex, TetId t, VertexId a, VertexId b) {
    // Rows: place of a; columns: place of b; entries: places of c and d, an even permutation.
    static constexpr std::array<std::array<std::array<std::uint8_t, 2>, 4>, 4> even = {{
        {{{0, 0}, {2, 3}, {3, 1}, {1, 2}}},
        {{{3, 2}, {0, 0}, {0, 3}, {2, 0}}},
        {{{1, 3}, {3, 0}, {0, 0}, {0, 1}}},
        {{{2, 1}, {0, 2}, {1, 0}, {0, 0}}},
    }};
    const TetVertices& v = complex.vertices(t);
    const auto [c, d] =
        even[static_cast<std::size_t>(complex.index_of(t, a))][static_cast<std::size_t>(complex.index_of(t, b))];
    return {v[c], v[d]};
}

}  // namespace

void gather_ring(const Complex& complex, EdgeId e, EdgeRing& ring) {
    ring.a = complex.vertices(e)[0];
    ring.b = complex.vertices(e)[1];
    ring.tets.clear();
    ring.link.clear();
    const TetId first = complex.tet(e);
    TetId t = first;
    if (complex.is_boundary(e)) {
        // Backwards to the boundary face where the ring begins.
        for (;;) {
            const auto [c, d] = opposite_edge(complex, t, ring.a, ring.b);
            const TetId before = complex.neighbour(t, complex.index_of(t, d));
            if (!before.is_valid() || before == first) break;
            t = before;
        }
    }
    const TetId begin = t;
    ring.link.push_back(opposite_edge(complex, t, ring.a, ring.b).first);
    do {
        const auto [c, d] = opposite_edge(complex, t, ring.a, ring.b);
        ring.tets.push_back(t);
        ring.link.push_back(d);
        t = complex.neighbour(t, complex.index_of(t, c));
    } while (t.is_valid() && t != begin);
    ring.is_closed = t.is_valid();
}

void StarWalker::next_epoch() {
    tet_stamp_.resize(complex_->tet_capacity(), 0);
    vertex_stamp_.resize(complex_->vertex_capacity(), 0);
    if (++epoch_ != 0) return;
    std::fill(tet_stamp_.begin(), tet_stamp_.end(), 0u);
    std::fill(vertex_stamp_.begin(), vertex_stamp_.end(), 0u);
    epoch_ = 1;
}

std::span<const TetId> StarWalker::star(VertexId v) {
    return star_while(v, [](TetId) { return true; });
}

std::span<const TetId> StarWalker::star(VertexId a, std::vector<VertexId>& others) {
    const std::span<const TetId> tets = star(a);
    others.clear();
    vertex_stamp_[a.index()] = epoch_;
    for (const TetId t : tets) {
        for (const VertexId v : complex_->vertices(t)) {
            if (vertex_stamp_[v.index()] == epoch_) continue;
            vertex_stamp_[v.index()] = epoch_;
            others.push_back(v);
        }
    }
    return tets;
}

EdgeId StarWalker::edge_between(VertexId a, VertexId b) {
    for (const TetId t : star(a)) {
        if (!complex_->has_vertex(t, b)) continue;
        for (const EdgeId e : complex_->edges(t)) {
            const EdgeVertices& ends = complex_->vertices(e);
            if ((ends[0] == a && ends[1] == b) || (ends[0] == b && ends[1] == a)) return e;
        }
    }
    return {};
}

}  // namespace dsc::dsc3d
