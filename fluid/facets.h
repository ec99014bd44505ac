// SPDX-License-Identifier: GPL-3.0-or-later
// The facets of the fluid's cells: edges of triangles, faces of tetrahedra, with the cells on either side.
// Guarantee: each once, in the order of their first cells; oriented outwards from the first cell (counterclockwise seen
// from outside; in the plane, the cell is on the left). Cost: n log n.
#pragma once

#include <optional>
#include <vector>

#include "fluid/simplex_mesh.h"

namespace dsc::fluid {

template <int Dimension>
struct Facet {
    std::array<std::uint32_t, Dimension> vertices;
    std::uint32_t cell;                     ///< of lower number
    std::optional<std::uint32_t> opposite;  ///< the cell on the other side; none on the boundary of the fluid
};

template <int Dimension>
std::vector<Facet<Dimension>> facets(const SimplexMesh<Dimension>& mesh);

/// The normal of a facet times its measure (length or area).
template <int Dimension>
Vector<Dimension> area_vector(const std::vector<Vector<Dimension>>& positions,
                              const std::array<std::uint32_t, Dimension>& facet);

}  // namespace dsc::fluid
