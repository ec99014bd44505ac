// SPDX-License-Identifier: GPL-3.0-or-later
// Tetrahedra out of the arrays of cells that VTK's two formats have. Source: vtkCellType.h, VTK 9.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>

#include "io/tet/assembly.h"
#include "io/tet/number_stream.h"

namespace dsc::io::tet {

inline constexpr int vtk_tetrahedron = 10;              ///< its number as a cell type
inline constexpr const char* vtk_label_name = "label";  ///< of the array that is written

/// How well the name of an array of cells fits for labels, 0 best; empty when it is none.
std::optional<int> label_rank(std::string_view array);

struct VtkCells {
    std::unique_ptr<NumberStream> types;
    std::unique_ptr<NumberStream> connectivity;
    /// How many vertices the next cell has; called once for each cell, before its vertices are read.
    std::function<std::int64_t()> next_size;
    std::unique_ptr<NumberStream> labels;  ///< may be absent
    std::size_t count = 0;
};

/// Sizes by the ends of the cells in the connectivity; with `has_start`, beginning with a 0 (legacy format 5).
std::function<std::int64_t()> sizes_by_offsets(std::unique_ptr<NumberStream> offsets, bool has_start);

/// Reads points up to `count`.
void read_vtk_points(NumberStream& numbers, std::size_t count, TetAssembly& assembly);
/// Reads all cells; those of lower dimension are left out.
void read_vtk_cells(VtkCells& cells, TetAssembly& assembly);

}  // namespace dsc::io::tet
