// SPDX-License-Identifier: GPL-3.0-or-later
// Where a region touches itself, or a wall of the domain, in a vertex or an edge only, after another one has given way
// to it, and what more that one has to give for both to be manifolds there. What lies behind a wall counts as a region
// of its own.
// Source: thesis 2.1.1 (manifold: links are spheres and discs); the thesis relabels without looking at it. Guarantee:
// what is found is of the losing region, so that asking again and again ends. Cost: quadratic in the star.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "dsc3d/deform/pass_context.h"

namespace dsc::dsc3d {

class Pinches {
public:
    /// Tetrahedra at v of the loser that, given to the winner, open a pinch of one of them at v: the least volume that
    /// joins two pieces of the winner (or the winner and a third region that the loser parts), the smaller piece of
    /// the loser, or what it has left at a wall without a face on it. Empty where there is no pinch, and where the
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
    void pieces_off_the_wall(int loser);
    bool is_outside(std::size_t i) const { return i == star_.size(); }
    double volume(const PassContext& context, std::size_t i) const {
        return is_outside(i) ? 0 : context.volume(star_[i]);
    }
    void thin_sectors(PassContext& context, VertexId v, int winner, int loser);

    // What is listed by place in the star has, at a boundary vertex, one entry more for what lies outside.
    std::vector<TetId> star_;
    std::vector<std::vector<std::size_t>> neighbours_;  ///< in the star, across the faces at v
    std::vector<std::optional<int>> label_;             ///< none outside, until that counts as a region's
    std::vector<Piece> pieces_;
    std::vector<int> piece_of_;  ///< -1 for those of other regions
    std::vector<double> cost_;
    std::vector<int> from_;
    std::vector<TetId> found_;
    EdgeRing ring_;
};

}  // namespace dsc::dsc3d
