// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/tet/gmsh.h"

#include <map>

#include "io/tet/formats.h"

namespace dsc::io::tet {

namespace {

// Points, lines, triangles, quadrilaterals and polygons of every order, by the numbers of GmshDefines.h.
bool has_lower_dimension_in_gmsh(std::int64_t type) {
    const auto in = [type](std::int64_t first, std::int64_t last) { return first <= type && type <= last; };
    return in(1, 3) || in(8, 10) || in(15, 16) || in(20, 28) || type == 34 || in(36, 70);
}

const char* gmsh_volume_name(std::int64_t type) {
    switch (type) {
        case 5: return "a hexahedron";
        case 6: return "a prism";
        case 7: return "a pyramid";
        case 11:
        case 29:
        case 30:
        case 31:
        case 32:
        case 33: return "a tetrahedron of higher order";
        case 12:
        case 17: return "a hexahedron of higher order";
        case 13:
        case 18: return "a prism of higher order";
        case 14:
        case 19: return "a pyramid of higher order";
        default: return "of a kind that can't be read";
    }
}

}  // namespace

geometry::TetData GmshReader::read() {
    while (!scanner_.at_end()) {
        const std::string_view name = scanner_.word("a section");
        if (!name.starts_with('$')) {
            scanner_.fail(in_quotes(name) + " where a section is expected", "correct the count of the section before");
        }
        read_section(name.substr(1));
    }
    return assembly_.finish();
}

void GmshReader::read_section(std::string_view name) {
    const std::string end = "$End" + std::string(name);
    if (name == "Nodes") {
        if (numbering_) scanner_.fail("there is a second section $Nodes", "join the two");
        read_nodes();
        number_nodes();
    } else if (name == "Elements") {
        if (!numbering_) scanner_.fail("$Elements comes before $Nodes", "save the mesh again with Gmsh");
        read_elements();
    } else if (name == "Entities") {
        read_entities();
    } else {
        skip_to(end);
        return;
    }
    if (const std::string_view word = scanner_.word(end.c_str()); word != end) {
        scanner_.fail(in_quotes(word) + " where " + end + " is expected", "correct the count of the section");
    }
}

void GmshReader::skip_to(const std::string& end) {
    while (scanner_.word(end.c_str()) != end) {
    }
}

void GmshReader::reserve_nodes(std::size_t count) {
    assembly_.reserve_vertices(count);
    numbers_.reserve(count);
}

void GmshReader::add_node(std::int64_t number, double x, double y, double z) {
    numbers_.push_back(number);
    assembly_.add_vertex(x, y, z);
}

void GmshReader::number_nodes() {
    numbering_.emplace(numbers_);
    if (const auto repeated = numbering_->repeated()) {
        scanner_.fail("the node " + std::to_string(*repeated) + " occurs twice", "give each node a number of its own");
    }
    numbers_ = {};
}

void GmshReader::read_tet(std::int64_t label) {
    std::array<std::int64_t, 4> tet{};
    for (std::int64_t& node : tet) {
        const std::int64_t number = scanner_.integer("a node");
        const std::uint32_t vertex = numbering_->vertex(number);
        if (vertex == NodeNumbering::none) {
            scanner_.fail("the node " + std::to_string(number) + " does not exist", "use those of $Nodes");
        }
        node = vertex;
    }
    scanner_.end_record();
    assembly_.add_tet(tet, label, [&](const std::string& problem, const std::string& cure) {  //
        scanner_.fail(problem, cure);
    });
}

void GmshReader::require_lower_dimension(std::int64_t type) const {
    if (has_lower_dimension_in_gmsh(type)) return;
    scanner_.fail("the element is " + std::string(gmsh_volume_name(type)) + " (type " + std::to_string(type) + ")",
                  "make linear tetrahedra (gmsh -3 -order 1)");
}

std::vector<GmshVolume> gmsh_volumes(const geometry::TetData& data) {
    std::map<int, std::size_t> place;
    std::vector<GmshVolume> volumes;
    for (const int label : data.labels) place.try_emplace(label, 0);
    if (data.labels.empty()) place.try_emplace(0, 0);
    for (auto& [label, index] : place) {
        index = volumes.size();
        volumes.push_back({.label = label, .tets = {}});
    }
    for (std::size_t i = 0; i < data.tets.size(); ++i) {
        volumes[place.at(data.label(i))].tets.push_back(static_cast<std::uint32_t>(i));
    }
    return volumes;
}

geometry::TetData read_gmsh(const std::filesystem::path& path, GmshVersion& version) {
    const std::string text = read_file(path);
    TextScanner scanner(path.string(), text);
    if (scanner.word("$MeshFormat") != "$MeshFormat") {
        scanner.fail("is no Gmsh mesh: it does not begin with $MeshFormat", "save it with gmsh -format msh41");
    }
    const double number = scanner.real("the version");
    const bool is_version_2 = number >= 2 && number < 3;
    if (!is_version_2 && number != 4.1) {
        scanner.fail("the version " + number_text(number) + " can't be read", "save it with gmsh -format msh41");
    }
    version = is_version_2 ? GmshVersion::v2_2 : GmshVersion::v4_1;
    if (scanner.integer("the file type") != 0) {
        scanner.fail("the file is binary", "save it as text (gmsh -format msh41, without -bin)");
    }
    scanner.integer("the size of numbers");
    if (scanner.word("$EndMeshFormat") != "$EndMeshFormat") {
        scanner.fail("$EndMeshFormat is missing", "save it with gmsh -format msh41");
    }
    return (is_version_2 ? gmsh_2_reader(scanner) : gmsh_4_reader(scanner))->read();
}

void write_gmsh(const std::filesystem::path& path, const geometry::TetData& data, GmshVersion version) {
    RowWriter out(path);
    if (version == GmshVersion::v2_2) {
        write_gmsh_2(out, data);
    } else {
        write_gmsh_4(out, data);
    }
    out.file().commit();
}

}  // namespace dsc::io::tet
