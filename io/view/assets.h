// SPDX-License-Identifier: GPL-3.0-or-later
// The files embedded into the library for its HTML pages (io/CMakeLists.txt).
#pragma once

#include <string_view>

namespace dsc::io::assets {

std::string_view three();
std::string_view orbit_controls();
std::string_view line_segments_geometry();
std::string_view line_material();
std::string_view line_segments();
std::string_view style();
std::string_view tets();
std::string_view viewer();

}  // namespace dsc::io::assets
