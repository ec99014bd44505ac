// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/octree_points.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dsc::reconstruct {

namespace {

constexpr int deepest = 18;  // levels; places are numbered in half leaves of that level
constexpr double divided_above = 1.41;
constexpr double half_space_diagonal = 0.8660254037844386;

class Octree {
public:
    Octree(const KdTree& tree, std::span<const double> cell, double growth, double half_side)
        : tree_(tree), cell_(cell), growth_(growth), half_side_(half_side) {}

    std::vector<Point3> points() {
        divide({0, 0, 0}, 0);
        // The first occurrence of each stays in its place.
        std::vector<std::pair<std::uint64_t, std::uint32_t>> sorted;
        sorted.reserve(keys_.size());
        for (const std::uint64_t key : keys_) sorted.emplace_back(key, static_cast<std::uint32_t>(sorted.size()));
        std::sort(sorted.begin(), sorted.end());
        std::vector<std::uint8_t> is_first(keys_.size(), 0);
        for (std::size_t i = 0; i < sorted.size(); ++i)
            if (i == 0 || sorted[i].first != sorted[i - 1].first) is_first[sorted[i].second] = 1;
        std::vector<Point3> result;
        for (std::size_t i = 0; i < keys_.size(); ++i)
            if (is_first[i] != 0) result.push_back(place(keys_[i]));
        return result;
    }

private:
    using Index = std::array<std::uint64_t, 3>;
    static constexpr std::uint64_t whole = std::uint64_t{2} << deepest;
    static constexpr int bits = deepest + 2;

    static std::uint64_t key(const Index& at) { return (at[0] << (2 * bits)) | (at[1] << bits) | at[2]; }

    Point3 place(std::uint64_t key) const {
        constexpr std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
        const Point3 at(static_cast<double>(key >> (2 * bits)), static_cast<double>((key >> bits) & mask),
                        static_cast<double>(key & mask));
        return (at / static_cast<double>(whole) - Point3::Constant(0.5)) * (2 * half_side_);
    }

    void divide(const Index& corner, int level) {
        const std::uint64_t side = whole >> level;
        const Index centre{corner[0] + side / 2, corner[1] + side / 2, corner[2] + side / 2};
        const double length = 2 * half_side_ / std::ldexp(1, level);
        const KdTree::Neighbour near = tree_.nearest(place(key(centre)));
        const double distance = std::max(0.0, std::sqrt(near.squared_distance) - half_space_diagonal * length);
        if (level < deepest && length > divided_above * cell_[near.index] + growth_ * distance) {
            for (std::uint64_t k = 0; k < 8; ++k)
                divide({corner[0] + (k & 1) * (side / 2), corner[1] + (k >> 1 & 1) * (side / 2),
                        corner[2] + (k >> 2) * (side / 2)},
                       level + 1);
            return;
        }
        for (std::uint64_t k = 0; k < 8; ++k)
            keys_.push_back(
                key({corner[0] + (k & 1) * side, corner[1] + (k >> 1 & 1) * side, corner[2] + (k >> 2) * side}));
        keys_.push_back(key(centre));
    }

    const KdTree& tree_;
    std::span<const double> cell_;
    double growth_, half_side_;
    std::vector<std::uint64_t> keys_;
};

}  // namespace

std::vector<Point3> octree_points(const KdTree& tree, std::span<const double> cell, double growth, double half_side) {
    return Octree(tree, cell, growth, half_side).points();
}

}  // namespace dsc::reconstruct
