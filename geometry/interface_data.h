// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles between regions, with the label on either side, as plain arrays. More than two of them may share an
// edge: three regions meet there.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/surface_data.h"

namespace dsc::geometry {

struct InterfaceData {
    SurfaceData surface;  ///< without labels of its own
    /// Of each triangle: the label on the side its normal points to, and the one behind it.
    std::vector<std::array<int, 2>> sides;
};

}  // namespace dsc::geometry
