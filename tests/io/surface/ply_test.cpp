// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <functional>

#include "tests/io/surface/support.h"

using namespace dsc;
using namespace dsc::tests;
using Catch::Contains;

namespace {

const std::string head =
    "ply\nformat ascii 1.0\ncomment made by hand\nobj_info none\nelement vertex 4\nproperty float x\n"
    "property float y\nproperty float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n";
const std::string ply_text = head + "0 0 0\n1 0 0\n1 1 0\n0 1 0.5\n4 0 1 2 3\n3 2 1 0\n";
const Triangles ply_triangles{{0, 1, 2}, {0, 2, 3}, {2, 1, 0}};

std::string ply_error(const std::string& what, const std::string& replacement) {
    return surface_error("s.ply", replaced(ply_text, what, replacement));
}

// Properties of all types, lists, and an element that nobody knows, in binary.
std::string binary(bool is_big_endian, const std::string& index_type, const std::function<std::string(int)>& index) {
    const auto bytes = [&](auto number) { return bytes_of(number, is_big_endian); };
    std::string file = std::string("ply\r\nformat binary_") + (is_big_endian ? "big" : "little") +
                       "_endian 1.0\r\nelement camera 1\nproperty list ushort double view\nelement vertex 4\n"
                       "property uchar red\nproperty double x\nproperty list int short tags\nproperty float y\n"
                       "property int z\nelement face 2\nproperty char label\nproperty list uint " +
                       index_type + " vertex_index\nproperty list uchar float texcoord\nend_header\n";
    file += bytes(std::uint16_t{2}) + bytes(1.0) + bytes(2.0);
    const double places[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 7}};
    for (const auto& [x, y, z] : places) {
        file += bytes(std::uint8_t{255}) + bytes(x) + bytes(std::int32_t{1}) + bytes(std::int16_t{-1}) +
                bytes(static_cast<float>(y)) + bytes(static_cast<std::int32_t>(z));
    }
    const std::vector<std::vector<int>> polygons{{0, 1, 2, 3}, {2, 1, 0}};
    for (const std::vector<int>& polygon : polygons) {
        file += bytes(static_cast<std::int8_t>(-static_cast<int>(polygon.size())));
        file += bytes(static_cast<std::uint32_t>(polygon.size()));
        for (const int vertex : polygon) file += index(vertex);
        file += bytes(std::uint8_t{1}) + bytes(0.5F);
    }
    return file;
}

template <class Index>
void check_binary(const std::string& type) {
    for (const bool is_big_endian : {false, true}) {
        CAPTURE(type, is_big_endian);
        const auto index = [&](int vertex) { return bytes_of(static_cast<Index>(vertex), is_big_endian); };
        const geometry::SurfaceData data = surface_in("s.ply", binary(is_big_endian, type, index));
        CHECK(data.vertices.size() == 4);
        CHECK(data.vertices[3] == Eigen::Vector3d(0, 1, 7));
        CHECK(data.triangles == ply_triangles);
        CHECK(data.labels == std::vector<int>{-4, -4, -3});
    }
}

}  // namespace

TEST_CASE("an ASCII PLY file is read whatever else is in it") {
    const geometry::SurfaceData data = surface_in("s.ply", ply_text);
    CHECK(data.vertices.size() == 4);
    CHECK(data.vertices[3] == Eigen::Vector3d(0, 1, 0.5));
    CHECK(data.triangles == ply_triangles);
    CHECK(data.labels.empty());
    std::string more = replaced(ply_text, "property float z\n", "property double z\nproperty list uchar int ring\n");
    more = replaced(more, "0 0 0\n1 0 0\n1 1 0\n0 1 0.5\n", "0 0 0 0\n1 0 0 2 7 8\n1 1 0 1 nan\n0 1 0.5 0\n\n");
    more = replaced(more, "element face 2\n", "element edge 1\nproperty int a\nproperty int b\nelement face 2\n");
    more = replaced(more, "4 0 1 2 3\n", "0 1\n4 0 1 2 3\n");
    for (const std::string& other :
         {more, replaced(ply_text, "vertex_indices", "vertex_index"), replaced(ply_text, "uchar int", "int32 uint16"),
          ply_text + "\n", replaced(ply_text, "end_header\n", "end_header\r\n")}) {
        INFO(other);
        const geometry::SurfaceData same = surface_in("s.ply", other);
        CHECK(same_bits(same.vertices, data.vertices));
        CHECK(same.triangles == ply_triangles);
    }
}

TEST_CASE("a binary PLY file is read in both byte orders, with indices of any type") {
    check_binary<std::int8_t>("char");
    check_binary<std::uint8_t>("uint8");
    check_binary<std::int16_t>("int16");
    check_binary<std::uint16_t>("ushort");
    check_binary<std::int32_t>("int");
    check_binary<std::uint32_t>("uint32");
    check_binary<std::int64_t>("int64");
    check_binary<std::uint64_t>("uint64");
    check_binary<float>("float");
}

TEST_CASE("a wrong PLY file is refused with its line or row") {
    CHECK_THAT(surface_error("s.ply", ""), Contains("s.ply: line 1: ends where ply is expected"));
    CHECK_THAT(ply_error("ply", "play"), Contains("line 1: is no PLY file"));
    CHECK_THAT(ply_error("ascii", "utf8"), Contains("the format is \"utf8\"; use ascii, binary_little_endian or"));
    CHECK_THAT(ply_error("format ascii 1.0\n", ""), Contains("the format is \"\""));
    CHECK_THAT(ply_error("comment", "remark"), Contains("line 3: \"remark\" where a line of the head is expected"));
    CHECK_THAT(ply_error("end_header\n", ""), Contains("line 11: \"0\" where a line of the head is expected"));
    CHECK_THAT(ply_error("property float y", "property real y"),
               Contains("line 7: \"real\" where the type of a property"));
    CHECK_THAT(ply_error("list uchar", "list float"), Contains("line 10: a list is counted by real numbers"));
    CHECK_THAT(ply_error("element vertex 4", "property int a"),
               Contains("line 5: there is a property before all elements"));
    CHECK_THAT(ply_error("property float y", "property float w"),
               Contains("the vertices lack one of the properties x, y"));
    CHECK_THAT(ply_error("vertex_indices", "corners"), Contains("the faces have no list vertex_indices"));
    CHECK_THAT(ply_error("element face 2", "element facet 2"), Contains("contains no element face"));
    CHECK_THAT(ply_error("element vertex", "element point"), Contains("contains no element vertex"));
    CHECK_THAT(ply_error("element face", "element vertex"), Contains("line 9: there is a second element \"vertex\""));
    CHECK_THAT(ply_error("element vertex 4", "element vertex -4"), Contains("line 5: the number of rows is negative"));
    CHECK_THAT(ply_error("element vertex 4", "element vertex 5"),
               Contains("line 16: there are more numbers than expected"));
    CHECK_THAT(ply_error("element vertex 4", "element vertex 3"),
               Contains("line 15: there are more numbers than expected"));
    CHECK_THAT(ply_error("element vertex 4", "element vertex 99999999"),
               Contains("99999999 rows of \"vertex\" are announced"));
    CHECK_THAT(ply_error("element face 2", "element face 1"), Contains("line 17: there are more rows than announced"));
    CHECK_THAT(ply_error("element face 2", "element face 3"), Contains("line 18: ends where face is expected"));
    CHECK_THAT(ply_error("element face 2", "element void 1\nelement face 2"),
               Contains("the element \"void\" has no properties"));
    CHECK_THAT(ply_error("1 1 0\n", "1 inf 0\n"), Contains("line 14: \"inf\" where a number is expected"));
    CHECK_THAT(ply_error("1 1 0\n", "1 1\n"), Contains("line 14: there are fewer numbers than expected"));
    CHECK_THAT(ply_error("3 2 1 0", "3 2 1 4"), Contains("line 17: vertex 4 does not exist; use 0 to 3"));
    CHECK_THAT(ply_error("3 2 1 0", "3 2 1 2"), Contains("line 17: a face has the same vertex twice"));
    CHECK_THAT(ply_error("3 2 1 0", "2 2 1"), Contains("line 17: a face has fewer than 3 vertices"));
    CHECK_THAT(ply_error("3 2 1 0", "-3 2 1 0"), Contains("line 17: the length of a list is negative"));
    CHECK_THAT(ply_error("3 2 1 0", "3 2 1 0.5"), Contains("line 17: \"0.5\" where a whole number is expected"));
}

TEST_CASE("a wrong binary PLY file is refused with its row") {
    const auto index = [](int vertex) { return bytes_of(vertex); };
    const std::string whole = binary(false, "int", index);
    CHECK(surface_error("s.ply", whole).empty());
    CHECK_THAT(surface_error("s.ply", whole.substr(0, whole.size() - 1)),
               Contains("s.ply: row 1 of \"face\": ends within this row; the file is truncated or a count is wrong"));
    CHECK_THAT(surface_error("s.ply", whole + "\n"),
               Contains("row 1 of \"face\": there are more bytes behind this row"));
    CHECK_THAT(surface_error("s.ply", replaced(whole, "element vertex 4", "element vertex 4000000000")),
               Contains("4000000000 rows of \"vertex\" are announced, more than the file has room for"));
    CHECK_THAT(surface_error("s.ply", replaced(whole, bytes_of(1.0F), bytes_of(std::nanf("")))),
               Contains("row 2 of \"vertex\": y is not a finite number"));
    CHECK_THAT(surface_error("s.ply", binary(false, "int", [](int v) { return bytes_of(v == 3 ? 77 : v); })),
               Contains("row 0 of \"face\": vertex 77 does not exist; use 0 to 3"));
    CHECK_THAT(
        surface_error("s.ply", binary(false, "float", [](int v) { return bytes_of(static_cast<float>(v) / 2); })),
        Contains("row 0 of \"face\": the number of a vertex is not a whole number"));
    const std::string list = bytes_of(std::uint32_t{4}) + bytes_of(0) + bytes_of(1);
    CHECK_THAT(surface_error("s.ply", replaced(whole, list, bytes_of(~0U) + bytes_of(0) + bytes_of(1))),
               Contains("row 0 of \"face\": ends within this row"));
}

TEST_CASE("labels of faces have to be whole") {
    const std::string labelled = replaced(ply_text, "property list uchar", "property float label\nproperty list uchar");
    const auto with_labels = [&](const std::string& a) {
        return replaced(replaced(labelled, "4 0 1 2 3", a + " 4 0 1 2 3"), "3 2 1 0", "0 3 2 1 0");
    };
    CHECK(surface_in("s.ply", with_labels("6")).labels == std::vector<int>{6, 6, 0});
    CHECK(surface_in("s.ply", with_labels("0")).labels.empty());
    CHECK_THAT(surface_error("s.ply", with_labels("0.5")), Contains("line 17: the label is not a whole number"));
    CHECK_THAT(surface_error("s.ply", with_labels("1e300")), Contains("line 17: the label is not a whole number"));
    CHECK_THAT(surface_error("s.ply", with_labels("5000000000")), Contains("the label 5000000000 is too large"));
}
