// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's XML unstructured grids. Source: the VTK file formats document, "XML file formats".
#include <charconv>
#include <utility>

#include "io/atomic_file.h"
#include "io/tet/formats.h"
#include "io/tet/vtk_cells.h"
#include "io/tet/vtk_xml.h"
#include "io/vtk_array.h"

namespace dsc::io::tet {

namespace {

constexpr const char* save_as_vtu = "save it again as .vtu (ParaView: Save Data)";

class VtuReader {
public:
    explicit VtuReader(const std::filesystem::path& path)
        : xml_(path, "UnstructuredGrid", save_as_vtu), assembly_(path.string(), 0) {}

    geometry::TetData read() {
        const pugi::xml_node piece = xml_.only_piece("has several pieces, which may double vertices",
                                                     "merge them (ParaView: filter Clean to Grid)");
        const std::size_t points = count_of(piece, "NumberOfPoints");
        const std::size_t cells = count_of(piece, "NumberOfCells");
        read_points(piece, points);
        read_cells(piece, cells);
        return assembly_.finish();
    }

private:
    std::size_t count_of(pugi::xml_node piece, const char* name) const {
        const std::string_view text = piece.attribute(name).value();
        std::uint32_t count = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
        if (error != std::errc() || end != text.data() + text.size()) {
            xml_.fail("element Piece", std::string(name) + " is " + in_quotes(text), "write a whole number");
        }
        return count;
    }

    pugi::xml_node array_named(pugi::xml_node parent, const char* name) const {
        const pugi::xml_node array = parent.find_child_by_attribute("DataArray", "Name", name);
        if (!array) xml_.fail("element " + in_quotes(parent.name()), "has no array " + in_quotes(name));
        return array;
    }

    void read_points(pugi::xml_node piece, std::size_t count) {
        const pugi::xml_node array = piece.child("Points").child("DataArray");
        if (!array) xml_.fail("element Piece", "has no points");
        if (array.attribute("NumberOfComponents").as_int() != 3) {
            xml_.fail("element Points", "points do not have 3 components");
        }
        const std::unique_ptr<NumberStream> numbers = xml_.open(array, 3 * std::uint64_t{count});
        read_vtk_points(*numbers, count, assembly_);
        numbers->require_end();
    }

    void read_cells(pugi::xml_node piece, std::size_t count) {
        const pugi::xml_node parent = piece.child("Cells");
        VtkCells cells{.types = xml_.open(array_named(parent, "types"), count),
                       .connectivity = xml_.open(array_named(parent, "connectivity"), {}),
                       .next_size = sizes_by_offsets(xml_.open(array_named(parent, "offsets"), count), false),
                       .labels = open_labels(piece.child("CellData"), count),
                       .count = count};
        read_vtk_cells(cells, assembly_);
    }

    std::unique_ptr<NumberStream> open_labels(pugi::xml_node parent, std::size_t count) const {
        pugi::xml_node best;
        std::optional<int> best_rank;
        for (const pugi::xml_node array : parent.children("DataArray")) {
            const std::optional<int> rank = label_rank(array.attribute("Name").value());
            const bool is_scalar = array.attribute("NumberOfComponents").as_int(1) == 1;
            if (!rank || !is_scalar || (best_rank && *best_rank <= *rank)) continue;
            best = array;
            best_rank = rank;
        }
        return best ? xml_.open(best, count) : nullptr;
    }

    VtkXml xml_;
    TetAssembly assembly_;
};

}  // namespace

geometry::TetData read_vtu(const std::filesystem::path& path) { return VtuReader(path).read(); }

void write_vtu(const std::filesystem::path& path, const geometry::TetData& data) {
    constexpr VtkEncoding encoding = VtkEncoding::binary;
    AtomicFile file(path);
    // Array by array, because each one is as large as the mesh.
    std::string text = vtk_document_head("UnstructuredGrid") + "<Piece NumberOfPoints=\"" +
                       std::to_string(data.vertices.size()) + "\" NumberOfCells=\"" + std::to_string(data.tets.size()) +
                       "\">\n";
    const auto hand_over = [&] { file.write(std::exchange(text, {})); };
    if (!data.labels.empty()) {
        text += "<CellData Scalars=\"" + std::string(vtk_label_name) + "\">\n";
        append_vtk_array(text, vtk_label_name, std::vector<std::int64_t>(data.labels.begin(), data.labels.end()),
                         encoding);
        text += "</CellData>\n";
    }
    text += "<Points>\n";
    {
        std::vector<double> coordinates;
        coordinates.reserve(3 * data.vertices.size());
        for (const Eigen::Vector3d& p : data.vertices) coordinates.insert(coordinates.end(), p.begin(), p.end());
        append_vtk_array(text, "Points", 3, coordinates, encoding);
    }
    text += "</Points>\n<Cells>\n";
    hand_over();
    {
        std::vector<std::int64_t> connectivity;
        connectivity.reserve(4 * data.tets.size());
        for (const auto& tet : data.tets) connectivity.insert(connectivity.end(), tet.begin(), tet.end());
        append_vtk_array(text, "connectivity", connectivity, encoding);
    }
    hand_over();
    std::vector<std::int64_t> offsets(data.tets.size());
    for (std::size_t i = 0; i < offsets.size(); ++i) offsets[i] = 4 * static_cast<std::int64_t>(i + 1);
    append_vtk_array(text, "offsets", offsets, encoding);
    append_vtk_array(text, "types", std::vector<std::uint8_t>(data.tets.size(), vtk_tetrahedron), encoding);
    text += "</Cells>\n</Piece>\n" + vtk_document_tail("UnstructuredGrid");
    hand_over();
    file.commit();
}

}  // namespace dsc::io::tet
