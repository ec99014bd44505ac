// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's XML unstructured grids. Source: the VTK file formats document, "XML file formats".
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <limits>
#include <map>
#include <pugixml.hpp>
#include <utility>

#include "core/errors.h"
#include "io/atomic_file.h"
#include "io/tet/formats.h"
#include "io/tet/vtk_cells.h"
#include "io/vtk_array.h"

namespace dsc::io::tet {

namespace {

constexpr const char* damaged = "get the file again, whole";
constexpr const char* save_again = "save it again as .vtu (ParaView: Save Data)";

std::optional<NumberType> number_type(std::string_view name) {
    static const std::map<std::string_view, NumberType> types = {
        {"Int8", NumberType::int8},       {"UInt8", NumberType::uint8},   {"Int16", NumberType::int16},
        {"UInt16", NumberType::uint16},   {"Int32", NumberType::int32},   {"UInt32", NumberType::uint32},
        {"Int64", NumberType::int64},     {"UInt64", NumberType::uint64}, {"Float32", NumberType::float32},
        {"Float64", NumberType::float64},
    };
    const auto found = types.find(name);
    if (found == types.end()) return {};
    return found->second;
}

struct AppendedData {
    bool is_base64 = false;
    std::string_view bytes;    // empty when there are none
    std::size_t xml_size = 0;  // of the document that stands before
};

// Appended data need not be XML: their tag is overwritten by the end of the document, for the parser to stop there.
AppendedData cut_off_appended(std::string& text) {
    constexpr std::string_view tag = "<AppendedData";
    constexpr std::string_view end_tag = "</VTKFile>";
    static_assert(end_tag.size() <= tag.size());
    const std::size_t begin = text.find(tag);
    if (begin == text.npos) return {.xml_size = text.size()};
    const std::string_view section = std::string_view(text).substr(begin);
    const std::size_t mark = std::min(section.find('_'), section.size());
    AppendedData data{.is_base64 = section.substr(0, mark).find("base64") != section.npos,
                      .xml_size = begin + end_tag.size()};
    const std::size_t end = section.rfind("</AppendedData");
    if (mark < end && end < section.size()) data.bytes = section.substr(mark + 1, end - mark - 1);
    std::ranges::copy(end_tag, text.begin() + static_cast<std::ptrdiff_t>(begin));
    return data;
}

class VtuReader {
public:
    /// `text` is changed, and has to outlive the reader.
    VtuReader(const std::filesystem::path& path, std::string& text)
        : path_(path), appended_(cut_off_appended(text)), assembly_(path.string(), 0) {
        const pugi::xml_parse_result result =
            document_.load_buffer_inplace(text.data(), appended_.xml_size, pugi::parse_escapes, pugi::encoding_utf8);
        if (!result) reject_xml(result);
    }

    geometry::TetData read() {
        read_head();
        const pugi::xml_node piece = only_piece();
        const std::size_t points = count_of(piece, "NumberOfPoints");
        const std::size_t cells = count_of(piece, "NumberOfCells");
        read_points(piece, points);
        read_cells(piece, cells);
        return assembly_.finish();
    }

private:
    [[noreturn]] void fail(const std::string& place, const std::string& problem, const std::string& cure) const {
        throw core::InputError(path_.string(), place, problem, cure);
    }

    // Parsing has changed the text, so that the line is found in the file once more.
    [[noreturn]] void reject_xml(const pugi::xml_parse_result& result) const {
        const std::string text = read_file(path_);
        const auto offset = std::min(static_cast<std::size_t>(result.offset), text.size());
        const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(offset), '\n');
        std::string problem = result.description();
        problem.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(problem.front())));
        fail("line " + std::to_string(line), "is no XML: " + problem, damaged);
    }

    void read_head() {
        root_ = document_.child("VTKFile");
        const std::string type = root_.attribute("type").value();
        if (type != "UnstructuredGrid") fail("", "is no VTK file of type UnstructuredGrid", save_again);
        if (std::string_view(root_.attribute("byte_order").value()) == "BigEndian") order_ = std::endian::big;
        has_long_headers_ = std::string_view(root_.attribute("header_type").value()) == "UInt64";
        const std::string compressor = root_.attribute("compressor").value();
        is_compressed_ = !compressor.empty();
        if (is_compressed_ && compressor != "vtkZLibDataCompressor") {
            fail("", "is compressed by " + in_quotes(compressor), "save it with the compressor ZLib or none");
        }
    }

    pugi::xml_node only_piece() const {
        const pugi::xml_node grid = root_.child("UnstructuredGrid");
        const pugi::xml_node piece = grid.child("Piece");
        if (!piece) fail("", "has no element Piece", save_again);
        if (piece.next_sibling("Piece")) {
            fail("", "has several pieces, which may double vertices", "merge them (ParaView: filter Clean to Grid)");
        }
        return piece;
    }

    std::size_t count_of(pugi::xml_node piece, const char* name) const {
        const std::string_view text = piece.attribute(name).value();
        std::uint32_t count = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
        if (error != std::errc() || end != text.data() + text.size()) {
            fail("element Piece", std::string(name) + " is " + in_quotes(text), "write a whole number");
        }
        return count;
    }

    pugi::xml_node array_named(pugi::xml_node parent, const char* name) const {
        const pugi::xml_node array = parent.find_child_by_attribute("DataArray", "Name", name);
        if (!array) fail("element " + in_quotes(parent.name()), "has no array " + in_quotes(name), save_again);
        return array;
    }

    // The stream of an array that holds `count` numbers, or as many as there are.
    std::unique_ptr<NumberStream> open(pugi::xml_node array, std::optional<std::uint64_t> count) const {
        const std::string name = "array " + in_quotes(array.attribute("Name").value());
        const std::string_view format = array.attribute("format").value();
        std::unique_ptr<NumberStream> stream;
        if (format.empty() || format == "ascii") {
            stream = text_numbers(TextScanner(path_.string(), array.text().get(), {.within = name}));
        } else if (format == "binary" || format == "appended") {
            stream = open_binary(array, name);
            if (count && stream->most() != *count) reject_count(name, stream->most(), *count);
        } else {
            fail(name, "has the format " + in_quotes(format), save_again);
        }
        if (count && stream->most() < *count) reject_count(name, stream->most(), *count);
        return stream;
    }

    [[noreturn]] void reject_count(const std::string& name, std::uint64_t found, std::uint64_t expected) const {
        fail(name, "has " + std::to_string(found) + " numbers where " + std::to_string(expected) + " are announced",
             damaged);
    }

    std::unique_ptr<NumberStream> open_binary(pugi::xml_node array, const std::string& name) const {
        const std::optional<NumberType> type = number_type(array.attribute("type").value());
        if (!type) fail(name, "has the type " + in_quotes(array.attribute("type").value()), save_again);
        const bool is_inline = std::string_view(array.attribute("format").value()) == "binary";
        const std::string_view packed = is_inline ? array.text().get() : appended_at(array, name);
        const bool is_base64 = is_inline || appended_.is_base64;
        const std::uint64_t room = is_base64 ? packed.size() / 4 * 3 : packed.size();
        std::unique_ptr<ByteSource> bytes = is_base64 ? base64_bytes(packed) : raw_bytes(packed);

        std::uint64_t size = 0;
        if (is_compressed_) {
            std::vector<PackedBlock> blocks = read_block_sizes(*bytes, room, name);
            for (const PackedBlock& block : blocks) size += block.size;
            bytes = inflated_bytes(std::move(bytes), std::move(blocks));
        } else {
            size = read_header(*bytes, name);
            if (size > room) fail(name, "the data ends before " + std::to_string(size) + " bytes", damaged);
        }
        if (size % size_of(*type) != 0) fail(name, "the size of the data fits no numbers", damaged);
        return binary_numbers({path_.string(), name, *type, order_, size / size_of(*type)}, std::move(bytes));
    }

    std::string_view appended_at(pugi::xml_node array, const std::string& name) const {
        const std::uint64_t offset = array.attribute("offset").as_ullong(std::numeric_limits<std::uint64_t>::max());
        if (offset >= appended_.bytes.size()) fail(name, "the appended data ends before its offset", damaged);
        return appended_.bytes.substr(offset);
    }

    // One number of the header before the data.
    std::uint64_t read_header(ByteSource& bytes, const std::string& name) const {
        std::array<char, 8> image{};
        const std::span<char> used(image.data(), has_long_headers_ ? 8 : 4);
        if (!bytes.read(used)) fail(name, "the data ends within its header", damaged);
        if (order_ != std::endian::little) std::reverse(used.begin(), used.end());
        std::uint64_t value = 0;
        for (std::size_t k = 0; k < 8; ++k) value |= std::uint64_t{static_cast<unsigned char>(image[k])} << 8 * k;
        return value;
    }

    std::vector<PackedBlock> read_block_sizes(ByteSource& bytes, std::uint64_t room, const std::string& name) const {
        const std::uint64_t count = read_header(bytes, name);
        const std::uint64_t size = read_header(bytes, name);
        const std::uint64_t last_size = read_header(bytes, name);  // 0 when it is full
        if (count > room) fail(name, "the data ends within its header", damaged);
        std::vector<PackedBlock> blocks;
        for (std::uint64_t i = 0; i < count; ++i) {
            const bool is_partial = i + 1 == count && last_size != 0;
            const PackedBlock block{.size = is_partial ? last_size : size, .packed_size = read_header(bytes, name)};
            if (block.packed_size > room || !is_possible(block)) {
                fail(name, "a compressed block has a wrong size", damaged);
            }
            room -= block.packed_size;
            blocks.push_back(block);
        }
        return blocks;
    }

    void read_points(pugi::xml_node piece, std::size_t count) {
        const pugi::xml_node array = piece.child("Points").child("DataArray");
        if (!array) fail("element Piece", "has no points", save_again);
        if (array.attribute("NumberOfComponents").as_int() != 3) {
            fail("element Points", "points do not have 3 components", save_again);
        }
        const std::unique_ptr<NumberStream> numbers = open(array, 3 * std::uint64_t{count});
        read_vtk_points(*numbers, count, assembly_);
        numbers->require_end();
    }

    void read_cells(pugi::xml_node piece, std::size_t count) {
        const pugi::xml_node parent = piece.child("Cells");
        VtkCells cells{.types = open(array_named(parent, "types"), count),
                       .connectivity = open(array_named(parent, "connectivity"), {}),
                       .next_size = sizes_by_offsets(open(array_named(parent, "offsets"), count), false),
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
        return best ? open(best, count) : nullptr;
    }

    std::filesystem::path path_;
    AppendedData appended_;
    pugi::xml_document document_;
    pugi::xml_node root_;
    std::endian order_ = std::endian::little;
    bool has_long_headers_ = false;
    bool is_compressed_ = false;
    TetAssembly assembly_;
};

}  // namespace

geometry::TetData read_vtu(const std::filesystem::path& path) {
    std::string text = read_file(path);
    return VtuReader(path, text).read();
}

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
