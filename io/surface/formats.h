// SPDX-License-Identifier: GPL-3.0-or-later
// One reader and one writer for each format; io/surface_mesh.h and io/points.h choose among them and say what they all
// guarantee.
#pragma once

#include <filesystem>
#include <string>

#include "geometry/point_data.h"
#include "io/surface_mesh.h"

namespace dsc::io::surface {

/// ".off" for "A.OFF".
std::string extension_of(const std::filesystem::path& path);

geometry::SurfaceData read_off(const std::filesystem::path& path);
geometry::PointData read_off_points(const std::filesystem::path& path);
void write_off(const std::filesystem::path& path, const geometry::SurfaceData& data);

geometry::SurfaceData read_obj(const std::filesystem::path& path);
geometry::PointData read_obj_points(const std::filesystem::path& path);
void write_obj(const std::filesystem::path& path, const geometry::SurfaceData& data);

geometry::SurfaceData read_ply(const std::filesystem::path& path);
geometry::PointData read_ply_points(const std::filesystem::path& path);
void write_ply(const std::filesystem::path& path, const geometry::SurfaceData& data, const SurfaceColumns& columns);

geometry::SurfaceData read_stl(const std::filesystem::path& path);
void write_stl(const std::filesystem::path& path, const geometry::SurfaceData& data);

geometry::PointData read_xyz(const std::filesystem::path& path);

}  // namespace dsc::io::surface
