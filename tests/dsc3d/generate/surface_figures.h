// SPDX-License-Identifier: GPL-3.0-or-later
// What tests of generated surfaces ask of their triangles.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/surface_check.h"
#include "geometry/surface_data.h"
#include "geometry/surface_intersections.h"

namespace dsc::tests {

struct TriangleFigures {
    double shortest = std::numeric_limits<double>::infinity();
    double longest = 0;
    double mean = 0;
    double least_angle = 180;  ///< [degree]

    explicit TriangleFigures(const geometry::SurfaceData& surface) {
        for (const auto& triangle : surface.triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                const Eigen::Vector3d& a = surface.vertices[triangle[k]];
                const Eigen::Vector3d u = surface.vertices[triangle[(k + 1) % 3]] - a;
                const Eigen::Vector3d v = surface.vertices[triangle[(k + 2) % 3]] - a;
                shortest = std::min(shortest, u.norm());
                longest = std::max(longest, u.norm());
                mean += u.norm() / 3 / static_cast<double>(surface.triangles.size());
                const double angle = std::acos(u.dot(v) / u.norm() / v.norm()) * 180 / std::numbers::pi;
                least_angle = std::min(least_angle, angle);
            }
        }
    }
};

/// Closed, oriented, manifold, without self-intersections, normals outwards; returns what else is known of it.
inline geometry::SurfaceCheck require_closed(const geometry::SurfaceData& surface) {
    const geometry::SurfaceCheck check = geometry::check_surface(surface);
    REQUIRE(check.is_closed());
    REQUIRE(check.is_manifold());
    REQUIRE(check.is_oriented());
    REQUIRE(check.degenerate_triangles.empty());
    REQUIRE(check.genus);
    REQUIRE(check.volume);
    REQUIRE(*check.volume > 0);
    REQUIRE(geometry::self_intersections(surface).empty());
    return check;
}

}  // namespace dsc::tests
