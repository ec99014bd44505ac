// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/cloud.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/disjoint_sets.h"
#include "core/errors.h"
#include "core/parallel.h"
#include "core/require.h"

namespace dsc::reconstruct {

namespace {

constexpr std::size_t popularity_neighbours = 8;

// The first of equal points, in the order of the input.
std::vector<std::uint32_t> different_points(std::span<const Point3> points) {
    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto less = [&](std::uint32_t a, std::uint32_t b) {
        for (int k = 0; k < 3; ++k)
            if (points[a][k] != points[b][k]) return points[a][k] < points[b][k];
        return a < b;
    };
    std::sort(order.begin(), order.end(), less);
    order.erase(std::unique(order.begin(), order.end(),
                            [&](std::uint32_t a, std::uint32_t b) { return points[a] == points[b]; }),
                order.end());
    std::sort(order.begin(), order.end());
    return order;
}

// Of the points as a whole: 1, 2 or 3.
int dimension(std::span<const Point3> points) {
    constexpr double flat = 1e-7;  // extent that rounding makes of none, relative: the root of that of its square
    Point3 mean = Point3::Zero();
    for (const Point3& p : points) mean += p / static_cast<double>(points.size());
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    for (const Point3& p : points) moments += (p - mean) * (p - mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments);
    const Vector3 extent = solver.eigenvalues().cwiseMax(0).cwiseSqrt();
    return static_cast<int>((extent.array() > flat * extent[2]).count());
}

void scale_to_unit_box(Cloud& cloud) {
    Eigen::AlignedBox3d box;
    for (const Point3& p : cloud.points) box.extend(p);
    const double scale = box.diagonal().norm();
    const Point3 centre = box.center();
    for (Point3& p : cloud.points) p = (p - centre) / scale;
    cloud.origin += cloud.scale * centre;
    cloud.scale *= scale;
}

double distance_to_neighbour(const Cloud& cloud, std::size_t i, std::size_t k) {
    const std::span<const std::uint32_t> neighbours = cloud.neighbours_of(i);
    return (cloud.points[neighbours[std::min(k, neighbours.size()) - 1]] - cloud.points[i]).norm();
}

std::vector<std::uint8_t> strays(const Cloud& cloud, const CloudParameters& parameters) {
    const std::size_t n = cloud.size();
    const std::size_t k = std::min<std::size_t>(popularity_neighbours, cloud.neighbour_count);
    std::vector<double> reach(n);
    std::vector<int> popularity(n, 0);
    for (std::size_t i = 0; i < n; ++i) {
        reach[i] = distance_to_neighbour(cloud, i, k);
        for (const std::uint32_t j : cloud.neighbours_of(i).first(k)) ++popularity[j];
    }
    std::vector<std::uint8_t> is_stray(n, 0);
    std::vector<double> others;
    for (std::size_t i = 0; i < n; ++i) {
        others.clear();
        for (const std::uint32_t j : cloud.neighbours_of(i).first(k)) others.push_back(reach[j]);
        std::nth_element(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(k / 2), others.end());
        is_stray[i] =
            reach[i] > parameters.stray_distance * others[k / 2] || popularity[i] <= parameters.stray_popularity ? 1
                                                                                                                 : 0;
    }
    // Parts hang together by neighbours of each other: those of a stray are on the surface, but not the other way
    // round.
    core::DisjointSets parts(n);
    std::vector<std::size_t> size(n, 0);
    for (std::uint32_t i = 0; i < n; ++i)
        for (const std::uint32_t j : cloud.neighbours_of(i).first(k)) {
            const bool is_mutual =
                std::ranges::find(cloud.neighbours_of(j).first(k), i) != cloud.neighbours_of(j).first(k).end();
            if (is_mutual && is_stray[i] == 0 && is_stray[j] == 0) parts.unite(i, j);
        }
    for (std::size_t i = 0; i < n; ++i) ++size[parts.find(i)];
    const double least = parameters.stray_part * static_cast<double>(n);
    for (std::size_t i = 0; i < n; ++i)
        if (static_cast<double>(size[parts.find(i)]) < least) is_stray[i] = 1;
    return is_stray;
}

// True when there were any.
bool remove_strays(Cloud& cloud, const CloudParameters& parameters) {
    const std::vector<std::uint8_t> is_stray = strays(cloud, parameters);
    const auto count = static_cast<std::size_t>(std::count(is_stray.begin(), is_stray.end(), 1));
    if (count == 0 || cloud.size() - count < 4) return false;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < is_stray.size(); ++i) {
        if (is_stray[i] != 0) {
            cloud.strays.push_back(cloud.original[i]);
            continue;
        }
        cloud.points[kept] = cloud.points[i];
        cloud.original[kept++] = cloud.original[i];
    }
    cloud.points.resize(kept);
    cloud.original.resize(kept);
    return true;
}

void measure_spacing(Cloud& cloud, const CloudParameters& parameters) {
    const std::size_t n = cloud.size();
    const std::size_t k = std::min<std::size_t>(parameters.spacing_neighbours, cloud.neighbour_count);
    std::vector<double> raw(n);
    for (std::size_t i = 0; i < n; ++i)
        raw[i] = distance_to_neighbour(cloud, i, k) * std::sqrt(std::numbers::pi / static_cast<double>(k));
    cloud.spacing.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        double sum = raw[i];
        for (const std::uint32_t j : cloud.neighbours_of(i)) sum += raw[j];
        cloud.spacing[i] = sum / (1 + cloud.neighbour_count);
    }
    std::vector<double> sorted = cloud.spacing;
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(n / 2), sorted.end());
    cloud.median_spacing = sorted[n / 2];
}

}  // namespace

void CloudParameters::validate() const {
    core::require(neighbours >= 8, "neighbours", "at least 8");
    core::require(spacing_neighbours >= 4 && spacing_neighbours <= neighbours, "spacing_neighbours",
                  "in [4, neighbours]");
    core::require(stray_distance > 1, "stray_distance", "greater than 1");
    core::require(stray_popularity >= 0, "stray_popularity", "at least 0");
    core::require(stray_part >= 0 && stray_part < 1, "stray_part", "in [0, 1)");
}

void set_neighbours(Cloud& cloud, std::size_t count) {
    const std::size_t n = cloud.size();
    cloud.neighbour_count = static_cast<std::uint32_t>(std::min(count, n - 1));
    cloud.neighbours.resize(n * cloud.neighbour_count);
    const KdTree tree(cloud.points);
    core::parallel_for(n, {.threads = cloud.threads}, [&](std::size_t i) {
        std::vector<KdTree::Neighbour> found;
        tree.nearest(cloud.points[i], cloud.neighbour_count + 1, found);
        // Itself comes first: no other point is at the same place.
        for (std::size_t k = 0; k < cloud.neighbour_count; ++k)
            cloud.neighbours[i * cloud.neighbour_count + k] = found[k + 1].index;
    });
}

Cloud prepared_cloud(std::span<const Point3> points, const CloudParameters& parameters, const std::string& source,
                     int threads) {
    parameters.validate();
    Cloud cloud;
    cloud.threads = threads;
    cloud.original = different_points(points);
    cloud.duplicates = points.size() - cloud.original.size();
    if (cloud.original.size() < 4)
        throw core::InputError(source, "", "only " + std::to_string(cloud.original.size()) + " different points",
                               "a closed surface needs at least 4, and some hundred to look like something");
    // Sizes first, so that nothing overflows or vanishes.
    Eigen::AlignedBox3d box;
    for (const std::uint32_t i : cloud.original) box.extend(points[i]);
    if (!std::isfinite(box.sizes().squaredNorm()) || !(box.sizes().squaredNorm() > 0))
        throw core::InputError(source, "", "coordinates too large or too small to be measured", "change their unit");
    for (const std::uint32_t i : cloud.original) cloud.points.push_back(points[i]);
    set_neighbours(cloud, static_cast<std::size_t>(parameters.neighbours));
    constexpr int most_rounds = 8;  // strays hide each other
    for (int round = 0; round < most_rounds && remove_strays(cloud, parameters); ++round)
        set_neighbours(cloud, static_cast<std::size_t>(parameters.neighbours));
    std::sort(cloud.strays.begin(), cloud.strays.end());
    // Now only: moved to the middle of a box with strays the others would lose their digits.
    scale_to_unit_box(cloud);
    const int extent = dimension(cloud.points);
    if (extent < 3)
        throw core::InputError(source, "", std::string("all points are ") + (extent < 2 ? "on a line" : "in a plane"),
                               "a closed surface needs points around a volume");
    measure_spacing(cloud, parameters);
    return cloud;
}

}  // namespace dsc::reconstruct
