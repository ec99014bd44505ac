// SPDX-License-Identifier: GPL-3.0-or-later
// Area, length of the outline and topology of each label's region. The topology is that of its interior: parts that
// meet in a vertex only are apart.
// Source: Euler's formula; thesis 4.3.1 and 5.2.1 (topology changes and their control).
// Guarantee: the counts are exact; sums go over the faces and edges in the order of their handles. Cost: linear in the
// complex.
#pragma once

#include <cstdint>
#include <vector>

#include "core/fields.h"
#include "dsc2d/complex.h"

namespace dsc::dsc2d {

struct LabelStatistics {
    int label = 0;
    std::size_t triangles = 0;
    double area = 0;
    double interface_length = 0;  ///< of its edges towards other labels
    double boundary_length = 0;   ///< of its edges on the boundary of the domain
    std::int64_t components = 0;  ///< connected through edges
    std::int64_t holes = 0;       ///< components minus Euler characteristic; in the plane: of all components together
};

template <class Visitor, core::ConstOrNot<LabelStatistics> Value>
void fields(Visitor& visitor, Value& statistics) {
    auto& [label, triangles, area, interface_length, boundary_length, components, holes] = statistics;
    visitor(label, triangles, area, interface_length, boundary_length, components, holes);
}

/// One for each label, ascending.
std::vector<LabelStatistics> label_statistics(const Complex& complex);

}  // namespace dsc::dsc2d
