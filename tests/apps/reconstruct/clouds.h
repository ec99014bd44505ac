// SPDX-License-Identifier: GPL-3.0-or-later
// Clouds whose surface is known, sampled uniformly by area from a seed.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/random.h"
#include "geometry/predicates.h"

namespace dsc::tests {

using geometry::Point3;
using Vector3 = Eigen::Vector3d;

struct OrientedCloud {
    std::vector<Point3> points;
    std::vector<Vector3> normals;  ///< outwards, the true ones
};

inline OrientedCloud sphere_cloud(const Point3& centre, double radius, std::size_t count, core::Random& random) {
    OrientedCloud cloud;
    for (std::size_t i = 0; i < count; ++i) {
        const double z = random.uniform(-1, 1), angle = random.uniform(0, 2 * std::numbers::pi),
                     r = std::sqrt(1 - z * z);
        cloud.normals.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
        cloud.points.push_back(centre + radius * cloud.normals.back());
    }
    return cloud;
}

inline OrientedCloud box_cloud(const Eigen::AlignedBox3d& box, std::size_t count, core::Random& random) {
    OrientedCloud cloud;
    const Vector3 size = box.sizes();
    const Vector3 area(size.y() * size.z(), size.z() * size.x(), size.x() * size.y());
    for (std::size_t i = 0; i < count; ++i) {
        double pick = random.uniform(0, area.sum());
        int axis = 0;
        while (axis < 2 && pick >= area[axis]) pick -= area[axis++];
        const bool is_upper = random.uniform() < 0.5;
        Point3 p = box.min() + size.cwiseProduct(Vector3(random.uniform(), random.uniform(), random.uniform()));
        p[axis] = is_upper ? box.max()[axis] : box.min()[axis];
        cloud.points.push_back(p);
        cloud.normals.push_back(is_upper ? Vector3(Vector3::Unit(axis)) : Vector3(-Vector3::Unit(axis)));
    }
    return cloud;
}

/// Around the axis z.
inline OrientedCloud torus_cloud(double major, double minor, std::size_t count, core::Random& random) {
    OrientedCloud cloud;
    while (cloud.points.size() < count) {
        const double u = random.uniform(0, 2 * std::numbers::pi), v = random.uniform(0, 2 * std::numbers::pi);
        if (random.uniform(0, major + minor) > major + minor * std::cos(v)) continue;
        const Vector3 n(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
        cloud.points.push_back(major * Vector3(std::cos(u), std::sin(u), 0) + minor * n);
        cloud.normals.push_back(n);
    }
    return cloud;
}

inline void add(OrientedCloud& cloud, const OrientedCloud& other) {
    cloud.points.insert(cloud.points.end(), other.points.begin(), other.points.end());
    cloud.normals.insert(cloud.normals.end(), other.normals.begin(), other.normals.end());
}

/// Off the surface, by the sum of twelve uniform numbers, which is nearly normal.
inline void add_noise(OrientedCloud& cloud, double deviation, core::Random& random) {
    for (std::size_t i = 0; i < cloud.points.size(); ++i) {
        double sum = -6;
        for (int k = 0; k < 12; ++k) sum += random.uniform();
        cloud.points[i] += deviation * sum * cloud.normals[i];
    }
}

}  // namespace dsc::tests
