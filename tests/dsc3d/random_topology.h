// SPDX-License-Identifier: GPL-3.0-or-later
// Random changes of a complex without geometry: splits, flips, collapses and labels, each asked for first. They make
// complexes that no coordinates fit, so that what is judged by the connectivity alone has to be right on its own.
#pragma once

#include <array>
#include <vector>

#include "core/random.h"
#include "dsc3d/operations/edge_collapse.h"
#include "dsc3d/operations/flips.h"
#include "dsc3d/operations/split.h"

namespace dsc::tests {

/// A collapse of the complex alone. Precondition: EdgeCollapse::keeps_topology.
inline void collapse(dsc3d::Complex& complex, core::EdgeId e, core::VertexId kept, dsc3d::StarWalker& walker) {
    const dsc3d::EdgeVertices ends = complex.vertices(e);
    const core::VertexId gone = ends[0] == kept ? ends[1] : ends[0];
    const auto star = walker.star(gone);
    const std::vector<core::TetId> removed(star.begin(), star.end());
    std::vector<dsc3d::NewTet> added;
    for (const core::TetId t : removed) {
        if (complex.has_vertex(t, kept)) continue;
        dsc3d::NewTet tet = {complex.vertices(t), complex.label(t)};
        tet.vertices[static_cast<std::size_t>(complex.index_of(t, gone))] = kept;
        added.push_back(tet);
    }
    complex.replace(removed, added);
}

class RandomTopology {
public:
    enum Kind { edge_split, face_split, tet_split, flip_23, flip_32, flip_44, flip_22, edge_collapse, label, kinds };

    /// What adds tetrahedra is left out above `size` of them, collapses below half of that; labels are 0 .. labels - 1.
    RandomTopology(dsc3d::Complex& complex, core::Random& random, std::uint32_t size, int labels = 1)
        : complex_(complex), random_(random), size_(size), labels_(labels), walker_(complex) {}

    /// Tries until something has changed.
    Kind run_one() {
        for (;;) {
            const auto kind = static_cast<Kind>(random_.below(kinds));
            if (!run(kind)) continue;
            ++done_[kind];
            return kind;
        }
    }
    void run(int operations) {
        for (int i = 0; i < operations; ++i) run_one();
    }

    int done(Kind kind) const { return done_[kind]; }

    template <class Handle>
    Handle pick(std::uint32_t capacity) {
        for (;;) {
            const Handle handle(static_cast<std::uint32_t>(random_.below(capacity)));
            if (!complex_.is_deleted(handle)) return handle;
        }
    }
    core::EdgeId pick_edge() { return pick<core::EdgeId>(complex_.edge_capacity()); }
    core::FaceId pick_face() { return pick<core::FaceId>(complex_.face_capacity()); }
    core::TetId pick_tet() { return pick<core::TetId>(complex_.tet_capacity()); }

private:
    bool run(Kind kind) {
        const bool is_small = complex_.tet_count() < size_;
        switch (kind) {
            case edge_split: return is_small && random_.below(4) == 0 && split(complex_, pick_edge()).is_valid();
            case face_split: return is_small && random_.below(4) == 0 && split(complex_, pick_face()).is_valid();
            case tet_split: return is_small && random_.below(4) == 0 && split(complex_, pick_tet()).is_valid();
            case flip_23: {
                const core::FaceId f = pick_face();
                return is_small && can_flip_2_3(complex_, f, walker_) && apply(flip_2_3(complex_, f));
            }
            case flip_32: {
                const core::EdgeId e = pick_edge();
                return can_flip_3_2(complex_, e, walker_) && apply(flip_3_2(complex_, e));
            }
            case flip_44: {
                const core::EdgeId e = pick_edge();
                const auto diagonal = static_cast<dsc3d::Diagonal>(random_.below(2));
                return can_flip_4_4(complex_, e, diagonal, walker_) && apply(flip_4_4(complex_, e, diagonal));
            }
            case flip_22: {
                const core::EdgeId e = pick_edge();
                return can_flip_2_2(complex_, e, walker_) && apply(flip_2_2(complex_, e));
            }
            case edge_collapse: {
                const core::EdgeId e = pick_edge();
                const core::VertexId kept = complex_.vertices(e)[random_.below(2)];
                if (2 * complex_.tet_count() < size_ || !collapse_.keeps_topology(complex_, e, kept, walker_))
                    return false;
                collapse(complex_, e, kept, walker_);
                return true;
            }
            default: break;
        }
        if (labels_ < 2 || random_.below(8) != 0) return false;
        // Mostly regions grow: without that, every face would soon be one of an interface.
        const core::TetId t = pick_tet();
        const core::TetId neighbour = complex_.neighbour(t, static_cast<int>(random_.below(4)));
        const bool grows = neighbour.is_valid() && random_.below(5) != 0;
        complex_.set_label(t, grows ? complex_.label(neighbour)
                                    : static_cast<int>(random_.below(static_cast<std::uint64_t>(labels_))));
        return true;
    }

    bool apply(const dsc3d::Flip& flip) {
        flip.apply(complex_);
        return true;
    }

    dsc3d::Complex& complex_;
    core::Random& random_;
    std::uint32_t size_;
    int labels_;
    dsc3d::StarWalker walker_;
    dsc3d::EdgeCollapse collapse_;
    std::array<int, kinds> done_ = {};
};

}  // namespace dsc::tests
