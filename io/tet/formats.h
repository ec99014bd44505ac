// SPDX-License-Identifier: GPL-3.0-or-later
// One reader and one writer for each format; io/tet_mesh.h chooses among them and says what they all guarantee.
#pragma once

#include <filesystem>

#include "io/tet_mesh.h"

namespace dsc::io::tet {

/// `stem` is the path without .node and .ele.
geometry::TetData read_tetgen(const std::filesystem::path& stem, int& first_index);
void write_tetgen(const std::filesystem::path& stem, const geometry::TetData& data, int first_index);

geometry::TetData read_medit(const std::filesystem::path& path);
void write_medit(const std::filesystem::path& path, const geometry::TetData& data);

geometry::TetData read_gmsh(const std::filesystem::path& path, GmshVersion& version);
void write_gmsh(const std::filesystem::path& path, const geometry::TetData& data, GmshVersion version);

geometry::TetData read_vtu(const std::filesystem::path& path);
void write_vtu(const std::filesystem::path& path, const geometry::TetData& data);

geometry::TetData read_legacy_vtk(const std::filesystem::path& path);
void write_legacy_vtk(const std::filesystem::path& path, const geometry::TetData& data);

}  // namespace dsc::io::tet
