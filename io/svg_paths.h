// SPDX-License-Identifier: GPL-3.0-or-later
// The paths of an SVG picture as polygons: `d` attributes of path elements, and polygon elements, with the transforms
// they stand in (translate, scale, rotate, matrix, skewX, skewY).
// Source: SVG 1.1, chapters 7 and 8. Commands M L H V C S Q T Z, absolute and relative; arcs (A) are refused, and so
// are rect, circle, ellipse, line, use, text and image. y points up, as everywhere here, so that shapes look as in the
// picture. Guarantee: Bezier curves are divided into chords no longer than the edge length, a million of them at most;
// what can't be read throws core::InputError with the file, the number of the path and the place in it. Cost: linear.
//
//     const std::vector<io::SvgPath> paths = io::read_svg_paths("logo.svg", 0.5);
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dsc::io {

struct SvgPath {
    std::string name;  ///< for messages: "path 3", or "path 3, part 2" when the path has several subpaths
    std::vector<Eigen::Vector2d> points;
    bool is_closed = false;  ///< by Z, or because it ends where it begins; the first point is not repeated
};

/// One for each subpath. Without an edge length, curves get one hundredth of the size of the picture's paths and their
/// control points.
std::vector<SvgPath> read_svg_paths(const std::filesystem::path& path, std::optional<double> edge_length);

}  // namespace dsc::io
