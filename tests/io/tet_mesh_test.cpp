// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/tet_mesh.h"

#include <catch2/catch.hpp>
#include <regex>

#include "tests/io/tet/support.h"
#include "tests/support/seed.h"
#include "tests/support/shared_data.h"

using namespace dsc;
using namespace dsc::tests;
using io::GmshVersion;
using io::TetFormat;
using io::TetMeshDialect;

namespace {

struct Case {
    const char* name;
    TetFormat format;
    TetMeshDialect dialect;
    bool groups_by_label = false;
};

const Case cases[] = {{"m.node", TetFormat::tetgen, {}},
                      {"m.ele", TetFormat::tetgen, {.first_index = 1}},
                      {"m", TetFormat::tetgen, {.first_index = 1}},
                      {"m.mesh", TetFormat::medit, {}},
                      {"m.msh", TetFormat::gmsh, {.gmsh = GmshVersion::v2_2}},
                      {"m.msh", TetFormat::gmsh, {.gmsh = GmshVersion::v4_1}, true},
                      {"m.vtu", TetFormat::vtu, {}},
                      {"m.VTK", TetFormat::legacy_vtk, {}}};

}  // namespace

TEST_CASE("a mesh comes back from every format bit for bit, with its labels") {
    core::Random random(seed(51));
    for (const Case& c : cases) {
        for (const bool has_labels : {true, false}) {
            CAPTURE(c.name, has_labels);
            const TemporaryFolder folder;
            geometry::TetData data = random_mesh(random, 1 + static_cast<std::uint32_t>(random.below(5)), has_labels);
            data.vertices.emplace_back(1e300, -5e-324, 0.1);  // of no tetrahedron
            io::require_writable_tet_mesh(folder / c.name);
            CHECK(folder.content().empty());
            io::write_tet_mesh(folder / c.name, data, c.dialect);
            const io::TetMeshFile file = io::read_tet_mesh(folder / c.name);
            CHECK(file.format == c.format);
            if (c.format == TetFormat::tetgen) CHECK(file.dialect.first_index == c.dialect.first_index);
            if (c.format == TetFormat::gmsh) CHECK(file.dialect.gmsh == c.dialect.gmsh);
            const geometry::TetData expected = c.groups_by_label ? sorted_by_label(data) : data;
            CHECK(same_coordinates(file.data, expected));
            CHECK(file.data.tets == expected.tets);
            CHECK(file.data.labels == expected.labels);
        }
    }
}

TEST_CASE("a mirrored mesh is turned as a whole, also when it is tiny or huge; single inverted tetrahedra stay") {
    core::Random random(seed(52));
    for (const double scale : {1e-120, 1.0, 1e120}) {
        for (const Case& c : cases) {
            CAPTURE(c.name, scale);
            const TemporaryFolder folder;
            geometry::TetData data = random_mesh(random, 2, false);
            for (Eigen::Vector3d& p : data.vertices) p *= scale;
            geometry::TetData mirrored = data;
            for (auto& tet : mirrored.tets) std::swap(tet[2], tet[3]);
            io::write_tet_mesh(folder / c.name, mirrored, c.dialect);
            CHECK(io::read_tet_mesh(folder / c.name).data.tets == data.tets);
            std::swap(data.tets[7][0], data.tets[7][3]);
            io::write_tet_mesh(folder / c.name, data, c.dialect);
            CHECK(io::read_tet_mesh(folder / c.name).data.tets == data.tets);
        }
    }
}

TEST_CASE("the format follows the extension") {
    CHECK(io::tet_format("a/house") == TetFormat::tetgen);
    CHECK(io::tet_format("a.b/house.1") == TetFormat::tetgen);
    CHECK(io::tet_format("house.MSH") == TetFormat::gmsh);
    for (const char* path : {"house.stl", "house.meshb", "house.1a", "house.vtu.gz"}) {
        INFO(path);
        CHECK_THROWS_WITH(io::tet_format(path), Catch::EndsWith("; use .node, .ele, .mesh, .msh, .vtu or .vtk"));
        CHECK_THROWS_AS(io::write_tet_mesh(path, {}), core::InputError);
    }
}

TEST_CASE("a file that can't be read is refused") {
    const TemporaryFolder folder;
    for (const char* name : {"none.node", "none.mesh", "none.msh", "none.vtu", "none.vtk", "none"}) {
        INFO(name);
        CHECK_THAT(reading_error(folder / name), Catch::Contains("can't be read: No such file or directory"));
    }
    std::filesystem::create_directory(folder / "folder.mesh");
    CHECK_THAT(reading_error(folder / "folder.mesh"), Catch::Contains("can't be read: Is a directory; name a file"));
}

TEST_CASE("the shared meshes have the counts of their table", "[shared]") {
    DSC_NEEDS_SHARED_DATA("tet/README.md");
    const std::string table = io::read_file(shared_data("tet/README.md"));
    const std::regex row(R"(\n\| (\w+) \| (\d+) \| \d+ \| (\d+) \|)");
    int rows = 0;
    for (std::sregex_iterator match(table.begin(), table.end(), row), end; match != end; ++match, ++rows) {
        const std::string name = (*match)[1];
        INFO(name);
        const io::TetMeshFile file = io::read_tet_mesh(shared_data("tet/" + name));
        CHECK(file.data.vertices.size() == std::stoul((*match)[2]));
        CHECK(file.data.tets.size() == std::stoul((*match)[3]));
        bool is_positive = true;
        for (std::size_t i = 0; i < file.data.tets.size(); ++i) {
            is_positive = is_positive && signed_volume(file.data, i) > 0;
        }
        CHECK(is_positive);
        // What is written has the numbers of what was read.
        const TemporaryFolder folder;
        io::write_tet_mesh(folder / name, file.data, file.dialect);
        const io::TetMeshFile again = io::read_tet_mesh(folder / name);
        CHECK(again.dialect.first_index == file.dialect.first_index);
        CHECK(same_coordinates(again.data, file.data));
        CHECK(again.data.tets == file.data.tets);
        CHECK(again.data.labels == file.data.labels);
    }
    CHECK(rows == 13);
}
