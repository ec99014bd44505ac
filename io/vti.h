// SPDX-License-Identifier: GPL-3.0-or-later
// Values on a regular grid, from VTK's XML image data: ASCII, inline base64 or appended, packed by ZLib or not.
// Source: the VTK file formats document, "XML file formats". Guarantee: what is wrong throws core::InputError with the
// file, the place and the cure. Cost: linear.
//
//     const io::ImageData image = io::read_vti("wind.vti");
//     const io::VtkData& velocity = image.array("velocity", 3);
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "io/vtk_array.h"

namespace dsc::io {

struct ImageData {
    std::string source;                   ///< the file, for messages
    Eigen::Vector3d origin;               ///< place of the first point
    Eigen::Vector3d spacing;              ///< positive
    std::array<std::size_t, 3> counts{};  ///< points in x, y and z; x runs fastest
    std::vector<VtkData> point_data;      ///< `components` numbers for each point

    /// The array of this name, or for an empty name the only one with so many components; throws core::InputError that
    /// lists what there is.
    const VtkData& array(const std::string& name, int components) const;
};

ImageData read_vti(const std::filesystem::path& path);

}  // namespace dsc::io
