// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/kd_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace dsc::reconstruct {

KdTree::KdTree(std::span<const Point3> points) : points_(points), order_(points.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()));
}

void KdTree::build(std::uint32_t begin, std::uint32_t end) {
    const std::size_t node = nodes_.size();
    nodes_.push_back({{}, begin, end});
    for (std::uint32_t i = begin; i < end; ++i) nodes_[node].box.extend(points_[order_[i]]);
    if (end - begin <= leaf_size) return;
    Eigen::Index axis = 0;
    nodes_[node].box.sizes().maxCoeff(&axis);
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                         return points_[a][axis] != points_[b][axis] ? points_[a][axis] < points_[b][axis] : a < b;
                     });
    build(begin, middle);
    nodes_[node].right = static_cast<std::uint32_t>(nodes_.size());
    build(middle, end);
}

template <class Visit, class Bound>
void KdTree::visit(std::uint32_t node, const Point3& p, Visit& visit_point, Bound& bound) const {
    const Node& here = nodes_[node];
    if (here.is_leaf()) {
        for (std::uint32_t i = here.begin; i < here.end; ++i)
            visit_point(Neighbour{(points_[order_[i]] - p).squaredNorm(), order_[i]});
        return;
    }
    std::uint32_t near = node + 1, far = here.right;
    double near_distance = nodes_[near].box.squaredExteriorDistance(p);
    double far_distance = nodes_[far].box.squaredExteriorDistance(p);
    if (far_distance < near_distance) std::swap(near, far), std::swap(near_distance, far_distance);
    if (near_distance <= bound()) visit(near, p, visit_point, bound);
    if (far_distance <= bound()) visit(far, p, visit_point, bound);
}

void KdTree::nearest(const Point3& p, std::size_t k, std::vector<Neighbour>& found) const {
    found.clear();
    if (nodes_.empty() || k == 0) return;
    const auto bound = [&] {
        return found.size() < k ? std::numeric_limits<double>::infinity() : found.front().squared_distance;
    };
    const auto visit_point = [&](const Neighbour& neighbour) {
        if (found.size() == k) {
            if (!(neighbour < found.front())) return;
            std::pop_heap(found.begin(), found.end());
            found.pop_back();
        }
        found.push_back(neighbour);
        std::push_heap(found.begin(), found.end());
    };
    visit(0, p, visit_point, bound);
    std::sort_heap(found.begin(), found.end());
}

KdTree::Neighbour KdTree::nearest(const Point3& p) const {
    Neighbour best{std::numeric_limits<double>::infinity(), 0};
    const auto bound = [&] { return best.squared_distance; };
    const auto visit_point = [&](const Neighbour& neighbour) { best = std::min(best, neighbour); };
    visit(0, p, visit_point, bound);
    return best;
}

void KdTree::within(const Point3& p, double radius, std::vector<Neighbour>& found) const {
    found.clear();
    if (nodes_.empty()) return;
    const auto bound = [&] { return radius * radius; };
    const auto visit_point = [&](const Neighbour& neighbour) {
        if (neighbour.squared_distance <= radius * radius) found.push_back(neighbour);
    };
    visit(0, p, visit_point, bound);
    std::sort(found.begin(), found.end());
}

}  // namespace dsc::reconstruct
