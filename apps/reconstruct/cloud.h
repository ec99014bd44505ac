// SPDX-License-Identifier: GPL-3.0-or-later
// A point cloud made ready: duplicates and stray points left out, moved and scaled to a box of diagonal 1, with the
// nearest neighbours of each point, the spacing around it and the noise.
// Source: thesis 4.4.3; spacing and stray points from the graph of nearest neighbours, as Hoppe, DeRose, Duchamp,
// McDonald, Stuetzle (1992), "Surface reconstruction from unorganized points", use it. Guarantee: the same bits for the
// same points, whatever the scale of their coordinates is by a power of two; a point that is left out is among the
// strays or equal to one that is kept. Cost: n log n, about 15 us per point.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "apps/reconstruct/kd_tree.h"

namespace dsc::reconstruct {

struct CloudParameters {
    int neighbours = 24;          ///< of a point, as far as there are as many; at least 8
    int spacing_neighbours = 12;  ///< whose disk gives the spacing; in [4, neighbours]
    /// A point is stray when its 8th neighbour is this many times as far as that of its neighbours are from theirs ...
    double stray_distance = 3.5;
    /// ... or when it is among the 8 nearest of no more points than this, ...
    int stray_popularity = 0;
    /// ... or when it belongs to a part, held together by points among the nearest 8 of each other, of less than this
    /// share of the points.
    double stray_part = 0.002;

    /// Throws core::UsageError naming the field.
    void validate() const;
};

struct Cloud {
    std::vector<Point3> points;           ///< scaled
    std::vector<std::uint32_t> original;  ///< of each, its place in the input
    std::vector<std::uint32_t> strays;    ///< places in the input, ascending
    std::size_t duplicates = 0;
    Point3 origin = Point3::Zero();  ///< place in the input of the scaled origin
    double scale = 1;                ///< length in the input of a scaled 1: the diagonal of the box
    std::uint32_t neighbour_count = 0;
    int threads = 0;                        ///< that computations on the cloud use; 0: all
    std::vector<std::uint32_t> neighbours;  ///< `neighbour_count` for each point, nearest first, without itself
    std::vector<double> spacing;            ///< side of the square that a point has of the surface
    double median_spacing = 0;

    std::size_t size() const { return points.size(); }
    std::span<const std::uint32_t> neighbours_of(std::size_t i) const {
        return std::span(neighbours).subspan(i * neighbour_count, neighbour_count);
    }
    Point3 to_input(const Point3& p) const { return origin + scale * p; }
};

/// Finds as many neighbours of each point, or all others when there are fewer.
void set_neighbours(Cloud& cloud, std::size_t count);

/// Throws core::InputError, naming `source`, for fewer than 4 different points, points on a line or in a plane, and
/// coordinates too large to be squared.
Cloud prepared_cloud(std::span<const Point3> points, const CloudParameters& parameters, const std::string& source,
                     int threads = 0);

}  // namespace dsc::reconstruct
