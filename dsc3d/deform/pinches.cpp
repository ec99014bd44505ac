// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/pinches.h"

#include <algorithm>
#include <limits>

#include "core/sort_unique.h"

namespace dsc::dsc3d {

std::span<const TetId> Pinches::find(PassContext& context, VertexId v, int winner, int loser) {
    found_.clear();
    gather(context, v, winner, loser);
    join_pieces(context, winner, loser);
    if (found_.empty()) smallest_piece(loser);
    if (found_.empty()) pieces_off_the_wall(loser);
    if (found_.empty()) {
        // A ring of the loser between the winner and a third region.
        take_others_as(context, winner, loser);
        join_pieces(context, winner, loser);
    }
    if (found_.empty()) thin_sectors(context, v, winner, loser);
    return found_;
}

// The star of v and its pieces of the two regions: what hangs together across faces at v.
void Pinches::gather(PassContext& context, VertexId v, int winner, int loser) {
    const Complex& complex = context.complex();
    const std::span<const TetId> star = context.mesh.walker().star(v);
    star_.assign(star.begin(), star.end());
    std::sort(star_.begin(), star_.end());
    const std::size_t outside = star_.size();
    const std::size_t places = outside + (complex.is_boundary(v) ? 1 : 0);
    neighbours_.resize(places);
    for (std::vector<std::size_t>& neighbours : neighbours_) neighbours.clear();
    for (std::size_t i = 0; i < star_.size(); ++i) {
        for (int k = 0; k < 4; ++k) {
            if (complex.vertices(star_[i])[static_cast<std::size_t>(k)] == v) continue;
            const TetId next = complex.neighbour(star_[i], k);
            const std::size_t place =
                next.is_valid()
                    ? static_cast<std::size_t>(std::lower_bound(star_.begin(), star_.end(), next) - star_.begin())
                    : outside;
            neighbours_[i].push_back(place);
            if (is_outside(place)) neighbours_[outside].push_back(i);
        }
    }
    label_.assign(places, std::nullopt);
    for (std::size_t i = 0; i < star_.size(); ++i) label_[i] = complex.label(star_[i]);
    find_pieces(context, winner, loser);
}

// All but the loser is the winner's.
void Pinches::take_others_as(PassContext& context, int winner, int loser) {
    for (std::optional<int>& label : label_)
        if (label != loser) label = winner;
    find_pieces(context, winner, loser);
}

void Pinches::find_pieces(PassContext& context, int winner, int loser) {
    pieces_.clear();
    piece_of_.assign(label_.size(), -1);
    std::vector<std::size_t> front;
    for (std::size_t first = 0; first < label_.size(); ++first) {
        if (piece_of_[first] >= 0 || (label_[first] != winner && label_[first] != loser)) continue;
        const int label = *label_[first];
        const int piece = static_cast<int>(pieces_.size());
        pieces_.push_back({label, 0});
        piece_of_[first] = piece;
        front = {first};
        while (!front.empty()) {
            const std::size_t i = front.back();
            front.pop_back();
            pieces_.back().volume += volume(context, i);
            for (const std::size_t next : neighbours_[i]) {
                if (piece_of_[next] >= 0 || label_[next] != label) continue;
                piece_of_[next] = piece;
                front.push_back(next);
            }
        }
    }
}

// Dijkstra's way from the first piece of the winner through the loser to another one.
void Pinches::join_pieces(PassContext& context, int winner, int loser) {
    const auto is_winner = [&](int piece) {
        return piece >= 0 && pieces_[static_cast<std::size_t>(piece)].label == winner;
    };
    int first = -1, count = 0;
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
        if (pieces_[p].label != winner) continue;
        if (first < 0) first = static_cast<int>(p);
        ++count;
    }
    if (count < 2) return;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::size_t n = label_.size();
    cost_.assign(n, infinity);
    from_.assign(n, -1);
    std::vector<bool> is_done(n, false);
    for (std::size_t i = 0; i < n; ++i)
        if (piece_of_[i] == first) cost_[i] = 0;
    for (;;) {
        std::size_t here = n;
        for (std::size_t i = 0; i < n; ++i)
            if (!is_done[i] && cost_[i] < infinity && (here == n || cost_[i] < cost_[here])) here = i;
        if (here == n) return;
        is_done[here] = true;
        if (piece_of_[here] != first && is_winner(piece_of_[here])) {
            for (int i = from_[here]; piece_of_[static_cast<std::size_t>(i)] != first;
                 i = from_[static_cast<std::size_t>(i)])
                found_.push_back(star_[static_cast<std::size_t>(i)]);
            return;
        }
        for (const std::size_t next : neighbours_[here]) {
            if (piece_of_[next] < 0) continue;
            const double cost = cost_[here] + (label_[next] == loser ? volume(context, next) : 0);
            if (cost >= cost_[next]) continue;
            cost_[next] = cost;
            from_[next] = static_cast<int>(here);
        }
    }
}

void Pinches::smallest_piece(int loser) {
    int smallest = -1, count = 0;
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
        if (pieces_[p].label != loser) continue;
        ++count;
        if (smallest < 0 || pieces_[p].volume < pieces_[static_cast<std::size_t>(smallest)].volume)
            smallest = static_cast<int>(p);
    }
    if (count < 2) return;
    for (std::size_t i = 0; i < star_.size(); ++i)
        if (piece_of_[i] == smallest) found_.push_back(star_[i]);
}

// What has no face on the wall of v ends there in a point or in edges.
void Pinches::pieces_off_the_wall(int loser) {
    if (label_.size() == star_.size()) return;
    std::vector<bool> is_at_wall(pieces_.size(), false);
    for (const std::size_t i : neighbours_.back())
        if (piece_of_[i] >= 0) is_at_wall[static_cast<std::size_t>(piece_of_[i])] = true;
    for (std::size_t i = 0; i < star_.size(); ++i)
        if (label_[i] == loser && !is_at_wall[static_cast<std::size_t>(piece_of_[i])]) found_.push_back(star_[i]);
}

// At an edge where the winner or the loser has several sectors, the smallest sector of the loser. At a wall the ring is
// open, and what lies outside closes it.
void Pinches::thin_sectors(PassContext& context, VertexId v, int winner, int loser) {
    const Complex& complex = context.complex();
    std::vector<EdgeId> edges;
    for (const TetId t : star_)
        for (const EdgeId e : complex.edges(t)) {
            const auto [a, b] = complex.vertices(e);
            if ((a == v || b == v) && complex.surface_degree(e) > 3) edges.push_back(e);
        }
    core::sort_unique(edges);
    for (const EdgeId e : edges) {
        gather_ring(complex, e, ring_);
        const std::size_t n = ring_.tets.size() + (ring_.is_closed ? 0 : 1);
        const auto label = [&](std::size_t i) -> std::optional<int> {
            if (i % n == ring_.tets.size()) return std::nullopt;
            return complex.label(ring_.tets[i % n]);
        };
        std::size_t begin_of_smallest = n, end_of_smallest = n;
        double least = std::numeric_limits<double>::infinity();
        int sectors_of_winner = 0, sectors_of_loser = 0;
        for (std::size_t i = 0; i < n; ++i) {
            if (label(i) == label(i + n - 1)) continue;
            sectors_of_winner += label(i) == winner ? 1 : 0;
            if (label(i) != loser) continue;
            ++sectors_of_loser;
            std::size_t end = i;
            double volume = 0;
            for (; label(end) == loser; ++end) volume += context.volume(ring_.tets[end % n]);
            if (volume >= least) continue;
            least = volume;
            begin_of_smallest = i;
            end_of_smallest = end;
        }
        if (sectors_of_winner < 2 && sectors_of_loser < 2) continue;
        for (std::size_t i = begin_of_smallest; i < end_of_smallest; ++i) found_.push_back(ring_.tets[i % n]);
        if (!found_.empty()) return;
    }
}

}  // namespace dsc::dsc3d
