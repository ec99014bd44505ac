// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes labelled tetrahedral meshes: the format follows the file's extension.
//
//     .node .ele   TetGen; either name or what they have in common ("house", "house.1")
//     .mesh        MEDIT, ASCII
//     .msh         Gmsh 2.2 and 4.1, ASCII
//     .vtu         VTK XML: ASCII, base64 and appended arrays, uncompressed or by zlib; written as base64
//     .vtk         VTK legacy: ASCII and binary, versions 2 to 5.1; written as ASCII 3.0
//
// Labels: a TetGen attribute, the MEDIT reference, the Gmsh physical group (else, in 4.1, the entity), a VTK cell array
// "label", "region", "medit:ref" or "gmsh:physical". All labels 0 is the same as none.
//
// Guarantee: what is read has every vertex of the file, in its order, and every tetrahedron with four different
// existing vertices. Cells of lower dimension are left out; volume cells of another kind, and whatever else can't be
// read, throw core::InputError with file, line (or number of the element) and cure. No count in a file is believed
// beyond what the file has room for. Coordinates are the same doubles after writing and reading. Files are written
// aside and renamed, the two of TetGen only when both are complete.
//
// Orientation: the mesh as a whole is turned, by exchanging the last two vertices of every tetrahedron, when its total
// signed volume, the sum of det[b - a, c - a, d - a], is negative. So TetGen's files, whose convention is the opposite
// one, and mirrored files come out positive; single inverted or flat tetrahedra stay, for the mesh to find, as do faces
// with more than two tetrahedra. TetGen's files are written with TetGen's sign (< 0), the others with > 0.
//
// Cost: linear, below a second per million tetrahedra; the peak of the memory is about the file and the data.
//
//     io::TetMeshFile mesh = io::read_tet_mesh("house.node");
//     improve(mesh.data);
//     io::write_tet_mesh("better.node", mesh.data, mesh.dialect);
#pragma once

#include <filesystem>

#include "geometry/tet_data.h"

namespace dsc::io {

enum class TetFormat { tetgen, medit, gmsh, vtu, legacy_vtk };

enum class GmshVersion { v2_2, v4_1 };

/// What the extension leaves open. Readers say what they found, so that a result can be written as its input was.
struct TetMeshDialect {
    int first_index = 0;  ///< number of the first vertex in TetGen files: 0 or 1
    GmshVersion gmsh = GmshVersion::v4_1;
};

struct TetMeshFile {
    geometry::TetData data;
    TetFormat format = TetFormat::tetgen;
    TetMeshDialect dialect;
};

/// The format of `path` by its extension; none, or a number as in "house.1", is TetGen's. Throws core::InputError for
/// any other one.
TetFormat tet_format(const std::filesystem::path& path);

TetMeshFile read_tet_mesh(const std::filesystem::path& path);

/// Writes labels when there are any. Throws as io::AtomicFile does.
void write_tet_mesh(const std::filesystem::path& path, const geometry::TetData& data,
                    const TetMeshDialect& dialect = {});

/// Throws core::InputError unless write_tet_mesh() can write at `path`; leaves everything as it was. To be called
/// before a long computation whose result goes there.
void require_writable_tet_mesh(const std::filesystem::path& path);

}  // namespace dsc::io
