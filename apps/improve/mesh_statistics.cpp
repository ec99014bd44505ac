// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/improve/mesh_statistics.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <unordered_set>

#include "core/assert.h"
#include "core/parallel.h"

namespace dsc::improve {

using geometry::Point3;
using geometry::TetData;

namespace {

constexpr std::size_t grain = 1024;

double degrees(double radians) { return radians * (180 / std::numbers::pi); }

std::array<Point3, 4> corners(const TetData& data, std::size_t tet) {
    const auto& [a, b, c, d] = data.tets[tet];
    return {data.vertices[a], data.vertices[b], data.vertices[c], data.vertices[d]};
}

double volume(const std::array<Point3, 4>& corner) {
    const Point3 ab = corner[1] - corner[0], ac = corner[2] - corner[0], ad = corner[3] - corner[0];
    return ab.dot(ac.cross(ad)) / 6;
}

// In the order of the tetrahedra, so that the rounding doesn't depend on threads.
double sum(const std::vector<double>& values) {
    double total = 0;
    for (const double value : values) total += value;
    return total;
}

std::vector<double> all_angles(const TetData& data, int threads) {
    std::vector<double> angles(6 * data.tets.size());
    core::parallel_for(data.tets.size(), {.threads = threads, .grain = grain}, [&](std::size_t tet) {
        const auto [a, b, c, d] = corners(data, tet);
        const std::array<double, 6> radians = geometry::dihedral_angles(a, b, c, d);
        std::ranges::transform(radians, angles.begin() + static_cast<std::ptrdiff_t>(6 * tet), degrees);
    });
    return angles;
}

double total_volume(const TetData& data, int threads) {
    std::vector<double> volumes(data.tets.size());
    core::parallel_for(data.tets.size(), {.threads = threads, .grain = grain},
                       [&](std::size_t tet) { volumes[tet] = volume(corners(data, tet)); });
    return sum(volumes);
}

void judge_angles(std::vector<double> angles, MeshStatistics& statistics) {
    const auto [smallest, largest] = std::ranges::minmax(angles);
    statistics.smallest_angle = smallest;
    statistics.largest_angle = largest;
    for (const double angle : angles) {
        const double last_bin = static_cast<double>(statistics.angle_counts.size() - 1);
        ++statistics.angle_counts[static_cast<std::size_t>(std::clamp(angle, 0.0, last_bin))];
    }
    // From rank to rank, each time among what is left: nothing before it is larger.
    auto begin = angles.begin();
    for (std::size_t i = 0; i < percentile_ranks.size(); ++i) {
        const std::size_t rank = (percentile_ranks[i] * angles.size() + 99) / 100;
        const auto place = angles.begin() + static_cast<std::ptrdiff_t>(rank - 1);
        std::nth_element(begin, place, angles.end());
        statistics.angle_percentiles[i] = *place;
        begin = place;
    }
}

std::size_t count_regions(const TetData& data) {
    return data.labels.empty() ? 1 : std::unordered_set<int>(data.labels.begin(), data.labels.end()).size();
}

}  // namespace

std::vector<double> qualities(const TetData& data, geometry::QualityMeasure measure, int threads) {
    std::vector<double> result(data.tets.size());
    core::parallel_for(result.size(), {.threads = threads, .grain = grain}, [&](std::size_t tet) {
        const auto [a, b, c, d] = corners(data, tet);
        result[tet] = geometry::quality(measure, a, b, c, d);
    });
    return result;
}

MeshStatistics mesh_statistics(const TetData& data, geometry::QualityMeasure measure, int threads) {
    DSC_ASSERT(!data.tets.empty());
    MeshStatistics statistics;
    statistics.tets = data.tets.size();
    statistics.vertices = data.vertices.size();
    statistics.regions = count_regions(data);
    statistics.volume = total_volume(data, threads);
    judge_angles(all_angles(data, threads), statistics);
    const std::vector<double> quality = qualities(data, measure, threads);
    statistics.worst_quality = std::ranges::min(quality);
    statistics.mean_quality = sum(quality) / static_cast<double>(quality.size());
    return statistics;
}

std::vector<std::size_t> angle_histogram(const MeshStatistics& statistics, std::size_t bins) {
    const std::size_t width = statistics.angle_counts.size() / bins;
    DSC_ASSERT(width * bins == statistics.angle_counts.size());
    std::vector<std::size_t> histogram(bins);
    for (std::size_t i = 0; i < statistics.angle_counts.size(); ++i) histogram[i / width] += statistics.angle_counts[i];
    return histogram;
}

std::vector<double> angle_shares(const MeshStatistics& statistics, std::size_t bins) {
    std::vector<double> shares;
    for (const std::size_t count : angle_histogram(statistics, bins))
        shares.push_back(static_cast<double>(count) / static_cast<double>(6 * statistics.tets));
    return shares;
}

}  // namespace dsc::improve
