// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes triangle surfaces: the format follows the file's extension.
//
//     .off   Object File Format, ASCII; also with normals, colours or texture coordinates (NOFF, COFF, STOFF), left out
//     .obj   Wavefront: v and f lines with indices of either sign; materials, groups and the rest are left out
//     .ply   Polygon File Format: ASCII and binary of either byte order, whatever properties; written as binary
//     .stl   Stereolithography: ASCII and binary; written as binary
//
// Labels are the property "label" of the faces in PLY; the other formats have no place for them. All labels 0 is the
// same as none.
//
// Guarantee: what is read has every vertex of the file, in its order, and every triangle with three different existing
// vertices. Polygons of more than three vertices are divided from their first vertex on. Whatever can't be read throws
// core::InputError with file, line (or number of the element) and cure. No count in a file is believed beyond what the
// file has room for. Coordinates are the same doubles after writing and reading, but for STL, which has room for floats
// only. Files are written aside and renamed. Whether the surface is closed, manifold and oriented is not looked at:
// geometry/surface_check.h does.
//
// STL has no vertices but corners: those of the same coordinates are one vertex, numbered as they come. Triangles that
// vanish thereby are left out, which keeps a closed surface closed: rounding to floats makes such ones.
//
// Cost: linear, below a second per million triangles; the peak of the memory is about the file and the data.
//
//     const geometry::SurfaceData surface = io::read_surface_mesh("part.stl");
//     io::write_surface_mesh("part.ply", surface, {.face_columns = {{"invented", is_invented}}});
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "geometry/surface_data.h"

namespace dsc::io {

enum class SurfaceFormat { off, obj, ply, stl };

/// One number for each vertex or triangle, under a name without blanks.
template <class Number>
struct SurfaceColumn {
    std::string name;
    std::span<const Number> values;
};

/// What a result says beyond its shape, for viewers and scripts. Only PLY has room for it: the other formats are
/// written without.
struct SurfaceColumns {
    std::vector<SurfaceColumn<double>> vertex_columns;
    std::vector<SurfaceColumn<int>> face_columns;
    std::span<const Eigen::Vector3d> normals;  ///< of the vertices, or none
};

/// The format of `path` by its extension; throws core::InputError when it is of none.
SurfaceFormat surface_format(const std::filesystem::path& path);

geometry::SurfaceData read_surface_mesh(const std::filesystem::path& path);

/// Throws as io::AtomicFile does, and core::InputError for coordinates beyond what STL has room for.
void write_surface_mesh(const std::filesystem::path& path, const geometry::SurfaceData& data,
                        const SurfaceColumns& columns = {});

/// Throws core::InputError unless write_surface_mesh() can write at `path`; leaves everything as it was. To be called
/// before a long computation whose result goes there.
void require_writable_surface_mesh(const std::filesystem::path& path);

}  // namespace dsc::io
