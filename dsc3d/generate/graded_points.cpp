// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/generate/graded_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>

#include "core/errors.h"

namespace dsc::dsc3d {

namespace {

/// A place of the finest grid, whose spacing is half the smallest leaf.
using Place = std::array<std::int64_t, 3>;

constexpr double max_points = 0x1p22;
constexpr double max_depth = 30;
constexpr const char* too_many = "the edges of the surface are too short for the box: more than 2^22 points";
/// The coarsest leaves are at most this share of the shortest side of the box.
constexpr double coarsest_share = 0.25;

struct PlaceHash {
    std::size_t operator()(const Place& p) const {
        std::uint64_t h = 0;
        for (const std::int64_t i : p) h = (h ^ static_cast<std::uint64_t>(i)) * 0x9e3779b97f4a7c15u, h ^= h >> 29;
        return h;
    }
};

// Points of which none is nearer to another one than that one's radius when it came. Radii differ by the ratio of the
// box to the edges of the surface: there is a grid of every size, and a point is looked for in the one of its radius.
class Disks {
public:
    Disks(double cell, int grids) : cell_(cell), grids_(static_cast<std::size_t>(grids)) {}

    bool try_add(const Point3& p, double radius) {
        std::size_t level = 0;
        while (level + 1 < grids_.size() && size(level) < radius) ++level;
        const Place low = cell_of(p.array() - radius, level), high = cell_of(p.array() + radius, level);
        Place i;
        for (i[0] = low[0]; i[0] <= high[0]; ++i[0])
            for (i[1] = low[1]; i[1] <= high[1]; ++i[1])
                for (i[2] = low[2]; i[2] <= high[2]; ++i[2]) {
                    const auto found = grids_[level].find(i);
                    if (found == grids_[level].end()) continue;
                    for (const Point3& q : found->second)
                        if ((p - q).squaredNorm() < radius * radius) return false;
                }
        for (std::size_t k = 0; k < grids_.size(); ++k) grids_[k][cell_of(p, k)].push_back(p);
        return true;
    }

private:
    double size(std::size_t level) const { return std::ldexp(cell_, static_cast<int>(level)); }
    Place cell_of(const Point3& p, std::size_t level) const {
        const Eigen::Vector3d i = (p / size(level)).array().floor();
        return {static_cast<std::int64_t>(i.x()), static_cast<std::int64_t>(i.y()), static_cast<std::int64_t>(i.z())};
    }

    double cell_;
    std::vector<std::unordered_map<Place, std::vector<Point3>, PlaceHash>> grids_;
};

class Octree {
public:
    Octree(const Eigen::AlignedBox3d& box, const Sizing& sizing, core::Observer& observer,
           const GradedPointsParameters& parameters)
        : box_(box), sizing_(sizing), observer_(observer), parameters_(parameters) {
        const double finest = parameters.leaf * sizing.least_edge_length();
        const double side = box.sizes().minCoeff();
        const double depth = std::floor(std::log2(coarsest_share * side / finest));
        if (!(depth <= max_depth)) fail("the box is more than 2^30 times as large as the edges of the surface");
        depth_ = std::max(0, static_cast<int>(depth));
        const double root = std::min(finest * std::exp2(depth_), side);
        for (std::size_t k = 0; k < 3; ++k) {
            roots_[k] = static_cast<std::int64_t>(std::max(1.0, std::round(box.sizes()[index(k)] / root)));
            size_[k] = roots_[k] << (depth_ + 1);
        }
        const double roots =
            static_cast<double>(roots_[0]) * static_cast<double>(roots_[1]) * static_cast<double>(roots_[2]);
        if (roots > max_points) fail(too_many);
    }

    GradedPoints points() {
        divide_roots();
        std::ranges::stable_sort(candidates_, {}, [](const Candidate& c) { return std::pair(c.priority, c.size); });
        Disks disks(box_.sizes()[0] / static_cast<double>(size_[0] / 2), depth_ + 1);
        GradedPoints result;
        for (const Candidate& candidate : candidates_) {
            check_cancelled();
            const Point3 p = position(candidate.place);
            const Sizing::Answer wanted = sizing_.at(p);
            const bool is_inside = candidate.priority == 3;
            if (is_inside && wanted.distance < parameters_.clearance * wanted.surface_edge_length) continue;
            const bool is_added = disks.try_add(p, parameters_.separation * wanted.edge_length);
            if (is_added || candidate.priority == 0) (is_inside ? result.inside : result.on_box).push_back(p);
        }
        return result;
    }

private:
    struct Candidate {
        int priority;       ///< corners of the box, its edges, its sides, its inside
        std::int64_t size;  ///< of the leaf: small ones come first
        Place place;
    };

    static Eigen::Index index(std::size_t k) { return static_cast<Eigen::Index>(k); }
    [[noreturn]] static void fail(const char* why) { throw core::UsageError(why); }
    void check_cancelled() {
        if (++visited_ % 1024 == 0) observer_.check_cancelled();
    }

    Point3 position(const Place& i) const {
        Point3 p;
        for (std::size_t k = 0; k < 3; ++k) {
            const double share = static_cast<double>(i[k]) / static_cast<double>(size_[k]);
            p[index(k)] =
                i[k] == size_[k] ? box_.max()[index(k)] : box_.min()[index(k)] + share * box_.sizes()[index(k)];
        }
        return p;
    }

    void divide_roots() {
        const std::int64_t size = std::int64_t{2} << depth_;
        Place i;
        for (i[2] = 0; i[2] < roots_[2]; ++i[2])
            for (i[1] = 0; i[1] < roots_[1]; ++i[1])
                for (i[0] = 0; i[0] < roots_[0]; ++i[0]) divide({i[0] * size, i[1] * size, i[2] * size}, size);
    }

    // A leaf is as small as the least edge length wanted in it asks for.
    void divide(const Place& low, std::int64_t size) {
        check_cancelled();
        const Place middle = {low[0] + size / 2, low[1] + size / 2, low[2] + size / 2};
        const Eigen::Vector3d diagonal = position({low[0] + size, low[1] + size, low[2] + size}) - position(low);
        const Sizing::Answer wanted = sizing_.at(position(middle));
        const double least =
            std::max(wanted.surface_edge_length, wanted.edge_length - sizing_.growth() * diagonal.norm() / 2);
        if (size > 2 && diagonal.maxCoeff() > 1.5 * parameters_.leaf * least) {
            for (int octant = 0; octant < 8; ++octant) {
                Place part = low;
                for (int k = 0; k < 3; ++k)
                    if ((octant >> k & 1) != 0) part[static_cast<std::size_t>(k)] = middle[static_cast<std::size_t>(k)];
                divide(part, size / 2);
            }
            return;
        }
        add(middle, size);
        for (int corner = 0; corner < 8; ++corner) {
            Place place = low;
            for (int k = 0; k < 3; ++k)
                if ((corner >> k & 1) != 0) place[static_cast<std::size_t>(k)] += size;
            add(place, size);
        }
    }

    void add(const Place& place, std::int64_t size) {
        if (static_cast<double>(candidates_.size()) > max_points) fail(too_many);
        if (!seen_.insert(place).second) return;
        int priority = 3;
        for (std::size_t k = 0; k < 3; ++k) priority -= place[k] == 0 || place[k] == size_[k] ? 1 : 0;
        candidates_.push_back({priority, size, place});
    }

    Eigen::AlignedBox3d box_;
    const Sizing& sizing_;
    core::Observer& observer_;
    GradedPointsParameters parameters_;
    std::uint64_t visited_ = 0;
    int depth_ = 0;
    Place roots_ = {}, size_ = {};
    std::vector<Candidate> candidates_;
    std::unordered_set<Place, PlaceHash> seen_;
};

}  // namespace

GradedPoints graded_points(const Eigen::AlignedBox3d& box, const Sizing& sizing, core::Observer& observer,
                           const GradedPointsParameters& parameters) {
    return Octree(box, sizing, observer, parameters).points();
}

}  // namespace dsc::dsc3d
