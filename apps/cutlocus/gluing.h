// SPDX-License-Identifier: GPL-3.0-or-later
// The gluing of the circle of directions. A surface cut open along the cut locus of p is a disc around p, whose
// boundary is the circle of directions with its points identified in pairs: both directions of a pair end in the same
// point of the cut locus. From pairs alone, in the order of their directions, follow the arcs, the end points and the
// branch points, and the Euler characteristic of the surface.
//
// A gap is the interval between two directions that are neighbours on the circle. Walking round a vertex of the cut
// locus leads from one gap to the next: across the pair at the gap's far end. A walk that closes after one gap goes
// round an end point, after two along an arc, after k >= 3 round a branch point of degree k.
#pragma once

#include <numbers>
#include <span>
#include <vector>

#include "geodesic/metric.h"

namespace dsc::cutlocus {

/// Two directions whose geodesics meet at length t: E(theta1, t) = E(theta2, t) + translation(lattice).
struct DirectionPair {
    double theta1 = 0, theta2 = 0;
    double t = 0;
    geodesic::LatticeVector lattice{0, 0};
};

class Gluing {
public:
    /// One of the two directions of a pair.
    struct Entry {
        double theta = 0;  ///< in [0, 2π)
        int pair = 0;      ///< index of the pair
        int side = 0;      ///< 0: theta1, 1: theta2
    };
    /// The gaps met on the way round one vertex, in the order of the walk. A walk that is not closed runs from a gap
    /// that holds free directions to another one; it belongs to an arc that leaves the disc.
    struct Walk {
        std::vector<int> gaps;
        bool is_closed = true;
    };

    /// `free_directions` (any order, may be empty) belong to geodesics that were followed to the largest distance asked
    /// for without meeting another one.
    Gluing(std::span<const DirectionPair> pairs, std::span<const double> free_directions);

    int size() const { return static_cast<int>(entries_.size()); }
    /// Entries in the order of theta; index k is taken modulo size().
    const Entry& entry(int k) const { return entries_[static_cast<std::size_t>(wrapped(k))]; }
    /// Index of the other direction of the same pair.
    int partner(int k) const { return partners_[static_cast<std::size_t>(wrapped(k))]; }
    int index_of(int pair, int side) const { return positions_[static_cast<std::size_t>(2 * pair + side)]; }
    /// Gap k lies between entries k and k + 1. True if it holds free directions.
    bool is_open(int gap) const { return is_open_[static_cast<std::size_t>(wrapped(gap))] != 0; }
    int wrapped(int k) const { return (k % size() + size()) % size(); }

    /// The gap that follows `gap` on the way round a vertex.
    int next_gap(int gap) const { return partner(gap + 1); }
    /// True if the pairs on both ends of the gap follow each other on one arc.
    bool is_inside_arc(int gap) const;
    /// All walks; every gap is in one closed walk, every open gap begins one open walk and ends one.
    std::vector<Walk> walks() const;
    /// Vertices - edges + face of the closed surface that the gluing makes. Precondition: no open gaps.
    int euler_characteristic() const;

private:
    std::vector<Entry> entries_;
    std::vector<int> partners_;
    std::vector<int> positions_;
    std::vector<char> is_open_;
};

/// `theta` brought to [0, 2π).
double wrapped_angle(double theta);

/// [rad]
inline constexpr double full_turn = 2 * std::numbers::pi;

}  // namespace dsc::cutlocus
