// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/improve/mesh_statistics.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <numbers>
#include <numeric>

#include "tests/apps/improve/box_mesh.h"

using namespace dsc;
using namespace dsc::improve;
using geometry::QualityMeasure;
using geometry::TetData;

namespace {

constexpr std::array all_measures{QualityMeasure::minimum_sine, QualityMeasure::minimum_biased_sine,
                                  QualityMeasure::volume_length, QualityMeasure::radius_ratio};

TetData regular() { return {.vertices = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, .tets = {{0, 2, 1, 3}}}; }

// The corner of a cube, three right angles at the vertex 0.
TetData corner() { return {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, .tets = {{0, 1, 2, 3}}}; }

// The angle at the edge pq between what is left of the other two corners when the direction of pq is taken away.
double angle_at(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r,
                const Eigen::Vector3d& s) {
    const Eigen::Vector3d along = (q - p).normalized();
    const Eigen::Vector3d to_r = (r - p) - along * along.dot(r - p), to_s = (s - p) - along * along.dot(s - p);
    return std::acos(to_r.dot(to_s) / (to_r.norm() * to_s.norm())) * 180 / std::numbers::pi;
}

std::vector<double> sorted_angles(const TetData& data) {
    std::vector<double> angles;
    for (const auto& tet : data.tets) {
        std::array<int, 4> order{0, 1, 2, 3};
        do {
            if (order[0] > order[1] || order[2] > order[3]) continue;
            angles.push_back(angle_at(data.vertices[tet[order[0]]], data.vertices[tet[order[1]]],
                                      data.vertices[tet[order[2]]], data.vertices[tet[order[3]]]));
        } while (std::ranges::next_permutation(order).found);
    }
    std::ranges::sort(angles);
    return angles;
}

bool are_same_bits(const MeshStatistics& a, const MeshStatistics& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

}  // namespace

TEST_CASE("a regular tetrahedron has six angles of 70.5288 degrees and the best quality there is") {
    const MeshStatistics statistics = mesh_statistics(regular(), QualityMeasure::radius_ratio);
    const double angle = std::acos(1.0 / 3) * 180 / std::numbers::pi;
    CHECK(angle == Approx(70.5288).epsilon(1e-6));
    CHECK(statistics.tets == 1);
    CHECK(statistics.vertices == 4);
    CHECK(statistics.regions == 1);
    CHECK(statistics.volume == Approx(8.0 / 3));
    CHECK(statistics.smallest_angle == Approx(angle));
    CHECK(statistics.largest_angle == Approx(angle));
    for (const double percentile : statistics.angle_percentiles) CHECK(percentile == Approx(angle));
    CHECK(statistics.angle_counts[70] == 6);
    CHECK(statistics.worst_quality == Approx(1));
    CHECK(mesh_statistics(regular(), QualityMeasure::volume_length).mean_quality == Approx(1));
    CHECK(mesh_statistics(regular(), QualityMeasure::minimum_sine).worst_quality == Approx(std::sqrt(8.0) / 3));
}

TEST_CASE("an angle on the border of two bins counts in the upper one") {
    const MeshStatistics statistics = mesh_statistics(corner(), QualityMeasure::minimum_sine);
    CHECK(statistics.angle_counts[90] == 3);
    CHECK(statistics.angle_counts[54] == 3);
    CHECK(angle_histogram(statistics, 18)[9] == 3);
    CHECK(angle_histogram(statistics, 2) == std::vector<std::size_t>{3, 3});
}

TEST_CASE("all figures agree with those of a plain computation") {
    const TetData data = tests::shaken_box(5);
    const std::vector<double> angles = sorted_angles(data);
    REQUIRE(angles.size() == 6 * data.tets.size());
    for (const QualityMeasure measure : all_measures) {
        const MeshStatistics statistics = mesh_statistics(data, measure);
        CHECK(statistics.tets == 750);
        CHECK(statistics.vertices == 216);
        CHECK(statistics.volume == Approx(1).epsilon(1e-12));
        CHECK(statistics.smallest_angle == Approx(angles.front()).epsilon(1e-9));
        CHECK(statistics.largest_angle == Approx(angles.back()).epsilon(1e-9));
        for (std::size_t i = 0; i < percentile_ranks.size(); ++i) {
            const double wanted = percentile_ranks[i] / 100.0 * static_cast<double>(angles.size());
            std::size_t not_larger = 0;
            while (static_cast<double>(not_larger) < wanted) ++not_larger;
            CHECK(statistics.angle_percentiles[i] == Approx(angles[not_larger - 1]).epsilon(1e-9));
        }
        for (std::size_t bins : {1u, 18u, 90u, 180u}) {
            const std::vector<std::size_t> histogram = angle_histogram(statistics, bins);
            CHECK(std::accumulate(histogram.begin(), histogram.end(), std::size_t{0}) == angles.size());
        }
        const auto obtuse = std::ranges::count_if(angles, [](double angle) { return angle >= 120; });
        std::size_t counted = 0;
        for (std::size_t bin = 12; bin < 18; ++bin) counted += angle_histogram(statistics, 18)[bin];
        CHECK(counted == static_cast<std::size_t>(obtuse));

        double worst = 2, total = 0;
        for (const auto& [a, b, c, d] : data.tets) {
            const double quality =
                geometry::quality(measure, data.vertices[a], data.vertices[b], data.vertices[c], data.vertices[d]);
            worst = std::min(worst, quality);
            total += quality;
        }
        CHECK(statistics.worst_quality == worst);
        CHECK(statistics.mean_quality == Approx(total / 750).epsilon(1e-13));
    }
}

TEST_CASE("regions are the labels that occur") {
    CHECK(mesh_statistics(tests::two_regions(2), QualityMeasure::minimum_sine).regions == 2);
    TetData data = tests::box_mesh(2);
    data.labels.assign(data.tets.size(), -5);
    CHECK(mesh_statistics(data, QualityMeasure::minimum_sine).regions == 1);
}

TEST_CASE("the figures have the same bits on any number of threads") {
    const TetData data = tests::shaken_box(12);
    const MeshStatistics one = mesh_statistics(data, QualityMeasure::volume_length, 1);
    for (const int threads : {0, 2, 3}) {
        CHECK(are_same_bits(mesh_statistics(data, QualityMeasure::volume_length, threads), one));
        CHECK(qualities(data, QualityMeasure::minimum_sine, threads) ==
              qualities(data, QualityMeasure::minimum_sine, 1));
    }
}
