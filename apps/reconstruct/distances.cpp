// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/distances.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>

#include "core/parallel.h"

namespace dsc::reconstruct {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using KernelTriangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, KernelTriangles::const_iterator>;

Kernel::Point_3 cgal_point(const Point3& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace

std::vector<double> distances_from_surface(std::span<const Point3> points, const geometry::SurfaceData& surface,
                                           int threads) {
    KernelTriangles triangles;
    triangles.reserve(surface.triangles.size());
    for (const auto& [a, b, c] : surface.triangles)
        triangles.emplace_back(cgal_point(surface.vertices[a]), cgal_point(surface.vertices[b]),
                               cgal_point(surface.vertices[c]));
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree(triangles.cbegin(), triangles.cend());
    tree.accelerate_distance_queries();
    tree.closest_point(cgal_point(points.empty() ? Point3(Point3::Zero()) : points.front()));  // builds the trees once
    std::vector<double> distances(points.size());
    core::parallel_for(points.size(), {.threads = threads},
                       [&](std::size_t i) { distances[i] = std::sqrt(tree.squared_distance(cgal_point(points[i]))); });
    return distances;
}

}  // namespace dsc::reconstruct
