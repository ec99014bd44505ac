// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/generate/delaunay.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <utility>
#include <vector>

#include "core/errors.h"

namespace dsc::dsc3d {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel>;
using Structure = CGAL::Triangulation_data_structure_3<Vertex, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, Structure>;

}  // namespace

geometry::TetData delaunay(std::span<const Point3> points) {
    geometry::TetData data;
    data.vertices.assign(points.begin(), points.end());
    std::vector<std::pair<Kernel::Point_3, std::uint32_t>> numbered;
    numbered.reserve(points.size());
    for (const Point3& p : points)
        numbered.emplace_back(Kernel::Point_3(p.x(), p.y(), p.z()), static_cast<std::uint32_t>(numbered.size()));
    const Delaunay triangulation(numbered.begin(), numbered.end());
    if (triangulation.dimension() < 3) throw core::UsageError("delaunay: all points are in a plane");
    data.tets.reserve(triangulation.number_of_finite_cells());
    for (const auto cell : triangulation.finite_cell_handles())
        data.tets.push_back(
            {cell->vertex(0)->info(), cell->vertex(1)->info(), cell->vertex(2)->info(), cell->vertex(3)->info()});
    return data;
}

}  // namespace dsc::dsc3d
