// SPDX-License-Identifier: GPL-3.0-or-later
// A velocity from a file: VTK's XML image data with a vector at every point of a regular grid, which stays the same all
// the time. Guarantee: continuous; outside the grid that of the nearest place on it; in the plane the grid has one
// layer, whose third coordinates don't count. Cost: the file is read once; motion/grid_field.h.
#pragma once

#include <string>

#include "motion/velocity.h"

namespace dsc::flow {

/// Of the array of this name, or for an empty name of the only one with three components. Throws core::InputError for a
/// file that can't be read, has no such array, or numbers that are not finite. Dimension is 2 or 3.
template <int Dimension>
motion::VelocityField<Dimension> velocity_from_file(const std::string& path, const std::string& array);

extern template motion::VelocityField<2> velocity_from_file<2>(const std::string& path, const std::string& array);
extern template motion::VelocityField<3> velocity_from_file<3>(const std::string& path, const std::string& array);

}  // namespace dsc::flow
