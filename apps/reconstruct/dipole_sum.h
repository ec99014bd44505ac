// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of the dipole kernel over all points of a cloud, by a tree: the winding number of oriented points, its gradient,
// and its adjoint. With d = p - x, r = max(|d|, width of p) and sources p:
//
//     winding number   w(x) = sum of m . d / (4 pi r^3)     m: normal times area
//     gradient of w    -m / r^3 + 3 (m . d) d / r^5, the first term only where |d| < width
//     adjoint          v(x) = sum of s (x - p) / (4 pi r^3)  s: a number
//
// Source: Barill, Dickson, Schmidt, Levin, Jacobson (2018), "Fast winding numbers for soups and clouds"; the
// regularized kernel: Lin, Shi, Liu (2024), "Fast and globally consistent normal orientation based on the winding
// number normal consistency". Guarantee: relative error of about 1 %, which single precision doesn't change; the same
// bits on any number of threads. Cost: some 4 us per target for 20,000 sources, growing with the logarithm of their
// number.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "apps/reconstruct/kd_tree.h"

namespace dsc::reconstruct {

class DipoleSum {
public:
    /// The sources; tree and points have to outlive the sum. Zero threads mean all.
    DipoleSum(const KdTree& tree, std::span<const Point3> points, int threads);

    /// The places where sums are wanted, with what is near and far of each of their groups.
    class Targets {
    public:
        std::size_t size() const { return order_.size(); }

    private:
        friend class DipoleSum;
        static constexpr int group_size = static_cast<int>(KdTree::leaf_size);
        struct Group {
            std::uint32_t begin, end;            ///< in order_
            std::uint32_t far_begin, far_end;    ///< in far_
            std::uint32_t near_begin, near_end;  ///< in near_
        };
        std::vector<Point3> points_;
        std::vector<std::uint32_t> order_;
        std::vector<Group> groups_;
        std::vector<std::uint32_t> far_, near_;  ///< nodes of the sources
    };
    Targets targets(std::span<const Point3> points) const;

    /// `moments`, `strengths` and `widths` have one entry for each source.
    std::vector<double> winding_numbers(const Targets& targets, std::span<const Vector3> moments,
                                        std::span<const double> widths) const;
    std::vector<Vector3> gradients(const Targets& targets, std::span<const Vector3> moments,
                                   std::span<const double> widths) const;
    std::vector<Vector3> adjoints(const Targets& targets, std::span<const double> strengths,
                                  std::span<const double> widths) const;

private:
    template <class Kernel>
    void evaluate(const Targets& targets, std::span<const Vector3> moments, std::span<const double> widths,
                  Kernel&& kernel) const;

    const KdTree& tree_;
    std::span<const Point3> points_;
    int threads_;
};

}  // namespace dsc::reconstruct
