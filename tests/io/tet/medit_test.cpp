// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "tests/io/tet/support.h"

using namespace dsc;
using namespace dsc::tests;
using Catch::Contains;

namespace {

const std::string vertices = "Vertices\n5\n0 0 0 1\n1 0 0 1\n0 1 0 1\n0 0 1 1\n1 1 1 1\n";
const std::string tets = "Tetrahedra\n2\n1 2 3 4 10\n2 3 4 5 20\n";
const std::string medit_text = "MeshVersionFormatted 2\n# made by hand\nDimension 3\n" + vertices +
                               "Triangles 1\n1 2 3 7\nCorners\n2\n1\n2\nAngleOfCornerBound 0.3\n" + tets + "\nEnd\n";

std::string medit_error(const std::string& what, const std::string& replacement) {
    return error_of("m.mesh", with(medit_text, what, replacement));
}

}  // namespace

TEST_CASE("a MEDIT file is read whatever else is in it, in any order and spacing") {
    const geometry::TetData data = read_text("m.mesh", medit_text);
    CHECK(data.vertices.size() == 5);
    CHECK(data.tets == std::vector<std::array<std::uint32_t, 4>>{{0, 1, 2, 3}, {1, 2, 3, 4}});
    CHECK(data.labels == std::vector<int>{10, 20});

    const std::string other_order = with(with(medit_text, tets, ""), vertices, tets + vertices);
    for (const std::string& other :
         {with(medit_text, "Dimension 3", "Dimension\n3"),
          with(medit_text, "MeshVersionFormatted 2", "MeshVersionFormatted\n1\n"), with(medit_text, "\nEnd\n", "\n"),
          other_order, with(medit_text, "Triangles 1", "Hexahedra 0\nTriangles 1"),
          with(medit_text, "Triangles 1", "TangentsOfNewKind 2\n0.5 -1e-3 .5 +7 7 8\nTriangles 1")}) {
        INFO(other);
        const geometry::TetData same = read_text("m.mesh", other);
        CHECK(same_coordinates(same, data));
        CHECK(same.tets == data.tets);
        CHECK(same.labels == data.labels);
    }
}

TEST_CASE("a wrong MEDIT file is refused with its line") {
    CHECK_THAT(medit_error("Vertices\n5", "Vertices\n6"),
               Contains("m.mesh: line 11: \"Triangles\" where a coordinate is"));
    CHECK_THAT(medit_error("Vertices\n5", "Vertices\n4"), Contains("line 10: \"1\" where a keyword is expected"));
    CHECK_THAT(medit_error("Vertices\n5", "Vertices\n99999999999"),
               Contains("line 5: 99999999999 vertices are announced"));
    CHECK_THAT(medit_error("Vertices\n5", "Vertices\n-5"), Contains("line 5: the number of vertices is negative"));
    CHECK_THAT(medit_error("Tetrahedra\n2", "Tetrahedra\n1"),
               Contains("line 21: there are more tetrahedra than announced"));
    CHECK_THAT(medit_error("Tetrahedra\n2", "Tetrahedra\n3"),
               Contains("line 23: \"End\" where the number of a vertex is"));
    CHECK_THAT(medit_error("2 3 4 5 20", "2 3 4 6 20"), Contains("line 21: vertex 6 does not exist; use 1 to 5"));
    CHECK_THAT(medit_error("2 3 4 5 20", "2 3 4 2 20"), Contains("line 21: the tetrahedron has the same vertex twice"));
    CHECK_THAT(medit_error("2 3 4 5 20", "2 3 4 5"),
               Contains("line 23: \"End\" where the reference of a tetrahedron is"));
    CHECK_THAT(medit_error("1 2 3 4 10", "1 2 3 4"), Contains("line 20: there are fewer numbers than expected"));
    CHECK_THAT(medit_error("1 1 1 1", "1 nan 1 1"), Contains("line 10: \"nan\" where a coordinate is expected"));
    CHECK_THAT(medit_error("Triangles 1", "Hexahedra 1"), Contains("line 11: the mesh has Hexahedra; convert them"));
    CHECK_THAT(medit_error("Triangles 1", "TetrahedraP2 1"), Contains("line 11: the mesh has TetrahedraP2"));
    CHECK_THAT(medit_error("Dimension 3", "Dimension 2"), Contains("line 3: the dimension is not 3"));
    CHECK_THAT(medit_error("End", tets), Contains("there is a second section Tetrahedra"));
    CHECK_THAT(medit_error("End", vertices), Contains("there is a second section Vertices"));
    CHECK_THAT(medit_error(vertices, ""), Contains("there is no section Vertices"));
    CHECK_THAT(medit_error(tets, ""), Contains("m.mesh: contains no tetrahedra"));
    CHECK_THAT(medit_error("MeshVersion", "Version"), Contains("line 1: is no MEDIT text file"));
    CHECK_THAT(error_of("m.mesh", ""), Contains("m.mesh: line 1: ends where MeshVersionFormatted is expected"));
    CHECK_THAT(error_of("m.mesh", medit_text.substr(0, medit_text.find("5 20"))), Contains("line 21: ends where"));
}
