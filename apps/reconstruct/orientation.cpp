// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/orientation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

#include "apps/reconstruct/dipole_sum.h"
#include "core/require.h"

namespace dsc::reconstruct {

namespace {

struct Thinned {
    std::vector<std::uint32_t> index;  ///< in the cloud
    double spacing;                    ///< least distance of two of them
};

// No two nearer than `distance`, in the order of the cloud: greedy.
std::vector<std::uint32_t> poisson_sample(const Cloud& cloud, const KdTree& tree, double distance) {
    std::vector<std::uint8_t> is_covered(cloud.size(), 0);
    std::vector<std::uint32_t> kept;
    std::vector<KdTree::Neighbour> near;
    for (std::uint32_t i = 0; i < cloud.size(); ++i) {
        if (is_covered[i] != 0) continue;
        kept.push_back(i);
        tree.within(cloud.points[i], distance, near);
        for (const KdTree::Neighbour& other : near) is_covered[other.index] = 1;
    }
    return kept;
}

Thinned thinned(const Cloud& cloud, std::size_t most_points, double least_distance) {
    const KdTree tree(cloud.points);
    double distance = std::max(0.5 * cloud.median_spacing, least_distance);
    for (;;) {
        std::vector<std::uint32_t> kept = poisson_sample(cloud, tree, distance);
        if (kept.size() <= most_points) return {std::move(kept), distance};
        distance *= std::sqrt(1.05 * static_cast<double>(kept.size()) / static_cast<double>(most_points));
    }
}

double dot(std::span<const Vector3> a, std::span<const Vector3> b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
    return sum;
}

// Moments of the thinned points from nothing.
std::vector<Vector3> consistent_moments(std::span<const Point3> points, double spacing, int threads,
                                        const OrientationParameters& parameters, core::Observer& observer) {
    const KdTree tree(points);
    const DipoleSum sum(tree, points, threads);
    const DipoleSum::Targets targets = sum.targets(points);
    const std::size_t n = points.size();
    std::vector<Vector3> moments(n, Vector3::Zero());
    for (int round = 0; round < parameters.rounds; ++round) {
        observer.check_cancelled();
        observer.progress("orienting", static_cast<double>(round) / parameters.rounds, "");
        const double share = parameters.rounds > 1 ? static_cast<double>(round) / (parameters.rounds - 1) : 1;
        const std::vector<double> width(
            n, spacing * (parameters.first_width + share * (parameters.last_width - parameters.first_width)));
        std::vector<double> missing = sum.winding_numbers(targets, moments, width);
        for (double& w : missing) w = 0.5 - w;
        const std::vector<Vector3> descent = sum.adjoints(targets, missing, width);
        const std::vector<double> effect = sum.winding_numbers(targets, descent, width);
        double squared = 0;
        for (const double e : effect) squared += e * e;
        if (squared == 0) break;
        const double step = dot(descent, descent) / squared;
        for (std::size_t i = 0; i < n; ++i) moments[i] += step * descent[i];
        const std::vector<Vector3> gradient = sum.gradients(targets, moments, width);
        for (std::size_t i = 0; i < n; ++i) {
            const double length = gradient[i].norm();
            if (length > 0) moments[i] = -moments[i].norm() / length * gradient[i];
        }
    }
    return moments;
}

// The disk of a point's nearest neighbours on its own sheet: the other side of something thin does not count.
std::vector<double> sheet_areas(const Cloud& cloud, std::span<const Vector3> normals) {
    constexpr double opposite_cosine = -0.5;
    constexpr std::size_t enough = 12;
    std::vector<double> areas(cloud.size());
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        std::size_t count = 0;
        double squared_radius = 0;
        for (const std::uint32_t j : cloud.neighbours_of(i)) {
            if (normals[i].dot(normals[j]) < opposite_cosine) continue;
            squared_radius = (cloud.points[j] - cloud.points[i]).squaredNorm();
            if (++count == enough) break;
        }
        areas[i] = count > 0 ? std::numbers::pi * squared_radius / static_cast<double>(count)
                             : cloud.spacing[i] * cloud.spacing[i];
    }
    return areas;
}

// Where the winding number at the points is not near 1/2, signs are mixed, as they may be on both sides of a piece of a
// thin plate: there each point takes the side of a neighbour in the same plane that has one, the flattest way first
// (Hoppe et al. 1992). False when there are none.
bool orient_doubtful(const Cloud& cloud, std::span<const double> winding, std::vector<Vector3>& normals) {
    constexpr double sure = 0.2;
    const std::size_t n = cloud.size();
    std::vector<std::uint8_t> is_settled(n, 1);
    std::size_t doubtful = 0;
    for (std::size_t i = 0; i < n; ++i) {
        double sum = winding[i];
        for (const std::uint32_t j : cloud.neighbours_of(i)) sum += winding[j];
        // The mean of a neighbourhood, because noise puts single points inside and outside.
        if (std::abs(sum / (1 + cloud.neighbour_count) - 0.5) < sure) continue;
        is_settled[i] = 0;
        ++doubtful;
    }
    if (doubtful == 0 || doubtful == n) return false;
    struct Step {
        double cost;
        std::uint32_t to, from;
        bool operator>(const Step& other) const {
            if (cost != other.cost) return cost > other.cost;
            return to != other.to ? to > other.to : from > other.from;
        }
    };
    std::priority_queue<Step, std::vector<Step>, std::greater<>> queue;
    // Neighbours both ways: the nearest ones of a point need not have it among theirs.
    std::vector<std::vector<std::uint32_t>> around(n);
    for (std::uint32_t i = 0; i < n; ++i)
        for (const std::uint32_t j : cloud.neighbours_of(i)) {
            if (is_settled[i] == 0) around[j].push_back(i);
            if (is_settled[j] == 0) around[i].push_back(j);
        }
    const auto offer = [&](std::uint32_t from) {
        for (const std::uint32_t to : around[from]) {
            if (is_settled[to] != 0) continue;
            const Vector3 way = cloud.points[to] - cloud.points[from];
            const double height =
                std::max(std::abs(way.dot(normals[from])), std::abs(way.dot(normals[to]))) / way.norm();
            queue.push({1 - std::abs(normals[from].dot(normals[to])) + height, to, from});
        }
    };
    for (std::uint32_t i = 0; i < n; ++i)
        if (is_settled[i] != 0) offer(i);
    while (!queue.empty()) {
        const Step step = queue.top();
        queue.pop();
        if (is_settled[step.to] != 0) continue;
        is_settled[step.to] = 1;
        if (normals[step.from].dot(normals[step.to]) < 0) normals[step.to] = -normals[step.to];
        offer(step.to);
    }
    return true;
}

}  // namespace

void OrientationParameters::validate() const {
    core::require(most_points >= 4, "most_points", "at least 4");
    core::require(noise_distance >= 0, "noise_distance", "at least 0");
    core::require(rounds >= 1, "rounds", "at least 1");
    core::require(passes >= 1, "passes", "at least 1");
    core::require(repairs >= 0, "repairs", "at least 0");
    core::require(first_width > 0, "first_width", "positive");
    core::require(last_width > 0, "last_width", "positive");
}

Orientation oriented_normals(const Cloud& cloud, std::span<const Vector3> axes, double noise,
                             const OrientationParameters& parameters, core::Observer& observer) {
    const Thinned few = thinned(cloud, parameters.most_points, parameters.noise_distance * noise);
    std::vector<Point3> places;
    for (const std::uint32_t i : few.index) places.push_back(cloud.points[i]);
    const std::vector<Vector3> moments = consistent_moments(places, few.spacing, cloud.threads, parameters, observer);

    Orientation result;
    const std::size_t n = cloud.size();
    result.areas.resize(n);
    for (std::size_t i = 0; i < n; ++i) result.areas[i] = cloud.spacing[i] * cloud.spacing[i];
    result.normals.resize(n);
    const auto turn = [&](const std::vector<Vector3>& gradient) {
        for (std::size_t i = 0; i < n; ++i)
            result.normals[i] = gradient[i].dot(axes[i]) > 0 ? -axes[i] : Vector3(axes[i]);
    };
    {
        const KdTree tree(places);
        const DipoleSum sum(tree, places, cloud.threads);
        turn(sum.gradients(sum.targets(cloud.points), moments, std::vector<double>(places.size(), few.spacing)));
    }
    const KdTree tree(cloud.points);
    const DipoleSum sum(tree, cloud.points, cloud.threads);
    const DipoleSum::Targets targets = sum.targets(cloud.points);
    std::vector<Vector3> all(n);
    std::vector<double> widths(n);
    for (std::size_t i = 0; i < n; ++i) widths[i] = std::max(1.5 * cloud.spacing[i], 3 * noise);
    for (int pass = 0; pass < parameters.passes; ++pass) {
        observer.check_cancelled();
        for (std::size_t i = 0; i < n; ++i) all[i] = result.areas[i] * result.normals[i];
        turn(sum.gradients(targets, all, widths));
        result.areas = sheet_areas(cloud, result.normals);
    }
    for (int pass = 0; pass < parameters.repairs; ++pass) {
        for (std::size_t i = 0; i < n; ++i) all[i] = result.areas[i] * result.normals[i];
        const std::vector<double> winding = sum.winding_numbers(targets, all, widths);
        if (!orient_doubtful(cloud, winding, result.normals)) break;
        result.areas = sheet_areas(cloud, result.normals);
    }
    return result;
}

}  // namespace dsc::reconstruct
