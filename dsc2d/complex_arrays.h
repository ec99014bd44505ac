// SPDX-License-Identifier: GPL-3.0-or-later
// A complex as plain arrays, handle by handle, to be kept and made again. Guarantee: the same handles in the same
// places, deleted ones too, so that all that follows goes the same way bit for bit; attributes of others begin anew.
// Cost: linear.
//
//     const ComplexArrays arrays = complex.arrays();
//     Complex same(complex.domain(), arrays);
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/fields.h"
#include "dsc2d/complex.h"

namespace dsc::dsc2d {

struct ComplexArrays {
    /// In place of the face of a boundary half-edge, and of the first number of a deleted element.
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    // Of vertices
    std::vector<std::uint32_t> outgoing;  ///< a half-edge
    std::vector<Point2> positions;
    std::vector<std::uint8_t> is_locked;
    // Of half-edges
    std::vector<std::uint32_t> ends;  ///< vertices
    std::vector<std::uint32_t> next, faces;
    std::vector<LatticeVector> offsets;
    // Of faces
    std::vector<std::uint32_t> halfedges;  ///< one of the three
    std::vector<int> labels;
};

template <class Visitor, core::ConstOrNot<ComplexArrays> Value>
void fields(Visitor& visitor, Value& arrays) {
    auto& [outgoing, positions, is_locked, ends, next, faces, offsets, halfedges, labels] = arrays;
    visitor(outgoing, positions, is_locked, ends, next, faces, offsets, halfedges, labels);
}

}  // namespace dsc::dsc2d
