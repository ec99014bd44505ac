// SPDX-License-Identifier: GPL-3.0-or-later
// What the two versions of Gmsh's format share: sections, node numbers, kinds of elements.
// Source: Gmsh reference manual 4.8, 9.1 "MSH file format" (4.1) and 9.2.2 "MSH file format version 2".
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/tet/assembly.h"
#include "io/tet/node_numbering.h"
#include "io/tet/row_writer.h"
#include "io/text_scanner.h"

namespace dsc::io::tet {

inline constexpr int gmsh_tetrahedron = 4;  ///< its number as an element type

/// Reads what a version says of nodes, elements and entities; other sections are skipped.
class GmshReader {
public:
    /// The scanner stands behind $EndMeshFormat.
    explicit GmshReader(TextScanner scanner) : scanner_(std::move(scanner)), assembly_(scanner_.source(), 0) {}
    virtual ~GmshReader() = default;

    geometry::TetData read();

protected:
    virtual void read_nodes() = 0;
    virtual void read_elements() = 0;
    virtual void read_entities() = 0;

    void reserve_nodes(std::size_t count);
    void add_node(std::int64_t number, double x, double y, double z);
    /// The nodes of a tetrahedron and the end of its line.
    void read_tet(std::int64_t label);
    /// Throws when an element that is no tetrahedron must not be left out.
    void require_lower_dimension(std::int64_t type) const;

    TextScanner scanner_;
    TetAssembly assembly_;

private:
    void read_section(std::string_view name);
    void number_nodes();
    void skip_to(const std::string& end);

    std::vector<std::int64_t> numbers_;  // of the nodes, until they are all known
    std::optional<NodeNumbering> numbering_;
};

std::unique_ptr<GmshReader> gmsh_2_reader(TextScanner scanner);
std::unique_ptr<GmshReader> gmsh_4_reader(TextScanner scanner);

void write_gmsh_2(RowWriter& out, const geometry::TetData& data);
void write_gmsh_4(RowWriter& out, const geometry::TetData& data);

/// Labels and the tetrahedra with each, both in ascending order. Gmsh wants numbers from 1 for its volumes, which
/// labels need not be: volume i + 1 is that of entry i.
struct GmshVolume {
    int label = 0;
    std::vector<std::uint32_t> tets;
};
std::vector<GmshVolume> gmsh_volumes(const geometry::TetData& data);

}  // namespace dsc::io::tet
