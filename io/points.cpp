// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/points.h"

#include <algorithm>
#include <string>

#include "core/errors.h"
#include "io/surface/formats.h"

namespace dsc::io {

namespace {

geometry::PointData read_by_extension(const std::filesystem::path& path) {
    if (std::filesystem::is_directory(path))
        throw core::InputError(path.string(), "", "is a folder", "name a file with points");
    const std::string extension = surface::extension_of(path);
    if (extension == ".ply") return surface::read_ply_points(path);
    if (extension == ".off") return surface::read_off_points(path);
    if (extension == ".obj") return surface::read_obj_points(path);
    for (const char* columns : {".xyz", ".txt", ".pts", ".asc", ".csv"}) {
        if (extension == columns) return surface::read_xyz(path);
    }
    throw core::InputError(path.string(), "",
                           extension.empty() ? "has no extension that tells its format"
                                             : "no format of points has the extension " + extension,
                           "use .xyz, .ply, .off or .obj");
}

}  // namespace

geometry::PointData read_points(const std::filesystem::path& path) {
    geometry::PointData data = read_by_extension(path);
    if (data.points.empty()) throw core::InputError(path.string(), "", "contains no points", "give a point cloud");
    return data;
}

}  // namespace dsc::io
