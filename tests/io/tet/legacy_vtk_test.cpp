// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "tests/io/tet/support.h"

using namespace dsc;
using namespace dsc::tests;
using Catch::Contains;

namespace {

using Tets = std::vector<std::array<std::uint32_t, 4>>;

// `numbers` as text, or as VTK's binary numbers of that type.
template <class T>
std::string numbers(bool is_binary, const std::vector<T>& values) {
    std::string text;
    for (const T& value : values) {
        if (is_binary) {
            std::string image(reinterpret_cast<const char*>(&value), sizeof value);
            text.append(image.rbegin(), image.rend());
        } else {
            text += std::to_string(value) + (text.size() % 3 == 0 ? "\n" : " ");
        }
    }
    return text + "\n";
}

// Two tetrahedra and a triangle, with all that VTK may write around.
std::string vtk_text(const std::string& version, bool is_binary) {
    const bool has_offsets = version >= "5";
    const std::string metadata = "METADATA\nINFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 0 1\n\n";
    std::string text =
        "# vtk DataFile Version " + version + "\nCELLS 1 in the title\n" + (is_binary ? "BINARY" : "ASCII") +
        "\nDATASET UNSTRUCTURED_GRID\nFIELD FieldData 1\nTIME 1 1 double\n" + numbers<double>(is_binary, {0.5}) +
        "POINTS 5 float\n" + numbers<float>(is_binary, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}) + metadata;
    if (has_offsets) {
        text += "CELLS 4 11\nOFFSETS vtktypeint64\n" + numbers<std::int64_t>(is_binary, {0, 4, 7, 11}) +
                "CONNECTIVITY vtktypeint64\n" + numbers<std::int64_t>(is_binary, {0, 1, 2, 3, 0, 1, 2, 1, 2, 3, 4});
    } else {
        text += "CELLS 3 14\n" + numbers<std::int32_t>(is_binary, {4, 0, 1, 2, 3, 3, 0, 1, 2, 4, 1, 2, 3, 4});
    }
    text += "CELL_TYPES 3\n" + numbers<std::int32_t>(is_binary, {10, 5, 10});
    text += "POINT_DATA 5\nSCALARS label double 1\nLOOKUP_TABLE colours\n" +
            numbers<double>(is_binary, {1, 2, 3, 4, 5}) + "LOOKUP_TABLE colours 1\n" +
            (is_binary ? numbers<std::uint8_t>(true, {1, 2, 3, 4}) : numbers<float>(false, {1, 0, 0, 1})) +
            "NORMALS n float\n" + numbers<float>(is_binary, std::vector<float>(15, 1));
    text += "CELL_DATA 3\nVECTORS v float\n" + numbers<float>(is_binary, std::vector<float>(9, 2)) +
            "FIELD FieldData 2\nquality 2 3 double\n" + numbers<double>(is_binary, std::vector<double>(6, 3)) +
            metadata + "region 1 3 long\n" + numbers<std::int64_t>(is_binary, {10, 0, 20}) +
            "SCALARS gmsh:physical int\n" + "LOOKUP_TABLE default\n" + numbers<std::int32_t>(is_binary, {1, 2, 3});
    return text;
}

const std::string simple =
    "# vtk DataFile Version 2.0\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 double\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
    "1 1 1\nCELLS 2 10\n4 0 1 2 3\n4 1 2 3 4\nCELL_TYPES 2\n10\n10\nCELL_DATA 2\nSCALARS label int\n10\n20\n";

std::string legacy_vtk_error(const std::string& what, const std::string& replacement) {
    return error_of("m.vtk", with(simple, what, replacement));
}

}  // namespace

TEST_CASE("a legacy VTK file is read in every version, as text and binary") {
    for (const char* version : {"2.0", "3.0", "4.2", "5.1"}) {
        for (const bool is_binary : {false, true}) {
            CAPTURE(version, is_binary);
            const std::string text = vtk_text(version, is_binary);
            const geometry::TetData data = read_text("m.vtk", text);
            CHECK(data.vertices.size() == 5);
            CHECK(data.vertices[4] == Eigen::Vector3d(1, 1, 1));
            CHECK(data.tets == Tets{{0, 1, 2, 3}, {1, 2, 3, 4}});
            CHECK(data.labels == std::vector<int>{10, 20});
            for (const double part : {0.1, 0.3, 0.5}) {
                const auto size = static_cast<std::size_t>(part * static_cast<double>(text.size()));
                CHECK_THAT(error_of("m.vtk", text.substr(0, size)), Contains("m.vtk: "));
            }
        }
    }
}

TEST_CASE("a legacy VTK file whose SCALARS have no table") {
    const geometry::TetData data = read_text("m.vtk", simple);
    CHECK(data.tets == Tets{{0, 1, 2, 3}, {1, 2, 3, 4}});
    CHECK(data.labels == std::vector<int>{10, 20});
}

TEST_CASE("a wrong legacy VTK file is refused with its line") {
    CHECK_THAT(legacy_vtk_error("POINTS 5", "POINTS 6"),
               Contains("m.vtk: line 11: \"CELLS\" where a number is expected"));
    CHECK_THAT(legacy_vtk_error("POINTS 5", "POINTS 4"), Contains("line 10: \"1\" where a keyword is expected"));
    CHECK_THAT(legacy_vtk_error("POINTS 5", "POINTS 99999"),
               Contains("line 5: 99999 points are announced, more than the file"));
    CHECK_THAT(legacy_vtk_error("POINTS 5", "POINTS 100"), Contains("line 5: POINTS is announced to have 300 numbers"));
    CHECK_THAT(legacy_vtk_error("POINTS 5", "POINTS -5"), Contains("line 5: the number of points is negative"));
    CHECK_THAT(legacy_vtk_error("1 1 1\n", "1 1 inf\n"), Contains("line 10: \"inf\" where a number is expected"));
    CHECK_THAT(legacy_vtk_error("4 1 2 3 4", "4 1 2 3 5"), Contains("line 13: vertex 5 does not exist; use 0 to 4"));
    CHECK_THAT(legacy_vtk_error("4 1 2 3 4", "4 1 2 3 3"),
               Contains("line 13: the tetrahedron has the same vertex twice"));
    CHECK_THAT(legacy_vtk_error("4 1 2 3 4", "5 1 2 3 4"), Contains("line 13: a tetrahedron has 5 vertices"));
    CHECK_THAT(legacy_vtk_error("4 1 2 3 4", "-1 1 2 3 4"), Contains("line 13: the size of a cell is negative"));
    CHECK_THAT(legacy_vtk_error("CELLS 2 10", "CELLS 2 9"), Contains("line 13: \"4\" where a keyword is expected"));
    CHECK_THAT(legacy_vtk_error("CELL_TYPES 2", "CELL_TYPES 3"), Contains("line 14: 3 values for 2 cells"));
    CHECK_THAT(legacy_vtk_error("CELL_DATA 2", "CELL_DATA 1"), Contains("line 17: 1 values for 2 cells"));
    CHECK_THAT(legacy_vtk_error("10\n10\nCELL_DATA", "10\n13\nCELL_DATA"),
               Contains("line 16: the cell is a wedge (type 13)"));
    CHECK_THAT(legacy_vtk_error("10\n20\n", "10\n2.5\n"), Contains("line 20: a label is not a whole number"));
    CHECK_THAT(legacy_vtk_error("UNSTRUCTURED_GRID", "POLYDATA"), Contains("line 4: the data set is \"POLYDATA\""));
    CHECK_THAT(legacy_vtk_error("ASCII", "ASKEY"), Contains("line 3: \"ASKEY\" where ASCII or BINARY is expected"));
    CHECK_THAT(legacy_vtk_error("double", "string"), Contains("line 5: POINTS has the type \"string\""));
    CHECK_THAT(legacy_vtk_error("CELL_TYPES 2\n10\n10\n", ""), Contains("there are no CELL_TYPES"));
    CHECK_THAT(legacy_vtk_error("CELL_TYPES 2\n10\n10\n", "CELLS 1 1\n0\n"),
               Contains("there is a second section CELLS"));
    CHECK_THAT(error_of("m.vtk", ""), Contains("line 1: is no legacy VTK file"));
    const std::string offsets = vtk_text("5.1", false);
    CHECK_THAT(error_of("m.vtk", with(offsets, "OFFSETS vtktypeint64\n0", "OFFSETS vtktypeint64\n1")),
               Contains("the first offset is not 0"));
    CHECK_THAT(error_of("m.vtk", with(offsets, "CONNECTIVITY", "CONNECT")), Contains("where CONNECTIVITY is expected"));
    const std::string nan = with(vtk_text("4.2", true), numbers<float>(true, {1, 1, 1}),
                                 numbers<float>(true, {1, 1, std::numeric_limits<float>::quiet_NaN()}));
    CHECK_THAT(error_of("m.vtk", nan), Contains("m.vtk: number 15 of POINTS: a coordinate is not a finite number"));
}
