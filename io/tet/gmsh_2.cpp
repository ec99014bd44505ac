// SPDX-License-Identifier: GPL-3.0-or-later
// Gmsh 2.2: a list of nodes and a list of elements with tags, the first of which is the physical group.
#include "io/tet/gmsh.h"

namespace dsc::io::tet {

namespace {

constexpr std::size_t least_node_line = 8;
constexpr std::size_t least_element_line = 8;

class Gmsh2Reader : public GmshReader {
public:
    using GmshReader::GmshReader;

private:
    void read_nodes() override {
        const std::size_t count = scanner_.count("nodes", least_node_line);
        reserve_nodes(count);
        for (std::size_t i = 0; i < count; ++i) {
            scanner_.begin_record("a node");
            const std::int64_t number = scanner_.integer("the number of a node");
            const double x = scanner_.real("a coordinate");
            const double y = scanner_.real("a coordinate");
            const double z = scanner_.real("a coordinate");
            scanner_.end_record();
            add_node(number, x, y, z);
        }
    }

    void read_elements() override {
        const std::size_t count = scanner_.count("elements", least_element_line);
        assembly_.reserve_tets(count);
        for (std::size_t i = 0; i < count; ++i) {
            scanner_.begin_record("an element");
            scanner_.integer("the number of an element");
            const std::int64_t type = scanner_.integer("the type of an element");
            if (type == gmsh_tetrahedron) {
                read_tet(read_tags());
            } else {
                require_lower_dimension(type);
                scanner_.skip_record();
            }
        }
    }

    // The first of an element's tags; 0, which means none, when there are none.
    std::int64_t read_tags() {
        const std::size_t count = scanner_.count("tags", 2);
        if (count == 0) return 0;
        const std::int64_t first = scanner_.integer("a tag");
        for (std::size_t k = 1; k < count; ++k) scanner_.integer("a tag");
        return first;
    }

    // There is no such section in this version.
    void read_entities() override { scanner_.fail("version 2 has no $Entities", "save the mesh again with Gmsh"); }
};

}  // namespace

std::unique_ptr<GmshReader> gmsh_2_reader(TextScanner scanner) {
    return std::make_unique<Gmsh2Reader>(std::move(scanner));
}

void write_gmsh_2(RowWriter& out, const geometry::TetData& data) {
    std::vector<std::uint32_t> volume_of(data.tets.size());
    const std::vector<GmshVolume> volumes = gmsh_volumes(data);
    for (std::size_t v = 0; v < volumes.size(); ++v) {
        for (const std::uint32_t tet : volumes[v].tets) volume_of[tet] = static_cast<std::uint32_t>(v + 1);
    }

    out.text("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n");
    out.row(data.vertices.size());
    for (std::size_t i = 0; i < data.vertices.size(); ++i) out.row(i + 1, data.vertices[i]);
    out.text("$EndNodes\n$Elements\n");
    out.row(data.tets.size());
    for (std::size_t i = 0; i < data.tets.size(); ++i) {
        const auto& t = data.tets[i];
        out.row(i + 1, gmsh_tetrahedron, 2, data.label(i), volume_of[i], t[0] + 1ULL, t[1] + 1ULL, t[2] + 1ULL,
                t[3] + 1ULL);
    }
    out.text("$EndElements\n");
}

}  // namespace dsc::io::tet
