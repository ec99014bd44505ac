// SPDX-License-Identifier: GPL-3.0-or-later
#include <zlib.h>

#include <catch2/catch.hpp>

#include "io/vtk_array.h"
#include "tests/io/tet/support.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::tests;
using Catch::Contains;

namespace {

enum class Storage { inline_base64, appended_base64, appended_raw };

// How VTK may write the same arrays.
struct Layout {
    Storage storage = Storage::inline_base64;
    bool is_compressed = false;
    bool has_long_headers = false;
    bool is_big_endian = false;
};

std::string image(std::uint64_t value, std::size_t size, bool is_big_endian) {
    std::string bytes(reinterpret_cast<const char*>(&value), size);
    if (is_big_endian) std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

class VtuText {
public:
    explicit VtuText(const Layout& layout) : layout_(layout) {}

    template <class T>
    std::string array(const char* type, const char* name, int components, const std::vector<T>& values) {
        std::string bytes;
        for (const T& value : values) {
            std::uint64_t bits = 0;
            std::memcpy(&bits, &value, sizeof value);
            bytes += image(bits, sizeof value, layout_.is_big_endian);
        }
        std::string tag = std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
                          std::to_string(components) + "\" ";
        if (layout_.storage == Storage::inline_base64) {
            return tag + "format=\"binary\">\n  " + stored(bytes) + "\n</DataArray>\n";
        }
        tag += "format=\"appended\" offset=\"" + std::to_string(appended_.size()) + "\"/>\n";
        appended_ += stored(bytes);
        return tag;
    }

    std::string document(const std::string& piece) const {
        std::string text = std::string("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" ") +
                           "byte_order=\"" + (layout_.is_big_endian ? "BigEndian" : "LittleEndian") + "\"" +
                           (layout_.has_long_headers ? " header_type=\"UInt64\"" : "") +
                           (layout_.is_compressed ? " compressor=\"vtkZLibDataCompressor\"" : "") +
                           ">\n<!-- by hand --><UnstructuredGrid>\n" + piece + "</UnstructuredGrid>\n";
        if (layout_.storage != Storage::inline_base64) {
            text += std::string("<AppendedData encoding=\"") +
                    (layout_.storage == Storage::appended_raw ? "raw" : "base64") + "\">\n  _" + appended_ +
                    "\n</AppendedData>\n";
        }
        return text + "</VTKFile>\n";
    }

private:
    std::string header(std::initializer_list<std::uint64_t> values) const {
        std::string bytes;
        for (const std::uint64_t value : values) {
            bytes += image(value, layout_.has_long_headers ? 8 : 4, layout_.is_big_endian);
        }
        return bytes;
    }

    // Header and data; two blocks when compressed, the second one shorter.
    std::string stored(const std::string& bytes) const {
        const bool is_raw = layout_.storage == Storage::appended_raw;
        if (!layout_.is_compressed) {
            const std::string all = header({bytes.size()}) + bytes;
            return is_raw ? all : io::base64(all);
        }
        const std::size_t size = bytes.size() / 2 + 1;
        const std::string first = packed(bytes.substr(0, size));
        const std::string second = packed(bytes.substr(size));
        const std::string head = header({2, size, bytes.size() - size, first.size(), second.size()});
        return is_raw ? head + first + second : io::base64(head) + io::base64(first + second);
    }

    static std::string packed(const std::string& bytes) {
        std::string result(::compressBound(bytes.size()), '\0');
        uLongf size = result.size();
        ::compress(reinterpret_cast<Bytef*>(result.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                   bytes.size());
        return result.substr(0, size);
    }

    Layout layout_;
    std::string appended_;
};

// The mesh with a triangle before its tetrahedra.
std::string vtu_text(const geometry::TetData& data, const Layout& layout) {
    VtuText vtu(layout);
    std::vector<double> points;
    for (const Eigen::Vector3d& p : data.vertices) points.insert(points.end(), p.begin(), p.end());
    std::vector<std::int32_t> connectivity = {0, 1, 2};
    std::vector<std::int64_t> offsets = {3};
    std::vector<std::uint8_t> types = {5};
    std::vector<std::int16_t> labels = {0};
    for (std::size_t i = 0; i < data.tets.size(); ++i) {
        for (const std::uint32_t v : data.tets[i]) connectivity.push_back(static_cast<std::int32_t>(v));
        offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
        types.push_back(10);
        labels.push_back(static_cast<std::int16_t>(data.label(i)));
    }
    std::string piece = "<Piece NumberOfPoints=\"" + std::to_string(data.vertices.size()) + "\" NumberOfCells=\"" +
                        std::to_string(types.size()) + "\">\n<CellData>\n" +
                        vtu.array<float>("Float32", "quality", 1, std::vector<float>(types.size(), 0.5F)) +
                        vtu.array("Int16", "medit:ref", 1, labels) + "</CellData>\n<Points>\n" +
                        vtu.array("Float64", "Points", 3, points) + "</Points>\n<Cells>\n" +
                        vtu.array("Int32", "connectivity", 1, connectivity) +
                        vtu.array("Int64", "offsets", 1, offsets) + vtu.array("UInt8", "types", 1, types) +
                        "</Cells>\n</Piece>\n";
    return vtu.document(piece);
}

const std::string ascii =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\">\n<UnstructuredGrid>\n"
    "<Piece NumberOfPoints=\"5\" NumberOfCells=\"2\">\n<Points>\n"
    "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n"
    "0 0 0 1 0 0\n0 1 0 0 0 1 1 1 1\n</DataArray>\n</Points>\n<Cells>\n"
    "<DataArray type=\"Int64\" Name=\"connectivity\">0 1 2 3\n1 2 3 4</DataArray>\n"
    "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">4 8</DataArray>\n"
    "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">10 10</DataArray>\n</Cells>\n<CellData>\n"
    "<DataArray type=\"Int32\" Name=\"gmsh:physical\" format=\"ascii\">1 2</DataArray>\n"
    "<DataArray type=\"Float32\" Name=\"region\" format=\"ascii\">10.0 20</DataArray>\n</CellData>\n"
    "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";

std::string vtu_error(const std::string& what, const std::string& replacement) {
    return error_of("m.vtu", with(ascii, what, replacement));
}

}  // namespace

TEST_CASE("a VTU file is read however its arrays are stored") {
    core::Random random(seed(41));
    const geometry::TetData data = random_mesh(random, 3);
    for (const Storage storage : {Storage::inline_base64, Storage::appended_base64, Storage::appended_raw}) {
        for (int bits = 0; bits < 8; ++bits) {
            const Layout layout{storage, (bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0};
            CAPTURE(static_cast<int>(storage), bits);
            const std::string text = vtu_text(data, layout);
            const geometry::TetData read = read_text("m.vtu", text);
            CHECK(same_coordinates(read, data));
            CHECK(read.tets == data.tets);
            CHECK(read.labels == data.labels);
            for (const double part : {0.2, 0.5, 0.9, 0.97}) {
                const auto size = static_cast<std::size_t>(part * static_cast<double>(text.size()));
                CHECK_THAT(error_of("m.vtu", text.substr(0, size)), Contains("m.vtu: "));
            }
        }
    }
}

TEST_CASE("a VTU file as text, and which array has the labels") {
    const geometry::TetData data = read_text("m.vtu", ascii);
    CHECK(data.vertices.size() == 5);
    CHECK(data.tets == std::vector<std::array<std::uint32_t, 4>>{{0, 1, 2, 3}, {1, 2, 3, 4}});
    CHECK(data.labels == std::vector<int>{10, 20});
    CHECK(read_text("m.vtu", with(ascii, "\"region\"", "\"region\" NumberOfComponents=\"2\"")).labels ==
          std::vector<int>{1, 2});
    CHECK(read_text("m.vtu", with(with(ascii, "\"region\"", "\"x\""), "gmsh:physical", "y")).labels.empty());
}

TEST_CASE("a wrong VTU file is refused with its element") {
    CHECK_THAT(vtu_error("1 1 1\n", "1 1 nan\n"),
               Contains("m.vtu: line 3 of array \"\": \"nan\" where a number is expected"));
    CHECK_THAT(vtu_error("1 1 1\n", "1 1\n"), Contains("array \"\": ends where a number is expected"));
    CHECK_THAT(vtu_error("1 1 1\n", "1 1 1 1\n"), Contains("there are more numbers than announced"));
    CHECK_THAT(vtu_error("Points=\"5\"", "Points=\"4000000000\""), Contains("numbers where 12000000000 are announced"));
    CHECK_THAT(vtu_error("Points=\"5\"", "Points=\"-5\""), Contains("element Piece: NumberOfPoints is \"-5\""));
    CHECK_THAT(vtu_error("Cells=\"2\"", "Cells=\"3\""),
               Contains("array \"offsets\": has 2 numbers where 3 are announced"));
    CHECK_THAT(vtu_error("Cells=\"2\"", "Cells=\"1\""), Contains("there are more numbers than announced"));
    CHECK_THAT(vtu_error("1 2 3 4<", "1 2 3 5<"),
               Contains("line 2 of array \"connectivity\": vertex 5 does not exist"));
    CHECK_THAT(vtu_error("1 2 3 4<", "1 2 3 -1<"),
               Contains("line 2 of array \"connectivity\": vertex -1 does not exist"));
    CHECK_THAT(vtu_error("1 2 3 4<", "1 2 3 2<"), Contains("the tetrahedron has the same vertex twice"));
    CHECK_THAT(vtu_error("1 2 3 4<", "1 2 3 0.5<"), Contains("a vertex is not a whole number"));
    CHECK_THAT(vtu_error("4 8<", "4 3<"), Contains("array \"offsets\": an offset is less than the one before"));
    CHECK_THAT(vtu_error("4 8<", "4 9<"), Contains("a tetrahedron has 5 vertices"));
    CHECK_THAT(vtu_error("10 10<", "10 12<"),
               Contains("array \"types\": the cell is a hexahedron (type 12); make linear"));
    CHECK_THAT(vtu_error("10 10<", "10 24<"), Contains("a tetrahedron of higher order (type 24)"));
    CHECK_THAT(vtu_error("10.0 20<", "10.5 20<"), Contains("array \"region\": a label is not a whole number"));
    CHECK_THAT(vtu_error("10.0 20<", "10 20 30<"), Contains("array \"region\": there are more numbers than announced"));
    CHECK_THAT(vtu_error("\"types\"", "\"kinds\""), Contains("element \"Cells\": has no array \"types\""));
    CHECK_THAT(vtu_error("Components=\"3\"", "Components=\"2\""), Contains("points do not have 3 components"));
    CHECK_THAT(error_of("m.vtu", with(with(ascii, "10 10<", "10 5<"), "4 8<", "4 7<")),
               Contains("array \"connectivity\": there are more numbers"));
    CHECK_THAT(vtu_error("</Piece>\n", "</Piece>\n<Piece/>"), Contains("several pieces"));
    CHECK_THAT(vtu_error("version=\"0.1\"", "compressor=\"vtkLZ4DataCompressor\""), Contains("vtkLZ4DataCompressor"));
    CHECK_THAT(vtu_error("=\"UnstructuredGrid\"", "=\"PolyData\""),
               Contains("is no VTK file of type UnstructuredGrid"));
    CHECK_THAT(vtu_error("</Cells>", "</Cell>"), Contains("m.vtu: line 16: is no XML"));
    CHECK_THAT(error_of("m.vtu", ""), Contains("m.vtu: line 1: is no XML"));
    CHECK_THAT(vtu_error("format=\"ascii\">4 8", "format=\"appended\" offset=\"0\">"),
               Contains("ends before its offset"));
    CHECK_THAT(vtu_error("format=\"ascii\">4 8", "format=\"binary\">AAAA"),
               Contains("the data ends within its header"));
    CHECK_THAT(vtu_error("format=\"ascii\">4 8", "format=\"binary\">" + io::base64(std::string("\x10\0\0\0\1", 5))),
               Contains("the data ends before 16 bytes"));
}
