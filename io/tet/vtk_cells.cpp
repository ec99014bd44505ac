// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/tet/vtk_cells.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace dsc::io::tet {

namespace {

// Points, lines, triangles, quadrilaterals, polygons and the cells of higher order of these.
bool is_of_lower_dimension(std::int64_t type) {
    const auto in = [type](std::int64_t first, std::int64_t last) { return first <= type && type <= last; };
    return in(0, 9) || in(21, 23) || type == 28 || type == 30 || in(34, 36) || in(51, 54) || in(60, 63) || in(68, 70) ||
           in(75, 77);
}

const char* volume_name(std::int64_t type) {
    switch (type) {
        case 11:
        case 12: return "a hexahedron";
        case 13: return "a wedge";
        case 14: return "a pyramid";
        case 15:
        case 16: return "a prism";
        case 24:
        case 64:
        case 71:
        case 78: return "a tetrahedron of higher order";
        case 42: return "a polyhedron";
        default: return "of a kind that can't be read";
    }
}

}  // namespace

std::optional<int> label_rank(std::string_view array) {
    static constexpr std::string_view names[] = {vtk_label_name, "region", "medit:ref", "gmsh:physical"};
    const auto found = std::ranges::find(names, array);
    if (found == std::end(names)) return {};
    return static_cast<int>(found - names);
}

std::function<std::int64_t()> sizes_by_offsets(std::unique_ptr<NumberStream> offsets, bool has_start) {
    const std::shared_ptr<NumberStream> ends = std::move(offsets);
    if (has_start && ends->whole("an offset") != 0) ends->fail("the first offset is not 0", "correct it");
    return [ends, end = std::int64_t{0}]() mutable {
        const std::int64_t begin = std::exchange(end, ends->whole("an offset"));
        if (end < begin) ends->fail("an offset is less than the one before", "correct it");
        return end - begin;
    };
}

void read_vtk_points(NumberStream& numbers, std::size_t count, TetAssembly& assembly) {
    assembly.reserve_vertices(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double x = numbers.coordinate();
        const double y = numbers.coordinate();
        const double z = numbers.coordinate();
        assembly.add_vertex(x, y, z);
    }
}

void read_vtk_cells(VtkCells& cells, TetAssembly& assembly) {
    const auto reject = [&](const std::string& problem, const std::string& cure) {
        cells.connectivity->fail(problem, cure);
    };
    assembly.reserve_tets(cells.count);
    for (std::size_t i = 0; i < cells.count; ++i) {
        const std::int64_t type = cells.types->whole("the type of a cell");
        const std::int64_t size = cells.next_size();
        const std::int64_t label = cells.labels ? cells.labels->whole("a label") : 0;
        if (size < 0) reject("the size of a cell is negative", "correct it");
        if (type == vtk_tetrahedron) {
            if (size != 4) reject("a tetrahedron has " + std::to_string(size) + " vertices", "give it 4");
            std::array<std::int64_t, 4> tet{};
            for (std::int64_t& vertex : tet) vertex = cells.connectivity->whole("a vertex");
            assembly.add_tet(tet, label, reject);
        } else if (is_of_lower_dimension(type)) {
            cells.connectivity->skip(static_cast<std::uint64_t>(size));
        } else {
            cells.types->fail("the cell is " + std::string(volume_name(type)) + " (type " + std::to_string(type) + ")",
                              "make linear tetrahedra (ParaView: filter Tetrahedralize)");
        }
    }
    cells.types->require_end();
    cells.connectivity->require_end();
    if (cells.labels) cells.labels->require_end();
}

}  // namespace dsc::io::tet
