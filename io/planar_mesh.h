// SPDX-License-Identifier: GPL-3.0-or-later
// Labelled triangulations of the plane in MEDIT's text format: Dimension 2, sections Vertices and Triangles, the label
// as the reference of a triangle. Source: P. Frey, MEDIT, INRIA RT-0253, appendix.
// Guarantee: coordinates are the same doubles after writing and reading; z is 0. A mesh whose triangles all go round
// clockwise is turned as a whole. What can't be read throws core::InputError with file and line. The other sections are
// left out. Cost: linear.
//
//     io::write_planar_mesh("final.mesh", data);
#pragma once

#include <filesystem>

#include "geometry/surface_data.h"

namespace dsc::io {

geometry::SurfaceData read_planar_mesh(const std::filesystem::path& path);
void write_planar_mesh(const std::filesystem::path& path, const geometry::SurfaceData& data);

}  // namespace dsc::io
