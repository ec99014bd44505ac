// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/random_delaunay.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <utility>
#include <vector>

#include "core/random.h"

namespace dsc::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel>;
using Structure = CGAL::Triangulation_data_structure_3<Vertex, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, Structure>;

constexpr double tets_per_point = 6.77;  // 24 pi^2 / 35, for many points

}  // namespace

geometry::TetData random_delaunay(std::size_t tets, std::uint64_t seed) {
    core::Random random(seed);
    geometry::TetData data;
    std::vector<std::pair<Kernel::Point_3, std::uint32_t>> points;
    const auto count = static_cast<std::uint32_t>(static_cast<double>(tets) / tets_per_point) + 4;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double x = random.uniform(), y = random.uniform(), z = random.uniform();
        data.vertices.emplace_back(x, y, z);
        points.emplace_back(Kernel::Point_3(x, y, z), i);
    }
    const Delaunay delaunay(points.begin(), points.end());
    for (const auto cell : delaunay.finite_cell_handles())
        data.tets.push_back(
            {cell->vertex(0)->info(), cell->vertex(1)->info(), cell->vertex(2)->info(), cell->vertex(3)->info()});
    return data;
}

}  // namespace dsc::bench
