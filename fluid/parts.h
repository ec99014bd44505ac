// SPDX-License-Identifier: GPL-3.0-or-later
// The connected parts of a fluid (drops, if there is one phase), their volumes, and how these are kept while the parts
// merge and split. Source: thesis 6.4.5, per part, so that no drop grows at the cost of another. Guarantee: the volumes
// to keep always sum to that at the start. Cost: linear.
#pragma once

#include <span>
#include <vector>

#include "fluid/elements.h"
#include "fluid/facets.h"

namespace dsc::fluid {

/// Cells of one phase that share facets.
struct Parts {
    std::vector<std::uint32_t> of_cell;
    std::vector<double> volumes;  ///< of each part; parts are numbered by their first cells
};

template <int Dimension>
Parts parts(const SimplexMesh<Dimension>& mesh, const Elements<Dimension>& elements,
            std::span<const Facet<Dimension>> facets);

/// Cells of any phase that share facets: what keeps its momentum.
template <int Dimension>
Parts bodies(const SimplexMesh<Dimension>& mesh, const Elements<Dimension>& elements,
             std::span<const Facet<Dimension>> facets);

/// The number of the part of a vertex that has none yet.
inline constexpr std::int32_t no_part = -1;

/// Of each vertex: the part of the first of its cells.
template <int Dimension>
std::vector<std::int32_t> parts_of_vertices(const SimplexMesh<Dimension>& mesh, const Parts& parts);

/// Groups of old and new parts that have vertices in common: what a group has of a conserved quantity before is what it
/// has after. Each new part gets its group, numbered from 0; so does each old one. New parts without an old one join
/// the first group.
struct PartGroups {
    std::size_t count = 0;
    std::vector<std::size_t> of_old, of_new;
};

/// `old_part` of each vertex of the new mesh: no_part for those made since.
template <int Dimension>
PartGroups group_parts(std::size_t old_count, std::span<const std::int32_t> old_part,
                       const SimplexMesh<Dimension>& mesh, const Parts& parts);

/// Volumes to keep after parts have merged and split: those of a group go to its new parts in proportion to what they
/// have. A group that has lost all of its parts leaves its volume to the others in the same way.
std::vector<double> regrouped_volumes(std::span<const double> kept, const PartGroups& groups, const Parts& parts);

/// The growth of each cell that brings each part nearer to the volume to keep: V_j tau (V_0 - V_c) / (dt V_c).
std::vector<double> compensating_growth(std::span<const double> cell_volumes, const Parts& parts,
                                        std::span<const double> kept, double relaxation, double dt);

}  // namespace dsc::fluid
