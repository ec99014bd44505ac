// SPDX-License-Identifier: GPL-3.0-or-later
// Closed polygons from a file.
//
//     .svg    paths of lines and Bezier curves, and polygon elements (io/svg_paths.h)
//     .csv    x,y: one polygon; x,y,polygon: several, told apart by a number; x,y,polygon,label
//     .json   [[[x, y], ...], ...], or [{"label": 1, "points": [[x, y], ...]}, ...]
//
// The last side goes from the last point to the first one, which may be repeated. Without labels, a polygon inside
// another one is a hole, one inside a hole an object again (even-odd). Guarantee: polygons are simple and apart from
// each other; those inside come after those around them; not all labels are 0. Whatever is wrong throws
// core::InputError with the place.
// Cost: that of geometry/polygon_check.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dsc2d/generate/insert_polygon.h"

namespace dsc::flow::planar {

/// Curves of an SVG file are divided into chords no longer than the edge length.
std::vector<dsc2d::Region> read_polygons(const std::string& path, std::optional<double> edge_length);

}  // namespace dsc::flow::planar
