// SPDX-License-Identifier: GPL-3.0-or-later
// Reads point clouds: the format follows the file's extension.
//
//     .xyz .txt .pts .asc .csv   a point for each line: x y z, or x y z nx ny nz and whatever follows, separated by
//                                blanks or commas, "#" before comments. Before the points there may be a line with
//                                their count, as scanners write .pts (then columns after the third are normals only
//                                when there are six), or with the names of the columns, x, y, z and perhaps nx, ny,
//                                nz among them, in any order
//     .ply                       the vertices, with nx, ny, nz when they are there
//     .off .obj                  the vertices, with the normals of NOFF
//
// Six columns may be x y z and a colour, too: when the last three of all lines are whole numbers from 0 to 255, some of
// them greater than 1, they are no normals and left out.
//
// Guarantee: at least one point; every point of the file, in its order; all numbers finite. Whatever can't be read
// throws core::InputError with file, line (or number of the row) and cure. No count in a file is believed beyond what
// the file has room for. Duplicates and normals of length 0 stay.
//
// Cost: linear, about 0.2 s per million points; the peak of the memory is the file and the data.
//
//     const geometry::PointData cloud = io::read_points("scan.xyz");
#pragma once

#include <filesystem>

#include "geometry/point_data.h"

namespace dsc::io {

geometry::PointData read_points(const std::filesystem::path& path);

}  // namespace dsc::io
