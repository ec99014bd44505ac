// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's legacy format. Source: the VTK file formats document, "Simple legacy formats"; version 5.1: "VTK legacy file
// format 5.1" in VTK's discourse, as vtkUnstructuredGridReader.cxx has it.
#include <algorithm>
#include <cctype>
#include <map>
#include <utility>

#include "io/tet/formats.h"
#include "io/tet/row_writer.h"
#include "io/tet/vtk_cells.h"
#include "io/text_scanner.h"

namespace dsc::io::tet {

namespace {

constexpr const char* save_again = "save it again as .vtu or .vtk (ParaView: Save Data)";

std::string upper(std::string_view word) {
    std::string text(word);
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

std::optional<NumberType> legacy_number_type(std::string_view name) {
    static const std::map<std::string, NumberType, std::less<>> types = {
        {"CHAR", NumberType::int8},
        {"SIGNED_CHAR", NumberType::int8},
        {"VTKTYPEINT8", NumberType::int8},
        {"UNSIGNED_CHAR", NumberType::uint8},
        {"VTKTYPEUINT8", NumberType::uint8},
        {"SHORT", NumberType::int16},
        {"VTKTYPEINT16", NumberType::int16},
        {"UNSIGNED_SHORT", NumberType::uint16},
        {"VTKTYPEUINT16", NumberType::uint16},
        {"INT", NumberType::int32},
        {"VTKIDTYPE", NumberType::int32},  // as VTK writes it, whatever it is in memory
        {"VTKTYPEINT32", NumberType::int32},
        {"UNSIGNED_INT", NumberType::uint32},
        {"VTKTYPEUINT32", NumberType::uint32},
        {"LONG", NumberType::int64},
        {"VTKTYPEINT64", NumberType::int64},
        {"UNSIGNED_LONG", NumberType::uint64},
        {"VTKTYPEUINT64", NumberType::uint64},
        {"FLOAT", NumberType::float32},
        {"DOUBLE", NumberType::float64},
    };
    const auto found = types.find(upper(name));
    if (found == types.end()) return {};
    return found->second;
}

// Numbers of the file that are found but not read yet.
struct Block {
    std::string name;
    NumberType type = NumberType::float64;
    std::size_t count = 0;
    TextScanner text;         // at the first one
    std::string_view binary;  // empty when the file is text
};

class LegacyReader {
public:
    explicit LegacyReader(TextScanner scanner) : scanner_(std::move(scanner)), assembly_(scanner_.source(), 0) {}

    geometry::TetData read() {
        read_head();
        while (!scanner_.at_end()) read_section(upper(scanner_.word("a keyword")));
        if (!sizes_and_vertices_ && !vertices_) scanner_.fail("there are no CELLS", "give a volume mesh");
        if (!types_) scanner_.fail("there are no CELL_TYPES", save_again);
        read_cells();
        return assembly_.finish();
    }

private:
    void read_head() {
        constexpr std::string_view signature = "# vtk DataFile Version ";
        if (!scanner_.rest().starts_with(signature)) {
            scanner_.fail("is no legacy VTK file: it does not begin with \"# vtk DataFile Version\"", save_again);
        }
        scanner_.bytes(signature.size());
        has_offsets_ = scanner_.real("the version") >= 5;
        scanner_.skip_line();
        scanner_.skip_line();  // the title
        const std::string encoding = upper(scanner_.word("ASCII or BINARY"));
        if (encoding != "ASCII" && encoding != "BINARY") {
            scanner_.fail(in_quotes(encoding) + " where ASCII or BINARY is expected", save_again);
        }
        is_binary_ = encoding == "BINARY";
        if (upper(scanner_.word("DATASET")) != "DATASET") scanner_.fail("DATASET is missing", save_again);
        if (const std::string_view kind = scanner_.word("a kind of data set"); upper(kind) != "UNSTRUCTURED_GRID") {
            scanner_.fail("the data set is " + in_quotes(kind), "give an UNSTRUCTURED_GRID of tetrahedra");
        }
    }

    void read_section(const std::string& keyword) {
        if (keyword == "POINTS") {
            read_points();
        } else if (keyword == "CELLS") {
            find_cells();
        } else if (keyword == "CELL_TYPES") {
            require_cell_count(count("cell types"));
            types_ = find_block("CELL_TYPES", "int", cell_count_);
        } else if (keyword == "POINT_DATA") {
            is_cell_data_ = false;
            tuples_ = count("points");
        } else if (keyword == "CELL_DATA") {
            is_cell_data_ = true;
            tuples_ = count("cells");
            require_cell_count(tuples_);
        } else if (keyword == "METADATA") {
            skip_metadata();
        } else {
            read_attribute(keyword);
        }
    }

    std::size_t count(const char* things) { return scanner_.count(things, 1); }

    void require_cell_count(std::size_t found) const {
        if (found == cell_count_) return;
        scanner_.fail(std::to_string(found) + " values for " + std::to_string(cell_count_) + " cells",
                      "correct the counts");
    }

    // The `count` numbers that begin on the next line.
    Block find_block(const std::string& name, std::string_view type_name, std::size_t count) {
        const std::optional<NumberType> type = legacy_number_type(type_name);
        if (!type) scanner_.fail(name + " has the type " + in_quotes(type_name), "leave that array out");
        if (is_binary_) scanner_.skip_line();
        Block block{.name = name, .type = *type, .count = count, .text = scanner_, .binary = {}};
        const std::size_t least_size = is_binary_ ? size_of(*type) : 2;
        const std::size_t room = scanner_.rest().size() / least_size + (is_binary_ ? 0 : 1);
        if (count > room) {
            scanner_.fail(
                name + " is announced to have " + std::to_string(count) + " numbers, more than the file has room for",
                "the file is truncated or a count is wrong");
        }
        if (is_binary_) {
            block.binary = scanner_.bytes(count * size_of(*type));
        } else {
            scanner_.skip_words(count, "a number");
            block.text.end_at(scanner_);
        }
        return block;
    }

    // `tuples_` times `components` numbers, whose type is the next word.
    Block find_array(const std::string& name, std::size_t components) {
        const std::string type(scanner_.word("the type of numbers"));
        return find_block("array " + in_quotes(name), type, tuples_ * components);
    }

    std::unique_ptr<NumberStream> open(const Block& block) const {
        if (!is_binary_) return text_numbers(block.text);
        return binary_numbers({scanner_.source(), block.name, block.type, std::endian::big, block.count},
                              raw_bytes(block.binary));
    }

    void read_points() {
        if (assembly_.vertex_count() > 0) scanner_.fail("there is a second section POINTS", "join the two");
        const std::size_t points = count("points");
        const std::string type(scanner_.word("the type of numbers"));
        const Block block = find_block("POINTS", type, 3 * points);
        read_vtk_points(*open(block), points, assembly_);
    }

    void find_cells() {
        if (cell_count_ > 0) scanner_.fail("there is a second section CELLS", "join the two");
        if (!has_offsets_) {
            cell_count_ = count("cells");
            sizes_and_vertices_ = find_block("CELLS", "int", count("numbers of cells"));
            return;
        }
        const std::size_t offsets = count("offsets");
        const std::size_t vertices = count("vertices of cells");
        cell_count_ = offsets == 0 ? 0 : offsets - 1;
        offsets_ = find_named_block("OFFSETS", offsets);
        vertices_ = find_named_block("CONNECTIVITY", vertices);
    }

    Block find_named_block(const char* name, std::size_t count) {
        if (const std::string_view word = scanner_.word(name); upper(word) != name) {
            scanner_.fail(in_quotes(word) + " where " + name + " is expected", save_again);
        }
        const std::string type(scanner_.word("the type of numbers"));
        return find_block(name, type, count);
    }

    void read_attribute(const std::string& keyword) {
        static const std::map<std::string, std::size_t, std::less<>> components = {
            {"VECTORS", 3},    {"NORMALS", 3},      {"TENSORS", 9},   {"TENSORS6", 6},
            {"GLOBAL_IDS", 1}, {"PEDIGREE_IDS", 1}, {"EDGE_FLAGS", 1}};
        if (keyword == "FIELD") {
            read_field();
            return;
        }
        const auto found = components.find(keyword);
        const bool is_known = found != components.end() || keyword == "SCALARS" || keyword == "COLOR_SCALARS" ||
                              keyword == "LOOKUP_TABLE" || keyword == "TEXTURE_COORDINATES";
        if (!is_known) {
            scanner_.fail(in_quotes(keyword) + " where a keyword is expected",
                          "correct the count of the section before");
        }
        const std::string name(scanner_.word("the name of an array"));
        if (keyword == "SCALARS") {
            read_scalars(name);
        } else if (keyword == "COLOR_SCALARS") {
            find_block(name, colour_type(), tuples_ * count("components"));
        } else if (keyword == "LOOKUP_TABLE") {
            find_block(name, colour_type(), 4 * count("colours"));
        } else if (keyword == "TEXTURE_COORDINATES") {
            find_array(name, count("components"));
        } else {
            find_array(name, found->second);
        }
    }

    const char* colour_type() const { return is_binary_ ? "unsigned_char" : "float"; }

    void read_scalars(const std::string& name) {
        const std::string type(scanner_.word("the type of numbers"));
        const std::size_t components = scanner_.at_line_end() ? 1 : count("components");
        TextScanner ahead = scanner_;
        if (upper(ahead.word("LOOKUP_TABLE")) == "LOOKUP_TABLE") {
            ahead.word("the name of a table");
            scanner_ = ahead;
        }
        keep_labels(name, components, find_block("array " + in_quotes(name), type, tuples_ * components));
    }

    void read_field() {
        scanner_.word("the name of the field");
        const std::size_t arrays = count("arrays");
        for (std::size_t i = 0; i < arrays; ++i) {
            std::string name(scanner_.word("the name of an array"));
            while (name == "METADATA") {
                skip_metadata();
                name = scanner_.word("the name of an array");
            }
            const std::size_t components = count("components");
            const std::size_t tuples = count("tuples");
            const std::string type(scanner_.word("the type of numbers"));
            Block block = find_block("array " + in_quotes(name), type, tuples * components);
            if (tuples == tuples_) keep_labels(name, components, std::move(block));
        }
    }

    // Up to an empty line.
    void skip_metadata() {
        do {
            scanner_.skip_line();
        } while (!scanner_.rest().empty() && !scanner_.at_line_end());
    }

    void keep_labels(const std::string& name, std::size_t components, Block block) {
        const std::optional<int> rank = label_rank(name);
        if (!is_cell_data_ || components != 1 || !rank || (labels_rank_ && *labels_rank_ <= *rank)) return;
        labels_ = std::move(block);
        labels_rank_ = rank;
    }

    void read_cells() {
        VtkCells cells{.types = open(*types_),
                       .connectivity = open(has_offsets_ ? *vertices_ : *sizes_and_vertices_),
                       .next_size = {},
                       .labels = labels_ ? open(*labels_) : nullptr,
                       .count = cell_count_};
        if (has_offsets_) {
            cells.next_size = sizes_by_offsets(open(*offsets_), true);
        } else {
            cells.next_size = [&] { return cells.connectivity->whole("the size of a cell"); };
        }
        read_vtk_cells(cells, assembly_);
    }

    TextScanner scanner_;
    TetAssembly assembly_;
    bool is_binary_ = false;
    bool has_offsets_ = false;
    std::size_t cell_count_ = 0;
    std::optional<Block> sizes_and_vertices_;  // before version 5
    std::optional<Block> offsets_;             // since
    std::optional<Block> vertices_;
    std::optional<Block> types_;
    std::size_t tuples_ = 0;  // of the arrays that follow
    bool is_cell_data_ = false;
    std::optional<Block> labels_;
    std::optional<int> labels_rank_;
};

}  // namespace

geometry::TetData read_legacy_vtk(const std::filesystem::path& path) {
    const std::string text = read_file(path);
    return LegacyReader(TextScanner(path.string(), text)).read();
}

void write_legacy_vtk(const std::filesystem::path& path, const geometry::TetData& data) {
    RowWriter out(path);
    out.text("# vtk DataFile Version 3.0\ntetrahedral mesh\nASCII\nDATASET UNSTRUCTURED_GRID\n");
    out.text("POINTS " + std::to_string(data.vertices.size()) + " double\n");
    for (const Eigen::Vector3d& p : data.vertices) out.row(p);
    const std::string count = std::to_string(data.tets.size());
    out.text("CELLS " + count + " " + std::to_string(5 * data.tets.size()) + "\n");
    for (const auto& t : data.tets) out.row(4, t[0], t[1], t[2], t[3]);
    out.text("CELL_TYPES " + count + "\n");
    for (std::size_t i = 0; i < data.tets.size(); ++i) out.row(vtk_tetrahedron);
    if (!data.labels.empty()) {
        out.text("CELL_DATA " + count + "\nSCALARS " + vtk_label_name + " int 1\nLOOKUP_TABLE default\n");
        for (const int label : data.labels) out.row(label);
    }
    out.file().commit();
}

}  // namespace dsc::io::tet
