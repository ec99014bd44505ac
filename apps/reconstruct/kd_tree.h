// SPDX-License-Identifier: GPL-3.0-or-later
// Nearest points of a cloud. Source: Bentley (1975), "Multidimensional binary search trees used for associative
// searching"; split at the median of the longest side of the box. Guarantee: answers ascend by distance, equal ones by
// index; the same bits for the same input. Cost: building n log n, a query of k points about 0.1 us (k + log n).
//
//     const reconstruct::KdTree tree(points);
//     tree.nearest(p, 8, found);  // found[0].index is the nearest one
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/predicates.h"

namespace dsc::reconstruct {

using geometry::Point3;
using Vector3 = Eigen::Vector3d;

class KdTree {
public:
    /// The points have to outlive the tree.
    explicit KdTree(std::span<const Point3> points);

    struct Neighbour {
        double squared_distance;
        std::uint32_t index;
        bool operator<(const Neighbour& other) const {
            return squared_distance != other.squared_distance ? squared_distance < other.squared_distance
                                                              : index < other.index;
        }
    };
    /// The k nearest points, or all when there are fewer.
    void nearest(const Point3& p, std::size_t k, std::vector<Neighbour>& found) const;
    /// The nearest point. Precondition: there is one.
    Neighbour nearest(const Point3& p) const;
    /// All points at most `radius` away.
    void within(const Point3& p, double radius, std::vector<Neighbour>& found) const;

    struct Node {
        Eigen::AlignedBox3d box;   ///< of its points
        std::uint32_t begin, end;  ///< in order()
        std::uint32_t right = 0;   ///< its second child; the first one follows it; 0: a leaf
        bool is_leaf() const { return right == 0; }
    };
    std::span<const Node> nodes() const { return nodes_; }
    /// The points by leaf.
    std::span<const std::uint32_t> order() const { return order_; }

    static constexpr std::uint32_t leaf_size = 16;

private:
    void build(std::uint32_t begin, std::uint32_t end);
    template <class Visit, class Bound>
    void visit(std::uint32_t node, const Point3& p, Visit& visit_point, Bound& bound) const;

    std::span<const Point3> points_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace dsc::reconstruct
