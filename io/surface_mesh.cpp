// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface_mesh.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "core/assert.h"
#include "core/errors.h"
#include "io/atomic_file.h"
#include "io/surface/formats.h"

namespace dsc::io {

namespace {

[[maybe_unused]] bool is_consistent(const geometry::SurfaceData& data) {
    return (data.labels.empty() || data.labels.size() == data.triangles.size()) &&
           std::ranges::all_of(data.triangles, [&](const auto& triangle) {
               return std::ranges::all_of(triangle, [&](std::uint32_t v) { return v < data.vertices.size(); });
           });
}

[[maybe_unused]] bool do_fit(const SurfaceColumns& columns, const geometry::SurfaceData& data) {
    const auto is_column = [](const auto& column, std::size_t size) {
        return !column.name.empty() && column.name.find_first_of(" \t\r\n") == column.name.npos &&
               column.values.size() == size;
    };
    const auto is_of_vertices = [&](const auto& column) { return is_column(column, data.vertices.size()); };
    const auto is_of_faces = [&](const auto& column) { return is_column(column, data.triangles.size()); };
    return std::ranges::all_of(columns.vertex_columns, is_of_vertices) &&
           std::ranges::all_of(columns.face_columns, is_of_faces) &&
           (columns.normals.empty() || columns.normals.size() == data.vertices.size());
}

}  // namespace

std::string surface::extension_of(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

SurfaceFormat surface_format(const std::filesystem::path& path) {
    const std::string extension = surface::extension_of(path);
    if (extension == ".off") return SurfaceFormat::off;
    if (extension == ".obj") return SurfaceFormat::obj;
    if (extension == ".ply") return SurfaceFormat::ply;
    if (extension == ".stl") return SurfaceFormat::stl;
    throw core::InputError(path.string(), "",
                           extension.empty() ? "has no extension that tells its format"
                                             : "no format of surfaces has the extension " + extension,
                           "use .off, .obj, .ply or .stl");
}

geometry::SurfaceData read_surface_mesh(const std::filesystem::path& path) {
    switch (surface_format(path)) {
        case SurfaceFormat::off: return surface::read_off(path);
        case SurfaceFormat::obj: return surface::read_obj(path);
        case SurfaceFormat::ply: return surface::read_ply(path);
        default: return surface::read_stl(path);
    }
}

void write_surface_mesh(const std::filesystem::path& path, const geometry::SurfaceData& data,
                        const SurfaceColumns& columns) {
    DSC_ASSERT(is_consistent(data));
    DSC_ASSERT(do_fit(columns, data));
    switch (surface_format(path)) {
        case SurfaceFormat::off: surface::write_off(path, data); break;
        case SurfaceFormat::obj: surface::write_obj(path, data); break;
        case SurfaceFormat::ply: surface::write_ply(path, data, columns); break;
        case SurfaceFormat::stl: surface::write_stl(path, data); break;
    }
}

void require_writable_surface_mesh(const std::filesystem::path& path) {
    surface_format(path);
    require_writable(path);
}

}  // namespace dsc::io
