// SPDX-License-Identifier: GPL-3.0-or-later
// What a triangle surface is and where it fails to be a closed, oriented manifold.
// Guarantee: combinatorial answers follow from the indices alone (vertices at the same place are different ones);
// whether a triangle is degenerate is decided exactly; the lists are in ascending order. Coordinates have to be finite
// and indices valid.
// Cost: O(n log n), about half a second per million triangles and 100 bytes per triangle. Self-intersections cost
// more, and are found by geometry/surface_intersections.h.
//
//     const geometry::SurfaceCheck check = geometry::check_surface(surface);
//     if (check.genus) std::cout << "genus " << *check.genus << ", volume " << *check.volume << '\n';
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/surface_data.h"

namespace dsc::geometry {

/// Two vertices, the lower index first.
using SurfaceEdge = std::array<std::uint32_t, 2>;

struct SurfaceCheck {
    std::vector<SurfaceEdge> open_edges;          ///< of one triangle
    std::vector<SurfaceEdge> non_manifold_edges;  ///< of three or more triangles
    std::vector<SurfaceEdge> misoriented_edges;   ///< of two triangles that run through it in the same direction
    /// At which the triangles are more than one fan. (An edge of three or more triangles holds its fan together: that
    /// is listed as an edge.)
    std::vector<std::uint32_t> non_manifold_vertices;
    std::vector<std::uint32_t> duplicated_triangles;  ///< with the three vertices of an earlier one
    /// Of no area. Those that name a vertex twice are left out of everything else, which changes no connection.
    std::vector<std::uint32_t> degenerate_triangles;

    std::size_t components = 0;  ///< connected by common vertices
    /// Vertices, edges and triangles; vertices of no triangle don't count.
    std::int64_t euler_characteristic = 0;
    double area = 0;
    /// Of all components together; when the surface is a closed, oriented manifold.
    std::optional<std::int64_t> genus;
    /// Enclosed, positive when the normals point outwards; when every edge has two triangles that agree.
    std::optional<double> volume;

    /// Every edge has exactly two triangles.
    bool is_closed() const { return open_edges.empty() && non_manifold_edges.empty(); }
    bool is_manifold() const { return non_manifold_edges.empty() && non_manifold_vertices.empty(); }
    /// Neighbours agree about the side their normals point to.
    bool is_oriented() const { return misoriented_edges.empty(); }
};

SurfaceCheck check_surface(const SurfaceData& surface);

}  // namespace dsc::geometry
