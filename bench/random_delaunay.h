// SPDX-License-Identifier: GPL-3.0-or-later
// Seeded random points of the unit cube and their Delaunay tetrahedralization, slivers and all. CGAL stays behind the
// .cpp wall. Cost: some 5 us per tetrahedron.
#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/tet_data.h"

namespace dsc::bench {

/// About `tets` tetrahedra.
geometry::TetData random_delaunay(std::size_t tets, std::uint64_t seed);

}  // namespace dsc::bench
