// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/parts.h"

#include <algorithm>
#include <numeric>

#include "core/assert.h"
#include "core/disjoint_sets.h"

namespace dsc::fluid {

namespace {

template <int Dimension, class IsJoined>
Parts joined(const SimplexMesh<Dimension>& mesh, const Elements<Dimension>& elements,
             std::span<const Facet<Dimension>> facets, IsJoined&& is_joined) {
    core::DisjointSets sets(mesh.cells.size());
    for (const auto& facet : facets)
        if (facet.opposite && is_joined(facet.cell, *facet.opposite)) sets.unite(facet.cell, *facet.opposite);
    Parts result;
    result.of_cell.resize(mesh.cells.size());
    for (std::uint32_t j = 0; j < mesh.cells.size(); ++j) {
        const std::uint32_t first = sets.find(j);
        if (first == j) {
            result.of_cell[j] = static_cast<std::uint32_t>(result.volumes.size());
            result.volumes.push_back(0);
        } else {
            result.of_cell[j] = result.of_cell[first];
        }
        result.volumes[result.of_cell[j]] += elements.volumes[j];
    }
    return result;
}

}  // namespace

template <int Dimension>
Parts parts(const SimplexMesh<Dimension>& mesh, const Elements<Dimension>& elements,
            std::span<const Facet<Dimension>> facets) {
    return joined(mesh, elements, facets,
                  [&](std::uint32_t a, std::uint32_t b) { return mesh.phases[a] == mesh.phases[b]; });
}

template <int Dimension>
Parts bodies(const SimplexMesh<Dimension>& mesh, const Elements<Dimension>& elements,
             std::span<const Facet<Dimension>> facets) {
    return joined(mesh, elements, facets, [](std::uint32_t, std::uint32_t) { return true; });
}

template <int Dimension>
std::vector<std::int32_t> parts_of_vertices(const SimplexMesh<Dimension>& mesh, const Parts& parts) {
    std::vector<std::int32_t> result(mesh.positions.size(), no_part);
    for (std::size_t j = 0; j < mesh.cells.size(); ++j)
        for (const std::uint32_t v : mesh.cells[j])
            if (result[v] == no_part) result[v] = static_cast<std::int32_t>(parts.of_cell[j]);
    return result;
}

template <int Dimension>
PartGroups group_parts(std::size_t old_count, std::span<const std::int32_t> old_part,
                       const SimplexMesh<Dimension>& mesh, const Parts& parts) {
    DSC_ASSERT(old_part.size() == mesh.positions.size());
    // Old parts first, then the new ones.
    core::DisjointSets sets(old_count + parts.volumes.size());
    for (std::size_t j = 0; j < mesh.cells.size(); ++j)
        for (const std::uint32_t v : mesh.cells[j])
            if (old_part[v] != no_part)
                sets.unite(static_cast<std::uint32_t>(old_part[v]),
                           static_cast<std::uint32_t>(old_count) + parts.of_cell[j]);
    for (std::size_t part = old_count; old_count > 0 && part < old_count + parts.volumes.size(); ++part)
        if (sets.find(static_cast<std::uint32_t>(part)) == part) sets.unite(0, static_cast<std::uint32_t>(part));
    PartGroups result;
    std::vector<std::size_t> group(old_count + parts.volumes.size());
    for (std::uint32_t i = 0; i < group.size(); ++i) {
        const std::uint32_t first = sets.find(i);
        group[i] = first == i ? result.count++ : group[first];
    }
    result.of_old.assign(group.begin(), group.begin() + static_cast<std::ptrdiff_t>(old_count));
    result.of_new.assign(group.begin() + static_cast<std::ptrdiff_t>(old_count), group.end());
    return result;
}

std::vector<double> regrouped_volumes(std::span<const double> kept, const PartGroups& groups, const Parts& parts) {
    std::vector<double> before(groups.count, 0.0), now(groups.count, 0.0);
    for (std::size_t i = 0; i < kept.size(); ++i) before[groups.of_old[i]] += kept[i];
    for (std::size_t i = 0; i < parts.volumes.size(); ++i) now[groups.of_new[i]] += parts.volumes[i];
    double lost = 0;
    for (std::size_t g = 0; g < groups.count; ++g)
        if (now[g] == 0) lost += before[g];
    const double all = std::accumulate(parts.volumes.begin(), parts.volumes.end(), 0.0);
    std::vector<double> result;
    for (std::size_t i = 0; i < parts.volumes.size(); ++i) {
        const std::size_t g = groups.of_new[i];
        result.push_back(parts.volumes[i] * (before[g] / now[g] + lost / all));
    }
    return result;
}

std::vector<double> compensating_growth(std::span<const double> cell_volumes, const Parts& parts,
                                        std::span<const double> kept, double relaxation, double dt) {
    std::vector<double> growth;
    growth.reserve(cell_volumes.size());
    for (std::size_t j = 0; j < cell_volumes.size(); ++j) {
        const std::uint32_t part = parts.of_cell[j];
        growth.push_back(cell_volumes[j] * relaxation * (kept[part] / parts.volumes[part] - 1) / dt);
    }
    return growth;
}

#define DSC_INSTANTIATE(D)                                                                       \
    template Parts parts(const SimplexMesh<D>&, const Elements<D>&, std::span<const Facet<D>>);  \
    template Parts bodies(const SimplexMesh<D>&, const Elements<D>&, std::span<const Facet<D>>); \
    template std::vector<std::int32_t> parts_of_vertices(const SimplexMesh<D>&, const Parts&);   \
    template PartGroups group_parts(std::size_t, std::span<const std::int32_t>, const SimplexMesh<D>&, const Parts&);
DSC_INSTANTIATE(2)
DSC_INSTANTIATE(3)
#undef DSC_INSTANTIATE

}  // namespace dsc::fluid
