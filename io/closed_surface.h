// SPDX-License-Identifier: GPL-3.0-or-later
// What a program asks of a surface that has to bound a volume: that it is closed, manifold and oriented, that no
// triangle is of no area, and that it nowhere meets itself.
// Guarantee: throws core::InputError that says what is wrong, how often, and where the first time, by coordinates;
// `source` is the file. Whether the normals point outwards is not asked: geometry::check_surface() gives the sign.
// Cost: that of geometry/surface_check.h and geometry/surface_intersections.h, some 4 s per million triangles.
//
//     const geometry::SurfaceData surface = io::read_surface_mesh(path);
//     io::require_closed_surface(path.string(), surface);
#pragma once

#include <string>

#include "geometry/surface_data.h"

namespace dsc::io {

void require_closed_surface(const std::string& source, const geometry::SurfaceData& surface);

}  // namespace dsc::io
