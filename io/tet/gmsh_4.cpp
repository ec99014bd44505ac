// SPDX-License-Identifier: GPL-3.0-or-later
// Gmsh 4.1: nodes and elements in blocks, one or more for each entity of the geometry, which belongs to physical
// groups.
#include <Eigen/Geometry>
#include <map>

#include "io/tet/gmsh.h"

namespace dsc::io::tet {

namespace {

constexpr std::size_t least_node_bytes = 8;     // a line with its number, and one with its coordinates
constexpr std::size_t least_element_bytes = 4;  // a point
constexpr std::int64_t volume_dimension = 3;

class Gmsh4Reader : public GmshReader {
public:
    using GmshReader::GmshReader;

private:
    void read_entities() override {
        constexpr std::size_t least_entity_bytes = 10;
        std::size_t skipped = 0;
        for (const char* things : {"points", "curves", "surfaces"})
            skipped += scanner_.count(things, least_entity_bytes);
        const std::size_t volumes = scanner_.count("volumes", least_entity_bytes);
        for (std::size_t i = 0; i < skipped; ++i) {
            scanner_.begin_record("an entity");
            scanner_.skip_record();
        }
        for (std::size_t i = 0; i < volumes; ++i) {
            constexpr std::size_t box_numbers = 6;
            scanner_.begin_record("an entity");
            const std::int64_t volume = scanner_.integer("the number of a volume");
            scanner_.skip_words(box_numbers, "a bound");
            if (scanner_.count("physical groups", 2) > 0) physical_[volume] = scanner_.integer("a physical group");
            scanner_.skip_record();
        }
    }

    void read_nodes() override {
        const std::size_t blocks = scanner_.count("blocks", 1);
        const std::size_t count = scanner_.count("nodes", least_node_bytes);
        scanner_.skip_words(2, "the least or greatest number of a node");
        reserve_nodes(count);
        for (std::size_t i = 0; i < blocks; ++i) read_node_block();
        require_count(count, assembly_.vertex_count(), "nodes");
    }

    void read_node_block() {
        scanner_.skip_words(3, "the entity of a block");
        const std::size_t count = scanner_.count("nodes", least_node_bytes);
        std::vector<std::int64_t> numbers(count);
        for (std::int64_t& number : numbers) number = scanner_.integer("the number of a node");
        for (const std::int64_t number : numbers) {
            scanner_.begin_record("a node");
            const double x = scanner_.real("a coordinate");
            const double y = scanner_.real("a coordinate");
            const double z = scanner_.real("a coordinate");
            scanner_.skip_record();  // coordinates on the entity may follow
            add_node(number, x, y, z);
        }
    }

    void read_elements() override {
        const std::size_t blocks = scanner_.count("blocks", 1);
        const std::size_t count = scanner_.count("elements", least_element_bytes);
        scanner_.skip_words(2, "the least or greatest number of an element");
        assembly_.reserve_tets(count);
        std::size_t found = 0;
        for (std::size_t i = 0; i < blocks; ++i) found += read_element_block();
        require_count(count, found, "elements");
    }

    std::size_t read_element_block() {
        scanner_.begin_record("a block");
        const std::int64_t dimension = scanner_.integer("the dimension of an entity");
        const std::int64_t entity = scanner_.integer("the number of an entity");
        const std::int64_t type = scanner_.integer("the type of elements");
        const std::size_t count = scanner_.count("elements", least_element_bytes);
        scanner_.end_record();
        const bool has_tets = dimension == volume_dimension && type == gmsh_tetrahedron;
        if (!has_tets && count > 0) require_lower_dimension(type);
        const auto group = physical_.find(entity);
        const std::int64_t label = group == physical_.end() ? entity : group->second;
        for (std::size_t i = 0; i < count; ++i) {
            scanner_.begin_record("an element");
            scanner_.integer("the number of an element");
            if (has_tets) {
                read_tet(label);
            } else {
                scanner_.skip_record();
            }
        }
        return count;
    }

    void require_count(std::size_t announced, std::size_t found, const char* things) {
        if (announced == found) return;
        scanner_.fail("the blocks have " + std::to_string(found) + " " + things + " where " +
                          std::to_string(announced) + " are announced",
                      "correct the counts");
    }

    std::map<std::int64_t, std::int64_t> physical_;  // group by volume
};

// Physical group 0 says of a volume that its label is 0, not its number.
void write_entities(RowWriter& out, const geometry::TetData& data, const std::vector<GmshVolume>& volumes) {
    out.text("$Entities\n");
    out.row(0, 0, 0, volumes.size());
    for (std::size_t v = 0; v < volumes.size(); ++v) {
        Eigen::AlignedBox3d box;
        for (const std::uint32_t tet : volumes[v].tets) {
            for (const std::uint32_t vertex : data.tets[tet]) box.extend(data.vertices[vertex]);
        }
        const Eigen::Vector3d low = box.min();
        const Eigen::Vector3d high = box.max();
        out.row(v + 1, low, high, 1, volumes[v].label, 0);
    }
    out.text("$EndEntities\n");
}

}  // namespace

std::unique_ptr<GmshReader> gmsh_4_reader(TextScanner scanner) {
    return std::make_unique<Gmsh4Reader>(std::move(scanner));
}

void write_gmsh_4(RowWriter& out, const geometry::TetData& data) {
    const std::vector<GmshVolume> volumes = gmsh_volumes(data);
    out.text("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n");
    write_entities(out, data, volumes);

    const std::size_t vertices = data.vertices.size();
    out.text("$Nodes\n");
    out.row(1, vertices, 1, vertices);
    out.row(volume_dimension, 1, 0, vertices);
    for (std::size_t i = 0; i < vertices; ++i) out.row(i + 1);
    for (const Eigen::Vector3d& p : data.vertices) out.row(p);
    out.text("$EndNodes\n$Elements\n");
    out.row(volumes.size(), data.tets.size(), 1, data.tets.size());
    std::size_t number = 0;
    for (std::size_t v = 0; v < volumes.size(); ++v) {
        out.row(volume_dimension, v + 1, gmsh_tetrahedron, volumes[v].tets.size());
        for (const std::uint32_t tet : volumes[v].tets) {
            const auto& t = data.tets[tet];
            out.row(++number, t[0] + 1ULL, t[1] + 1ULL, t[2] + 1ULL, t[3] + 1ULL);
        }
    }
    out.text("$EndElements\n");
}

}  // namespace dsc::io::tet
