// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "tests/io/tet/support.h"

using namespace dsc;
using namespace dsc::tests;
using Catch::Contains;

namespace {

using Tets = std::vector<std::array<std::uint32_t, 4>>;

const std::string version_2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 10 \"left $Nodes\"\n$EndPhysicalNames\n"
    "$Nodes\n5\n1 0 0 0\n7 1 0 0\n30000000 0 1 0\n4 0 0 1\n5 1 1 1\n$EndNodes\n"
    "$Elements\n4\n1 15 2 0 1 1\n2 2 2 3 1 1 7 4\n3 4 3 10 1 99 1 7 30000000 4\n4 4 2 20 2 7 30000000 4 5\n"
    "$EndElements\n";

const std::string version_4 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Comments\nanything\n$EndComments\n"
    "$Entities\n1 1 1 2\n1 0 0 0 0\n1 0 0 0 1 1 1 0 2 1 1\n1 0 0 0 1 1 1 1 3 0\n"
    "1 0 0 0 1 1 1 2 10 11 1 1\n8 0 0 0 1 1 1 0 1 1\n$EndEntities\n"
    "$Nodes\n2 5 1 50\n0 1 1 1\n1\n0 0 0 0.5\n3 1 0 4\n7\n30\n4\n50\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n$EndNodes\n"
    "$Elements\n3 4 1 4\n2 1 2 2\n1 1 7 4\n2 1 7 30\n3 1 4 1\n3 1 7 30 4\n3 8 4 1\n4 7 30 4 50\n$EndElements\n";

std::string error_2(const std::string& what, const std::string& replacement) {
    return error_of("m.msh", with(version_2, what, replacement));
}

std::string error_4(const std::string& what, const std::string& replacement) {
    return error_of("m.msh", with(version_4, what, replacement));
}

}  // namespace

TEST_CASE("Gmsh 2.2: sparse numbers, other elements left out, the first tag as label") {
    const geometry::TetData data = read_text("m.msh", version_2);
    CHECK(data.vertices.size() == 5);
    CHECK(data.tets == Tets{{0, 1, 2, 3}, {1, 2, 3, 4}});
    CHECK(data.labels == std::vector<int>{10, 20});
    CHECK(read_text("m.msh", with(version_2, "4 4 2 20 2 7", "4 4 0 7")).labels == std::vector<int>{10, 0});
}

TEST_CASE("Gmsh 4.1: blocks, the physical group of the volume as label, else the volume") {
    const geometry::TetData data = read_text("m.msh", version_4);
    CHECK(data.vertices.size() == 5);
    CHECK(data.vertices[4] == Eigen::Vector3d(1, 1, 1));
    CHECK(data.tets == Tets{{0, 1, 2, 3}, {1, 2, 3, 4}});
    CHECK(data.labels == std::vector<int>{10, 8});
}

TEST_CASE("the version of Gmsh's format is kept") {
    const TemporaryFolder folder;
    for (const std::string& text : {version_2, version_4}) {
        io::write_file(folder / "m.msh", text);
        const io::TetMeshFile file = io::read_tet_mesh(folder / "m.msh");
        io::write_tet_mesh(folder / "out.msh", file.data, file.dialect);
        CHECK(io::read_file(folder / "out.msh").substr(12, 7) == text.substr(12, 7));
    }
}

TEST_CASE("a wrong Gmsh 2.2 file is refused with its line") {
    CHECK_THAT(error_2("$Nodes\n5\n", "$Nodes\n6\n"), Contains("m.msh: line 15: \"$EndNodes\" where the number of a"));
    CHECK_THAT(error_2("$Nodes\n5\n", "$Nodes\n4\n"), Contains("line 14: \"5\" where $EndNodes is expected"));
    CHECK_THAT(error_2("$Nodes\n5\n", "$Nodes\n77777777777\n"), Contains("line 9: 77777777777 nodes are announced"));
    CHECK_THAT(error_2("5 1 1 1", "4 1 1 1"), Contains("line 14: the node 4 occurs twice"));
    CHECK_THAT(error_2("5 1 1 1", "5 1 1 -inf"), Contains("line 14: \"-inf\" where a coordinate is expected"));
    CHECK_THAT(error_2("30000000 4 5", "30000000 4 6"), Contains("line 21: the node 6 does not exist"));
    CHECK_THAT(error_2("30000000 4 5", "30000000 4 4"), Contains("line 21: the tetrahedron has the same vertex twice"));
    CHECK_THAT(error_2("30000000 4 5", "30000000 4 5 1"), Contains("line 21: there are more numbers"));
    CHECK_THAT(error_2("2 2 2 3 1 1 7 4", "2 5 2 3 1 1 7 4 5 1 7 4 5"),
               Contains("line 19: the element is a hexahedron"));
    CHECK_THAT(error_2("2 2 2 3 1 1 7 4", "2 11 2 3 1 1 7 4"), Contains("a tetrahedron of higher order (type 11)"));
    CHECK_THAT(error_2("2 2 2 3 1 1 7 4", "2 777 2 3 1 1 7 4"), Contains("of a kind that can't be read (type 777)"));
    CHECK_THAT(error_2("$Elements\n4", "$Elements\n3"), Contains("line 21: \"4\" where $EndElements is expected"));
    CHECK_THAT(error_2("20 2 7", "2000000000000 2 7"), Contains("line 21: the label 2000000000000 is too large"));
    CHECK_THAT(error_2("$EndElements\n", ""), Contains("ends where $EndElements is expected"));
    CHECK_THAT(error_2("$Nodes\n5", "$Others\n5"), Contains("ends where $EndOthers is expected"));
    CHECK_THAT(error_of("m.msh", version_2.substr(0, version_2.find("$Nodes\n")) + "$Elements\n0\n$EndElements\n"),
               Contains("$Elements comes before $Nodes"));
}

TEST_CASE("a wrong Gmsh 4.1 file is refused with its line") {
    CHECK_THAT(error_4("2 5 1 50", "2 6 1 50"), Contains("m.msh: line 28: the blocks have 5 nodes where 6 are"));
    CHECK_THAT(error_4("3 4 1 4", "3 5 1 4"), Contains("the blocks have 4 elements where 5 are announced"));
    CHECK_THAT(error_4("2 5 1 50", "1 5 1 50"), Contains("line 19: the blocks have 1 nodes where 5 are announced"));
    CHECK_THAT(error_4("3 1 0 4\n7", "3 1 0 5\n7"), Contains("line 25: there are fewer numbers than expected"));
    CHECK_THAT(error_4("3 8 4 1", "3 8 5 1"), Contains("line 37: the element is a hexahedron (type 5); make linear"));
    CHECK_THAT(error_4("3 8 4 1", "3 8 4 100000000"), Contains("line 37: 100000000 elements are announced"));
    CHECK_THAT(error_4("4 7 30 4 50", "4 7 30 4 51"), Contains("line 38: the node 51 does not exist"));
    CHECK_THAT(error_4("2 10 11 1 1", "-2 10 11 1 1"), Contains("line 12: the number of physical groups is negative"));
}

TEST_CASE("another kind of Gmsh file is refused with its cure") {
    CHECK_THAT(error_2("2.2 0 8", "2.2 1 8"), Contains("line 2: the file is binary; save it as text"));
    CHECK_THAT(error_2("2.2 0 8", "4 0 8"), Contains("line 2: the version 4 can't be read; save it with gmsh"));
    CHECK_THAT(error_2("2.2 0 8", "x 0 8"), Contains("line 2: \"x\" where the version is expected"));
    CHECK_THAT(error_of("m.msh", "$NOD\n1\n"), Contains("line 1: is no Gmsh mesh"));
    CHECK_THAT(error_of("m.msh", ""), Contains("line 1: ends where $MeshFormat is expected"));
    CHECK_THAT(error_of("m.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"), Contains("contains no tetrahedra"));
}
