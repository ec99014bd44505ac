// SPDX-License-Identifier: GPL-3.0-or-later
// TetGen's pair of files. Source: H. Si, TetGen manual 1.5, sections 5.2.1 (.node) and 5.2.3 (.ele).
#include "io/tet/assembly.h"
#include "io/tet/formats.h"
#include "io/tet/row_writer.h"
#include "io/text_scanner.h"

namespace dsc::io::tet {

namespace {

std::filesystem::path with(const std::filesystem::path& stem, const char* extension) {
    std::filesystem::path path = stem;
    path += extension;
    return path;
}

// The numbers of rows are ignored by TetGen, but one that is out of order tells of a row that is missing or doubled.
void require_number(const TextScanner& scanner, std::int64_t number, std::int64_t expected) {
    if (number == expected) return;
    scanner.fail("number " + std::to_string(number) + " where " + std::to_string(expected) + " is expected",
                 "number the rows one by one");
}

std::int64_t read_first_index(TextScanner scanner) {
    const std::int64_t first = scanner.integer("the number of a vertex");
    if (first != 0 && first != 1)
        scanner.fail("the first vertex has the number " + std::to_string(first), "use 0 or 1");
    return first;
}

TetAssembly read_nodes(const std::filesystem::path& path, int& first_index) {
    const std::string text = read_file(path);
    TextScanner scanner(path.string(), text, {.comment = '#'});
    scanner.begin_record("the number of vertices");
    const std::size_t count = scanner.count("vertices", 8);
    if (count == 0) scanner.fail("no vertices are announced", "give the .node file of a mesh");
    if (!scanner.at_line_end() && scanner.integer("the dimension") != 3) {
        scanner.fail("the dimension is not 3", "give a tetrahedral mesh");
    }
    scanner.skip_record();

    const std::int64_t first = read_first_index(scanner);
    first_index = static_cast<int>(first);
    TetAssembly assembly(path.string(), first);
    assembly.reserve_vertices(count);
    for (std::size_t i = 0; i < count; ++i) {
        scanner.begin_record("a vertex");
        const std::int64_t number = scanner.integer("the number of a vertex");
        const double x = scanner.real("a coordinate");
        const double y = scanner.real("a coordinate");
        const double z = scanner.real("a coordinate");
        scanner.skip_record();
        require_number(scanner, number, first + static_cast<std::int64_t>(i));
        assembly.add_vertex(x, y, z);
    }
    scanner.require_end("vertices");
    return assembly;
}

void read_elements(const std::filesystem::path& path, TetAssembly& assembly) {
    const std::string text = read_file(path);
    TextScanner scanner(path.string(), text, {.comment = '#'});
    const auto reject = [&](const std::string& problem, const std::string& cure) { scanner.fail(problem, cure); };
    scanner.begin_record("the number of tetrahedra");
    const std::size_t count = scanner.count("tetrahedra", 10);
    if (count == 0) scanner.fail("no tetrahedra are announced", "give a volume mesh, not a surface");
    const std::int64_t corners = scanner.at_line_end() ? 4 : scanner.integer("the number of corners");
    if (corners != 4) {
        scanner.fail("the tetrahedra have " + std::to_string(corners) + " vertices", "make linear ones, of 4 vertices");
    }
    const bool has_label = !scanner.at_line_end() && scanner.integer("the number of attributes") > 0;
    scanner.skip_record();

    assembly.reserve_tets(count);
    std::int64_t first = 0;
    for (std::size_t i = 0; i < count; ++i) {
        scanner.begin_record("a tetrahedron");
        const std::int64_t number = scanner.integer("the number of a tetrahedron");
        std::array<std::int64_t, 4> tet{};
        for (std::int64_t& vertex : tet) vertex = scanner.integer("the number of a vertex");
        const std::int64_t label = has_label ? scanner.whole_number("the region") : 0;
        scanner.skip_record();
        if (i == 0) first = number;
        require_number(scanner, number, first + static_cast<std::int64_t>(i));
        assembly.add_tet(tet, label, reject);
    }
    scanner.require_end("tetrahedra");
}

}  // namespace

geometry::TetData read_tetgen(const std::filesystem::path& stem, int& first_index) {
    TetAssembly assembly = read_nodes(with(stem, ".node"), first_index);
    read_elements(with(stem, ".ele"), assembly);
    return assembly.finish();
}

void write_tetgen(const std::filesystem::path& stem, const geometry::TetData& data, int first_index) {
    RowWriter nodes(with(stem, ".node"));
    RowWriter elements(with(stem, ".ele"));
    const auto first = static_cast<std::uint64_t>(first_index);
    nodes.row(data.vertices.size(), 3, 0, 0);
    for (std::size_t i = 0; i < data.vertices.size(); ++i) nodes.row(first + i, data.vertices[i]);

    elements.row(data.tets.size(), 4, data.labels.empty() ? 0 : 1);
    for (std::size_t i = 0; i < data.tets.size(); ++i) {
        const auto [a, b, c, d] = data.tets[i];
        // The last two are exchanged for TetGen's sign.
        if (data.labels.empty()) {
            elements.row(first + i, first + a, first + b, first + d, first + c);
        } else {
            elements.row(first + i, first + a, first + b, first + d, first + c, data.labels[i]);
        }
    }
    nodes.file().finish();
    elements.file().finish();
    nodes.file().commit();
    elements.file().commit();
}

}  // namespace dsc::io::tet
