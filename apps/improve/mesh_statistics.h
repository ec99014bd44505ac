// SPDX-License-Identifier: GPL-3.0-or-later
// What a tetrahedral mesh is worth, in figures: its dihedral angles, its quality, its volume.
// Guarantee: the same bits on any number of threads; a percentile is an angle that occurs in the mesh. Cost: linear,
// below a microsecond and 48 bytes (given back at the end) per tetrahedron.
//
//     const MeshStatistics statistics = mesh_statistics(data, geometry::QualityMeasure::minimum_sine);
//     std::cout << statistics.smallest_angle << " to " << statistics.largest_angle << " degrees\n";
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/tet_data.h"
#include "geometry/tetrahedron_quality.h"

namespace dsc::improve {

/// Per cent of all dihedral angles.
inline constexpr std::array<int, 7> percentile_ranks{1, 5, 25, 50, 75, 95, 99};

/// Angles are dihedral angles in degrees, six per tetrahedron.
struct MeshStatistics {
    std::size_t tets = 0;
    std::size_t vertices = 0;
    std::size_t regions = 0;  ///< different labels
    double volume = 0;
    double smallest_angle = 0;
    double largest_angle = 0;
    /// The least angle of the mesh such that `percentile_ranks[i]` per cent of all angles are not larger.
    std::array<double, percentile_ranks.size()> angle_percentiles{};
    /// Element i counts the angles in [i, i + 1); the last one those of 180 too.
    std::array<std::size_t, 180> angle_counts{};
    double worst_quality = 0;
    double mean_quality = 0;
};

/// Precondition: at least one tetrahedron. Zero `threads` mean all.
MeshStatistics mesh_statistics(const geometry::TetData& data, geometry::QualityMeasure measure, int threads = 0);

/// The quality of each tetrahedron.
std::vector<double> qualities(const geometry::TetData& data, geometry::QualityMeasure measure, int threads = 0);

/// `angle_counts` summed up in `bins` bins of equal width; precondition: 180 is a multiple of `bins`.
std::vector<std::size_t> angle_histogram(const MeshStatistics& statistics, std::size_t bins);

/// The share of each bin among all angles: that is what bars of meshes of different size have in common.
std::vector<double> angle_shares(const MeshStatistics& statistics, std::size_t bins);

}  // namespace dsc::improve
