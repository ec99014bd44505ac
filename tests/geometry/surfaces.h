// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces of which everything is known, for tests.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>

#include "geometry/surface_data.h"

namespace dsc::tests {

/// A cube of the given edge length with its lowest corner at `origin`: 12 triangles, the first two at the bottom.
inline geometry::SurfaceData box(const Eigen::Vector3d& origin = Eigen::Vector3d::Zero(), double edge = 1) {
    geometry::SurfaceData surface;
    for (int i = 0; i < 8; ++i) surface.vertices.push_back(origin + edge * Eigen::Vector3d(i & 1, i >> 1 & 1, i >> 2));
    surface.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                         {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return surface;
}

/// An icosahedron on the unit sphere whose triangles were divided into four `levels` times: 20·4^levels triangles.
inline geometry::SurfaceData icosphere(int levels) {
    const double t = std::numbers::phi;
    geometry::SurfaceData surface;
    for (const Eigen::Vector3d& p : {Eigen::Vector3d(-1, t, 0),
                                     {1, t, 0},
                                     {-1, -t, 0},
                                     {1, -t, 0},
                                     {0, -1, t},
                                     {0, 1, t},
                                     {0, -1, -t},
                                     {0, 1, -t},
                                     {t, 0, -1},
                                     {t, 0, 1},
                                     {-t, 0, -1},
                                     {-t, 0, 1}}) {
        surface.vertices.push_back(p.normalized());
    }
    surface.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                         {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                         {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto next = static_cast<std::uint32_t>(surface.vertices.size());
            const auto [place, is_new] = middles.try_emplace(std::minmax(a, b), next);
            if (is_new) surface.vertices.push_back((surface.vertices[a] + surface.vertices[b]).normalized());
            return place->second;
        };
        std::vector<std::array<std::uint32_t, 3>> finer;
        for (const auto& [a, b, c] : surface.triangles) {
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
        }
        surface.triangles = std::move(finer);
    }
    return surface;
}

/// A strip of `length` by `width` quadrilaterals, two triangles each, that is closed along its length: the vertex in
/// row i and column j, of `length` rows and `width` + 1 columns, is at place(i, j).
template <class Place>
geometry::SurfaceData strip(std::uint32_t length, std::uint32_t width, const Place& place, bool is_twisted = false) {
    geometry::SurfaceData surface;
    for (std::uint32_t i = 0; i < length; ++i) {
        for (std::uint32_t j = 0; j <= width; ++j) surface.vertices.push_back(place(i, j));
    }
    const auto vertex = [&](std::uint32_t i, std::uint32_t j) {
        if (i == length && is_twisted) j = width - j;
        return i % length * (width + 1) + j;
    };
    for (std::uint32_t i = 0; i < length; ++i) {
        for (std::uint32_t j = 0; j < width; ++j) {
            surface.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
            surface.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
    }
    return surface;
}

/// Radii 1 and `r`, normals outwards: 2·n² triangles.
inline geometry::SurfaceData torus(std::uint32_t n, double r) {
    const double turn = 2 * std::numbers::pi / n;
    geometry::SurfaceData surface = strip(n, n, [&](std::uint32_t i, std::uint32_t j) {
        const double rho = 1 + r * std::cos(turn * j);
        return Eigen::Vector3d(rho * std::cos(turn * i), rho * std::sin(turn * i), r * std::sin(turn * j));
    });
    // The last column is the first one.
    for (auto& triangle : surface.triangles) {
        for (std::uint32_t& v : triangle) v = v / (n + 1) * n + v % (n + 1) % n;
    }
    for (std::uint32_t v = 0; v < n * n; ++v) surface.vertices[v] = surface.vertices[v / n * (n + 1) + v % n];
    surface.vertices.resize(n * n);
    return surface;
}

/// A Moebius strip of `length` quadrilaterals.
inline geometry::SurfaceData moebius_strip(std::uint32_t length) {
    const auto place = [length](std::uint32_t i, std::uint32_t j) {
        const double angle = 2 * std::numbers::pi * i / length;
        const double across = (j - 0.5) * std::cos(angle / 2), up = (j - 0.5) * std::sin(angle / 2);
        return Eigen::Vector3d((2 + across) * std::cos(angle), (2 + across) * std::sin(angle), up);
    };
    return strip(length, 1, place, true);
}

/// Both, side by side.
inline geometry::SurfaceData joined(geometry::SurfaceData a, const geometry::SurfaceData& b) {
    const auto shift = static_cast<std::uint32_t>(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const auto& [p, q, r] : b.triangles) a.triangles.push_back({p + shift, q + shift, r + shift});
    return a;
}

/// What a closed surface encloses.
inline double volume(const geometry::SurfaceData& surface) {
    double sum = 0;
    for (const auto& [a, b, c] : surface.triangles)
        sum += surface.vertices[a].dot(surface.vertices[b].cross(surface.vertices[c])) / 6;
    return sum;
}

/// With the vertex `removed` replaced by `kept` in every triangle.
inline geometry::SurfaceData glued(geometry::SurfaceData surface, std::uint32_t removed, std::uint32_t kept) {
    for (auto& triangle : surface.triangles) {
        for (std::uint32_t& v : triangle) v = v == removed ? kept : v;
    }
    return surface;
}

}  // namespace dsc::tests
