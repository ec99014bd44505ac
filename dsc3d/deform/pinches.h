// SPDX-License-Identifier: GPL-3.0-or-later
// Where a region touches itself in a vertex or an edge only, after another one has given way to it, and what more that
// one has to give for both to be manifolds there.
// Source: thesis 2.1.1 (manifold: links are spheres and discs); the thesis relabels without looking at it. Guarantee:
// what is found is of the losing region, so that asking again and again ends. Cost: quadratic in the star.
#pragma once

#include <span>
#include <vector>

#include "dsc3d/deform/pass_context.h"

namespace dsc::dsc3d {

class Pinches {
public:
    /// Tetrahedra at v of the loser that, given to the winner, open a pinch of one of them at v: the least volume that
    /// joins two pieces of the winner (or the winner and a third region that the loser parts), or the smaller piece of
    /// the loser. Empty where there is no pinch, and where the
    /// loser has nothing to give. Valid until the next call.
    std::span<const TetId> find(PassContext& context, VertexId v, int winner, int loser);

private:
    struct Piece {
        int label;
        double volume;
    };

    void gather(PassContext& context, VertexId v, int winner, int loser);
    void take_others_as(PassContext& context, int winner, int loser);
    void find_pieces(PassContext& context, int winner, int loser);
    void join_pieces(PassContext& context, int winner, int loser);
    void smallest_piece(int loser);
    void thin_sectors(PassContext& context, VertexId v, int winner, int loser);

    std::vector<TetId> star_;
    std::vector<std::array<int, 3>> neighbours_;  ///< in star_, across the faces at v; -1 at the boundary
    std::vector<int> label_;                      ///< of each in star_
    std::vector<Piece> pieces_;
    std::vector<int> piece_of_;  ///< of each in star_; -1 for those of other regions
    std::vector<double> cost_;
    std::vector<int> from_;
    std::vector<TetId> found_;
    EdgeRing ring_;
};

}  // namespace dsc::dsc3d
