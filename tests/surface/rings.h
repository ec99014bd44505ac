// SPDX-License-Identifier: GPL-3.0-or-later
// One-rings of which everything is known: sectors of planes that are triangulated at random.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <vector>

#include "core/random.h"
#include "surface/one_ring.h"

namespace dsc::tests {

using geometry::Point3;

/// A ring that owns its triangles.
struct OwnedRing {
    Point3 centre = Point3::Zero();
    std::vector<surface::RingTriangle> triangles;

    surface::OneRing view() const { return {centre, triangles}; }
    void transform(const Eigen::Affine3d& map) {
        centre = map * centre;
        for (auto& [a, b] : triangles) a = map * a, b = map * b;
    }
};

/// Points around the origin, from the unit vector `from` towards the unit vector `up` by `turn` > 0 [rad], both ends
/// included: at most 60° and at least a tenth of the mean apart, at random distances in [0.2, 1).
inline std::vector<Point3> sector(core::Random& random, const Point3& from, const Point3& up, double turn) {
    const auto pieces = static_cast<std::size_t>(turn / (std::numbers::pi / 6)) + 1 + random.below(4);
    std::vector<double> shares(pieces);
    double sum = 0;
    for (double& share : shares) sum += share = random.uniform(0.2, 1);
    std::vector<Point3> points;
    double angle = 0;
    for (std::size_t i = 0; i <= pieces; ++i) {
        points.push_back(random.uniform(0.2, 1) * (std::cos(angle) * from + std::sin(angle) * up));
        if (i < pieces) angle = i + 1 == pieces ? turn : angle + turn * shares[i] / sum;
    }
    return points;
}

/// Adds a fan over the points; `first` and `last` replace the ends, so that sectors meet in the same points.
inline void add_fan(OwnedRing& ring, std::vector<Point3> points, const Point3& first, const Point3& last) {
    points.front() = first, points.back() = last;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) ring.triangles.push_back({points[i], points[i + 1]});
}

/// The corner of the octant x, y, z < 0, normals outwards: (1, 0, 0), (0, 1, 0) and (0, 0, 1).
inline OwnedRing cube_corner(core::Random& random) {
    OwnedRing ring;
    std::array<Point3, 3> edges;
    for (int k = 0; k < 3; ++k) edges[static_cast<std::size_t>(k)] = -random.uniform(0.2, 1) * Point3::Unit(k);
    for (std::size_t k = 0; k < 3; ++k) {
        const Point3& from = edges[(k + 1) % 3];
        const Point3& to = edges[(k + 2) % 3];
        add_fan(ring, sector(random, from.normalized(), to.normalized(), std::numbers::pi / 2), from, to);
    }
    return ring;
}

/// Two half-planes that meet in the z axis; their normals are `bend` apart [rad], (-sin, cos, 0) and (sin, cos, 0) of
/// half of it. Bent down for bend > 0.
inline OwnedRing ridge(core::Random& random, double bend) {
    OwnedRing ring;
    const double c = std::cos(bend / 2), s = std::sin(bend / 2);
    const Point3 up = random.uniform(0.2, 1) * Point3::UnitZ(), down = -random.uniform(0.2, 1) * Point3::UnitZ();
    add_fan(ring, sector(random, Point3::UnitZ(), Point3(c, -s, 0), std::numbers::pi), up, down);
    add_fan(ring, sector(random, -Point3::UnitZ(), Point3(-c, -s, 0), std::numbers::pi), down, up);
    return ring;
}

/// A flat ring with the normal (0, 1, 0).
inline OwnedRing flat(core::Random& random) { return ridge(random, 0); }

inline Eigen::Affine3d random_placement(core::Random& random) {
    const Eigen::AngleAxisd turn(random.uniform(0, 6), Point3(1, random.uniform(), random.uniform()).normalized());
    return Eigen::Translation3d(random.uniform(), random.uniform(), random.uniform()) * turn;
}

}  // namespace dsc::tests
