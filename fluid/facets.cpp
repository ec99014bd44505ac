// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/facets.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/assert.h"

namespace dsc::fluid {

namespace {

// The facet opposite corner i, oriented outwards from a positive cell.
template <int Dimension>
std::array<std::uint32_t, Dimension> facet_opposite(const std::array<std::uint32_t, Dimension + 1>& cell,
                                                    std::size_t i) {
    std::array<std::uint32_t, Dimension> facet;
    for (std::size_t k = 0, n = 0; k <= Dimension; ++k)
        if (k != i) facet[n++] = cell[k];
    // Leaving out corner i changes the sign (-1)^i; seen from outside is the induced orientation in both dimensions.
    if (i % 2 == 1) std::swap(facet[0], facet[1]);
    return facet;
}

}  // namespace

template <int Dimension>
std::vector<Facet<Dimension>> facets(const SimplexMesh<Dimension>& mesh) {
    struct Side {
        std::array<std::uint32_t, Dimension> key;
        std::uint32_t cell;
        std::uint32_t corner;
        bool operator<(const Side& other) const { return key != other.key ? key < other.key : cell < other.cell; }
    };
    std::vector<Side> sides;
    sides.reserve(mesh.cells.size() * (Dimension + 1));
    for (std::uint32_t j = 0; j < mesh.cells.size(); ++j) {
        for (std::uint32_t i = 0; i <= Dimension; ++i) {
            auto key = facet_opposite<Dimension>(mesh.cells[j], i);
            std::sort(key.begin(), key.end());
            sides.push_back({key, j, i});
        }
    }
    std::sort(sides.begin(), sides.end());
    std::vector<Facet<Dimension>> result;
    result.reserve(sides.size() / 2 + 1);
    for (std::size_t n = 0; n < sides.size(); ++n) {
        const Side& side = sides[n];
        auto& facet = result.emplace_back();
        facet.vertices = facet_opposite<Dimension>(mesh.cells[side.cell], side.corner);
        facet.cell = side.cell;
        if (n + 1 < sides.size() && sides[n + 1].key == side.key) facet.opposite = sides[++n].cell;
        DSC_ASSERT(n + 1 == sides.size() || sides[n + 1].key != side.key);
    }
    std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.cell < b.cell; });
    return result;
}

template <>
Vector<2> area_vector<2>(const std::vector<Vector<2>>& positions, const std::array<std::uint32_t, 2>& facet) {
    const Vector<2> along = positions[facet[1]] - positions[facet[0]];
    return {along.y(), -along.x()};
}

template <>
Vector<3> area_vector<3>(const std::vector<Vector<3>>& positions, const std::array<std::uint32_t, 3>& facet) {
    const Vector<3>& a = positions[facet[0]];
    return 0.5 * (positions[facet[1]] - a).cross(positions[facet[2]] - a);
}

template std::vector<Facet<2>> facets(const SimplexMesh<2>&);
template std::vector<Facet<3>> facets(const SimplexMesh<3>&);

}  // namespace dsc::fluid
