// SPDX-License-Identifier: GPL-3.0-or-later
// Volume, area and topology of each label's region. The topology is that of its interior: parts that meet in a vertex
// or an edge only are apart, and a boundary surface that touches itself there is taken as it is seen from inside.
// Source: Euler's formula; thesis 4.3.1 and 5.2.1 (topology changes and their control).
// Guarantee: genus and numbers are exact; sums go over the simplices in the order of their handles. Cost: linear in the
// mesh, about a microsecond per tetrahedron.
#pragma once

#include <cstdint>
#include <vector>

#include "core/fields.h"
#include "dsc3d/mesh.h"

namespace dsc::dsc3d {

struct LabelStatistics {
    int label = 0;
    std::size_t tets = 0;
    double volume = 0;
    double interface_area = 0;    ///< of its faces towards other labels
    double boundary_area = 0;     ///< of its faces on the boundary of the domain
    std::int64_t components = 0;  ///< connected through faces
    std::int64_t surfaces = 0;    ///< connected parts of its surface: more than components when there are cavities
    std::int64_t genus = 0;       ///< handles of all these surfaces together
};

template <class Visitor, core::ConstOrNot<LabelStatistics> Value>
void fields(Visitor& visitor, Value& statistics) {
    auto& [label, tets, volume, interface_area, boundary_area, components, surfaces, genus] = statistics;
    visitor(label, tets, volume, interface_area, boundary_area, components, surfaces, genus);
}

/// One for each label, ascending.
std::vector<LabelStatistics> label_statistics(const Mesh& mesh);

}  // namespace dsc::dsc3d
