// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes for the tests of the 3D engine, made by own code: structured boxes with one or more labels, shaken and turned,
// a ball of tetrahedra around its centre, and fans around one edge.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "core/random.h"
#include "geometry/predicates.h"
#include "geometry/tet_data.h"
#include "geometry/tetrahedron_quality.h"

namespace dsc::tests {

using geometry::Point3;
using geometry::TetData;

/// All measures of the quality of a tetrahedron.
inline constexpr std::array quality_measures = {
    geometry::QualityMeasure::minimum_sine, geometry::QualityMeasure::minimum_biased_sine,
    geometry::QualityMeasure::volume_length, geometry::QualityMeasure::radius_ratio};

using Cells = std::array<std::uint32_t, 3>;

/// The box [0, x] x [0, y] x [0, z] of unit cubes, each cut in Kuhn's six tetrahedra along its diagonal.
inline TetData box(const Cells& cells) {
    TetData data;
    for (std::uint32_t k = 0; k <= cells[2]; ++k)
        for (std::uint32_t j = 0; j <= cells[1]; ++j)
            for (std::uint32_t i = 0; i <= cells[0]; ++i) data.vertices.emplace_back(i, j, k);
    const std::array<std::uint32_t, 3> stride = {1, cells[0] + 1, (cells[0] + 1) * (cells[1] + 1)};
    constexpr std::array<std::array<std::size_t, 3>, 6> ways = {
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};  // even ones first
    for (std::uint32_t k = 0; k < cells[2]; ++k) {
        for (std::uint32_t j = 0; j < cells[1]; ++j) {
            for (std::uint32_t i = 0; i < cells[0]; ++i) {
                for (std::size_t way = 0; way < 6; ++way) {
                    std::array<std::uint32_t, 4> tet = {i * stride[0] + j * stride[1] + k * stride[2]};
                    for (std::size_t step = 0; step < 3; ++step) tet[step + 1] = tet[step] + stride[ways[way][step]];
                    if (way >= 3) std::swap(tet[2], tet[3]);
                    data.tets.push_back(tet);
                }
            }
        }
    }
    return data;
}

/// Labels 0 .. count - 1 in slabs along x, one behind the other. Of a box: call it before anything is moved.
inline void label_slabs(TetData& data, const Cells& cells, int count) {
    data.labels.clear();
    for (const auto& tet : data.tets) {
        double x = 0;
        for (const std::uint32_t v : tet) x += 0.25 * data.vertices[v].x();
        data.labels.push_back(static_cast<int>(x * count / cells[0]));
    }
}

inline void label_randomly(TetData& data, int count, core::Random& random) {
    data.labels.clear();
    for (std::size_t i = 0; i < data.tets.size(); ++i)
        data.labels.push_back(static_cast<int>(random.below(static_cast<std::uint64_t>(count))));
}

/// Vertices with a face of one tetrahedron, or one between two labels.
inline std::vector<bool> surface_vertices(const TetData& data) {
    std::map<std::array<std::uint32_t, 3>, std::vector<int>> labels_at_face;
    for (std::size_t i = 0; i < data.tets.size(); ++i) {
        for (std::size_t out = 0; out < 4; ++out) {
            std::array<std::uint32_t, 3> face;
            for (std::size_t k = 0; k < 3; ++k) face[k] = data.tets[i][(out + 1 + k) % 4];
            std::sort(face.begin(), face.end());
            labels_at_face[face].push_back(data.label(i));
        }
    }
    std::vector<bool> is_surface(data.vertices.size(), false);
    for (const auto& [face, labels] : labels_at_face)
        if (labels.size() == 1 || labels[0] != labels[1])
            for (const std::uint32_t v : face) is_surface[v] = true;
    return is_surface;
}

inline bool is_positive(const TetData& data, std::size_t tet) {
    const auto& [a, b, c, d] = data.tets[tet];
    return geometry::is_positive(data.vertices[a], data.vertices[b], data.vertices[c], data.vertices[d]);
}

/// Moves every vertex inside a region by up to `reach` along each axis, unless a tetrahedron would be inverted.
inline void shake_inside(TetData& data, double reach, core::Random& random) {
    std::vector<std::vector<std::size_t>> star(data.vertices.size());
    for (std::size_t i = 0; i < data.tets.size(); ++i)
        for (const std::uint32_t v : data.tets[i]) star[v].push_back(i);
    const std::vector<bool> is_surface = surface_vertices(data);
    for (std::size_t v = 0; v < data.vertices.size(); ++v) {
        if (is_surface[v]) continue;
        const Point3 before = data.vertices[v];
        for (double& x : data.vertices[v]) x += random.uniform(-reach, reach);
        for (const std::size_t tet : star[v])
            if (!is_positive(data, tet)) data.vertices[v] = before;
    }
}

/// Moves every vertex by up to `reach` along each axis.
inline void shake_all(TetData& data, double reach, core::Random& random) {
    for (Point3& p : data.vertices)
        for (double& x : p) x += random.uniform(-reach, reach);
}

/// Turns and shifts everything, so that no plane lies along the axes.
inline Eigen::Isometry3d oblique_motion() {
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    motion.translate(Point3(0.3, -0.7, 0.2));
    motion.rotate(Eigen::AngleAxisd(0.7, Point3(1, 2, -3).normalized()));
    return motion;
}
inline void turn(TetData& data) {
    for (Point3& p : data.vertices) p = oblique_motion() * p;
}

/// The triangles of an icosahedron, each cut in four `levels` times, joined to the centre of the unit sphere.
inline TetData ball(int levels) {
    const double g = std::numbers::phi;
    TetData data;
    for (const double s : {-1.0, 1.0})
        for (const double t : {-g, g})
            for (std::size_t axis = 0; axis < 3; ++axis) {
                Point3 p;
                p[axis] = 0, p[(axis + 1) % 3] = s, p[(axis + 2) % 3] = t;
                data.vertices.push_back(p.normalized());
            }
    const auto det = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        return data.vertices[a].dot(data.vertices[b].cross(data.vertices[c]));
    };
    using Triangle = std::array<std::uint32_t, 3>;
    std::vector<Triangle> triangles;
    const auto are_joined = [&](std::uint32_t a, std::uint32_t b) {
        return (data.vertices[a] - data.vertices[b]).norm() < 1.1;
    };
    for (std::uint32_t a = 0; a < 12; ++a)
        for (std::uint32_t b = a + 1; b < 12; ++b)
            for (std::uint32_t c = b + 1; c < 12; ++c)
                if (are_joined(a, b) && are_joined(b, c) && are_joined(a, c))
                    triangles.push_back(det(a, b, c) > 0 ? Triangle{a, b, c} : Triangle{a, c, b});
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [entry, is_new] =
                middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(data.vertices.size()));
            if (is_new) data.vertices.push_back((data.vertices[a] + data.vertices[b]).normalized());
            return entry->second;
        };
        std::vector<Triangle> finer;
        for (const auto& [a, b, c] : triangles) {
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        triangles = std::move(finer);
    }
    const auto centre = static_cast<std::uint32_t>(data.vertices.size());
    data.vertices.push_back(Point3::Zero());
    for (const auto& [a, b, c] : triangles) data.tets.push_back({centre, a, b, c});
    return data;
}

/// n tetrahedra around the edge from vertex 0 (below) to vertex 1 (above), whose link, 2 .. n + 1, goes once around;
/// radii and heights of the link are shaken.
inline TetData fan(std::uint32_t n, double shake, core::Random& random) {
    TetData data;
    data.vertices = {Point3(0, 0, -1), Point3(0, 0, 1)};
    for (std::uint32_t i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * (i + random.uniform(-0.2, 0.2) * shake) / n;
        const double radius = 1 + random.uniform(-0.5, 0.5) * shake;
        data.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                                   random.uniform(-0.3, 0.3) * shake);
        data.tets.push_back({0, 1, 2 + i, 2 + (i + 1) % n});
    }
    return data;
}

inline TetData fan(std::uint32_t n) {
    core::Random unused(0);
    return fan(n, 0, unused);
}

}  // namespace dsc::tests
