// SPDX-License-Identifier: GPL-3.0-or-later
// What several tests of the 2D engine need.
#pragma once

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "dsc2d/complex.h"
#include "dsc2d/generate/insert_polygon.h"
#include "dsc2d/generate/structured.h"
#include "dsc2d/interface.h"
#include "dsc2d/validate.h"
#include "geometry/triangle.h"

namespace dsc::tests {

inline void require_valid(const dsc2d::Complex& complex) {
    const std::vector<std::string> violations = dsc2d::validate(complex);
    if (violations.empty()) return;
    FAIL(violations.size() << " violations, first: " << violations.front());
}

inline std::vector<geometry::Point2> circle(const geometry::Point2& centre, double radius, int corners) {
    std::vector<geometry::Point2> points;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        points.push_back(centre + radius * geometry::Point2(std::cos(angle), std::sin(angle)));
    }
    return points;
}

/// A polygon of label 1 in the box [-2, 2]^2.
inline dsc2d::Complex complex_of(const std::vector<geometry::Point2>& outline) {
    dsc2d::Complex complex = dsc2d::structured_complex(dsc2d::Domain::box({-2, -2}, {2, 2}), 9, 9);
    dsc2d::insert_polygon(complex, outline, 1);
    return complex;
}

/// Where the map takes the vertices of the interface, by vertex.
template <class Map>
std::vector<std::optional<geometry::Point2>> targets_of(const dsc2d::Complex& complex, Map map) {
    std::vector<std::optional<geometry::Point2>> targets(complex.vertex_capacity());
    for (const core::VertexId v : dsc2d::Interface(complex).vertices) targets[v.index()] = map(complex.position(v));
    return targets;
}

/// The least angle of all triangles.
inline double min_angle(const dsc2d::Complex& complex) {
    double smallest = std::numbers::pi;
    for (std::uint32_t i = 0; i < complex.face_capacity(); ++i) {
        if (complex.is_deleted(core::FaceId(i))) continue;
        const auto [a, b, c] = complex.corners(core::FaceId(i));
        smallest = std::min(smallest, geometry::min_angle(a, b, c));
    }
    return smallest;
}

/// Connected components of the faces with this label, joined across edges.
inline int component_count(const dsc2d::Complex& complex, int label) {
    std::vector<bool> is_seen(complex.face_capacity(), false);
    int components = 0;
    for (std::uint32_t i = 0; i < complex.face_capacity(); ++i) {
        if (complex.is_deleted(core::FaceId(i)) || is_seen[i] || complex.label(core::FaceId(i)) != label) continue;
        ++components;
        is_seen[i] = true;
        std::vector<core::FaceId> stack{core::FaceId(i)};
        while (!stack.empty()) {
            core::HalfedgeId h = complex.halfedge(stack.back());
            stack.pop_back();
            for (int k = 0; k < 3; ++k, h = complex.next(h)) {
                const core::FaceId f = complex.face(dsc2d::Complex::opposite(h));
                if (!f.is_valid() || is_seen[f.index()] || complex.label(f) != label) continue;
                is_seen[f.index()] = true;
                stack.push_back(f);
            }
        }
    }
    return components;
}

/// Euler characteristic of the closed region with this label, counted in the complex (not in the cover).
inline int euler_characteristic(const dsc2d::Complex& complex, int label) {
    std::vector<bool> vertices(complex.vertex_capacity(), false), edges(complex.edge_capacity(), false);
    int characteristic = 0;
    for (std::uint32_t i = 0; i < complex.face_capacity(); ++i) {
        if (complex.is_deleted(core::FaceId(i)) || complex.label(core::FaceId(i)) != label) continue;
        ++characteristic;
        core::HalfedgeId h = complex.halfedge(core::FaceId(i));
        for (int k = 0; k < 3; ++k, h = complex.next(h)) {
            edges[dsc2d::Complex::edge(h).index()] = true;
            vertices[complex.to(h).index()] = true;
        }
    }
    for (const bool used : vertices) characteristic += used ? 1 : 0;
    for (const bool used : edges) characteristic -= used ? 1 : 0;
    return characteristic;
}

}  // namespace dsc::tests
