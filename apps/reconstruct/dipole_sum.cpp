// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/dipole_sum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/parallel.h"

namespace dsc::reconstruct {

namespace {

// A node is far from a group when it is seen under no more than this angle [rad], about.
constexpr double opening = 0.5;

using Lanes = Eigen::Array<float, static_cast<int>(KdTree::leaf_size), 1>;

struct Source {
    std::array<float, 3> place;
    std::array<float, 3> moment;
    float squared_width;
};

// What a kernel gets: all targets of a group against one source, the vectors to it and 1 / r^3.
struct Rays {
    Lanes dx, dy, dz, squared, inverse_cube;
};

}  // namespace

DipoleSum::DipoleSum(const KdTree& tree, std::span<const Point3> points, int threads)
    : tree_(tree), points_(points), threads_(threads) {}

DipoleSum::Targets DipoleSum::targets(std::span<const Point3> points) const {
    Targets result;
    result.points_.assign(points.begin(), points.end());
    const KdTree groups(result.points_);
    result.order_.assign(groups.order().begin(), groups.order().end());
    const std::span<const KdTree::Node> nodes = tree_.nodes();
    std::vector<std::uint32_t> open;
    for (const KdTree::Node& group : groups.nodes()) {
        if (!group.is_leaf()) continue;
        Targets::Group entry{group.begin,
                             group.end,
                             static_cast<std::uint32_t>(result.far_.size()),
                             0,
                             static_cast<std::uint32_t>(result.near_.size()),
                             0};
        const double group_radius = 0.5 * group.box.diagonal().norm();
        open.assign(nodes.empty() ? 0 : 1, 0);
        while (!open.empty()) {
            const std::uint32_t index = open.back();
            open.pop_back();
            const KdTree::Node& node = nodes[index];
            const double reach = 0.5 * node.box.diagonal().norm() + group_radius;
            const double distance = (node.box.center() - group.box.center()).norm();
            if (reach < opening * distance) {
                result.far_.push_back(index);
            } else if (node.is_leaf()) {
                result.near_.push_back(index);
            } else {
                open.insert(open.end(), {node.right, index + 1});
            }
        }
        entry.far_end = static_cast<std::uint32_t>(result.far_.size());
        entry.near_end = static_cast<std::uint32_t>(result.near_.size());
        result.groups_.push_back(entry);
    }
    return result;
}

template <class Kernel>
void DipoleSum::evaluate(const Targets& targets, std::span<const Vector3> moments, std::span<const double> widths,
                         Kernel&& kernel) const {
    const std::span<const KdTree::Node> nodes = tree_.nodes();
    const std::span<const std::uint32_t> order = tree_.order();
    std::vector<Source> near(order.size()), far(nodes.size());
    const auto source = [](const Point3& p, const Vector3& m, double width) {
        return Source{{static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())},
                      {static_cast<float>(m.x()), static_cast<float>(m.y()), static_cast<float>(m.z())},
                      static_cast<float>(width * width)};
    };
    for (std::size_t i = 0; i < order.size(); ++i)
        near[i] = source(points_[order[i]], moments[order[i]], widths[order[i]]);
    // A node acts at the mean of its points, weighted by the size of their moments.
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        Point3 place = Point3::Zero();
        Vector3 moment = Vector3::Zero();
        double weight = 0;
        for (std::uint32_t i = nodes[n].begin; i < nodes[n].end; ++i) {
            const double size = moments[order[i]].norm();
            place += size * points_[order[i]];
            weight += size;
            moment += moments[order[i]];
        }
        far[n] = source(weight > 0 ? Point3(place / weight) : nodes[n].box.center(), moment, 0);
    }
    core::parallel_for(targets.groups_.size(), {.threads = threads_, .grain = 4}, [&](std::size_t g) {
        const Targets::Group& group = targets.groups_[g];
        Lanes x, y, z;
        for (int lane = 0; lane < Targets::group_size; ++lane) {
            const std::uint32_t at = std::min(group.begin + static_cast<std::uint32_t>(lane), group.end - 1);
            const Point3& p = targets.points_[targets.order_[at]];
            x[lane] = static_cast<float>(p.x()), y[lane] = static_cast<float>(p.y()),
            z[lane] = static_cast<float>(p.z());
        }
        std::array<Lanes, 3> sum{Lanes::Zero(), Lanes::Zero(), Lanes::Zero()};
        const auto add = [&](const Source& s) {
            Rays rays;
            rays.dx = s.place[0] - x, rays.dy = s.place[1] - y, rays.dz = s.place[2] - z;
            rays.squared = rays.dx * rays.dx + rays.dy * rays.dy + rays.dz * rays.dz;
            const Lanes r2 = rays.squared.max(s.squared_width);
            rays.inverse_cube = (r2 * r2.sqrt()).inverse();
            kernel(rays, s.moment, s.squared_width, sum);
        };
        for (std::uint32_t i = group.far_begin; i < group.far_end; ++i) add(far[targets.far_[i]]);
        for (std::uint32_t i = group.near_begin; i < group.near_end; ++i) {
            const KdTree::Node& leaf = nodes[targets.near_[i]];
            for (std::uint32_t k = leaf.begin; k < leaf.end; ++k) add(near[k]);
        }
        kernel.store(targets.order_, group.begin, group.end, sum);
    });
}

namespace {

constexpr double per_solid_angle = 1 / (4 * std::numbers::pi);

struct WindingKernel {
    std::vector<double>& result;

    void operator()(const Rays& rays, const std::array<float, 3>& m, float, std::array<Lanes, 3>& sum) const {
        sum[0] += (m[0] * rays.dx + m[1] * rays.dy + m[2] * rays.dz) * rays.inverse_cube;
    }
    void store(const std::vector<std::uint32_t>& order, std::uint32_t begin, std::uint32_t end,
               const std::array<Lanes, 3>& sum) const {
        for (std::uint32_t i = begin; i < end; ++i)
            result[order[i]] = per_solid_angle * static_cast<double>(sum[0][static_cast<int>(i - begin)]);
    }
};

struct VectorResult {
    std::vector<Vector3>& result;

    void store(const std::vector<std::uint32_t>& order, std::uint32_t begin, std::uint32_t end,
               const std::array<Lanes, 3>& sum) const {
        for (std::uint32_t i = begin; i < end; ++i) {
            const int lane = static_cast<int>(i - begin);
            result[order[i]] = per_solid_angle * Vector3(sum[0][lane], sum[1][lane], sum[2][lane]);
        }
    }
};

struct GradientKernel : VectorResult {
    void operator()(const Rays& rays, const std::array<float, 3>& m, float squared_width,
                    std::array<Lanes, 3>& sum) const {
        const Lanes along = (rays.squared >= squared_width)
                                .select(3.0F * (m[0] * rays.dx + m[1] * rays.dy + m[2] * rays.dz) / rays.squared, 0.0F);
        sum[0] += (along * rays.dx - m[0]) * rays.inverse_cube;
        sum[1] += (along * rays.dy - m[1]) * rays.inverse_cube;
        sum[2] += (along * rays.dz - m[2]) * rays.inverse_cube;
    }
};

struct AdjointKernel : VectorResult {
    void operator()(const Rays& rays, const std::array<float, 3>& m, float, std::array<Lanes, 3>& sum) const {
        sum[0] -= m[0] * rays.dx * rays.inverse_cube;
        sum[1] -= m[0] * rays.dy * rays.inverse_cube;
        sum[2] -= m[0] * rays.dz * rays.inverse_cube;
    }
};

}  // namespace

std::vector<double> DipoleSum::winding_numbers(const Targets& targets, std::span<const Vector3> moments,
                                               std::span<const double> widths) const {
    std::vector<double> result(targets.size());
    evaluate(targets, moments, widths, WindingKernel{result});
    return result;
}

std::vector<Vector3> DipoleSum::gradients(const Targets& targets, std::span<const Vector3> moments,
                                          std::span<const double> widths) const {
    std::vector<Vector3> result(targets.size());
    evaluate(targets, moments, widths, GradientKernel{{result}});
    return result;
}

std::vector<Vector3> DipoleSum::adjoints(const Targets& targets, std::span<const double> strengths,
                                         std::span<const double> widths) const {
    std::vector<Vector3> moments(strengths.size());
    for (std::size_t i = 0; i < moments.size(); ++i) moments[i] = Vector3(strengths[i], 0, 0);
    std::vector<Vector3> result(targets.size());
    evaluate(targets, moments, widths, AdjointKernel{{result}});
    return result;
}

}  // namespace dsc::reconstruct
