// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface_mesh.h"

#include <catch2/catch.hpp>
#include <numeric>
#include <regex>

#include "core/random.h"
#include "geometry/surface_check.h"
#include "geometry/surface_intersections.h"
#include "tests/geometry/surfaces.h"
#include "tests/io/surface/support.h"
#include "tests/support/seed.h"
#include "tests/support/shared_data.h"

using namespace dsc;
using namespace dsc::tests;
using geometry::SurfaceData;

namespace {

// A torus whose vertices were moved at random.
SurfaceData random_surface(core::Random& random) {
    SurfaceData surface = torus(8, 0.4);
    for (Eigen::Vector3d& p : surface.vertices) {
        for (double& x : p) x += random.uniform(-0.1, 0.1);
    }
    return surface;
}

SurfaceData rounded_to_floats(SurfaceData surface) {
    // One by one: GCC 12 loses the rounding of whole vectors at -O2.
    for (Eigen::Vector3d& p : surface.vertices)
        for (double& x : p) x = static_cast<double>(static_cast<float>(x));
    return surface;
}

SurfaceData written_and_read(const SurfaceData& data, const std::string& name) {
    const TemporaryFolder folder;
    io::require_writable_surface_mesh(folder / name);
    CHECK(folder.content().empty());
    io::write_surface_mesh(folder / name, data);
    return io::read_surface_mesh(folder / name);
}

std::vector<Eigen::Vector3d> corners(const SurfaceData& data) {
    std::vector<Eigen::Vector3d> corners;
    for (const auto& triangle : data.triangles) {
        for (const std::uint32_t v : triangle) corners.push_back(data.vertices[v]);
    }
    return corners;
}

}  // namespace

TEST_CASE("a surface comes back from OFF, OBJ and PLY bit for bit") {
    core::Random random(seed(82));
    for (const char* name : {"s.off", "s.obj", "s.PLY"}) {
        CAPTURE(name);
        SurfaceData data = random_surface(random);
        data.vertices.emplace_back(1e300, -5e-324, -0.0);  // of no triangle
        const SurfaceData same = written_and_read(data, name);
        CHECK(same_bits(same.vertices, data.vertices));
        CHECK(same.triangles == data.triangles);
        CHECK(same.labels.empty());
    }
}

TEST_CASE("the corners of a surface come back from STL, rounded to floats, and from then on bit for bit") {
    core::Random random(seed(83));
    const SurfaceData data = random_surface(random);
    const SurfaceData rounded = written_and_read(data, "s.stl");
    CHECK(same_bits(corners(rounded), corners(rounded_to_floats(data))));
    CHECK(rounded.vertices.size() == data.vertices.size());
    const SurfaceData same = written_and_read(rounded, "s.stl");
    CHECK(same_bits(same.vertices, rounded.vertices));
    CHECK(same.triangles == rounded.triangles);
}

TEST_CASE("PLY keeps labels") {
    SurfaceData data = box();
    for (int i = 0; i < 12; ++i) data.labels.push_back((i - 3) * 100000000);
    CHECK(written_and_read(data, "s.ply").labels == data.labels);
    CHECK(written_and_read(data, "s.off").labels.empty());
    data.labels.assign(12, 0);
    CHECK(written_and_read(data, "s.ply").labels.empty());
}

TEST_CASE("PLY has the columns of a result, and the other formats are written without") {
    const SurfaceData data = box();
    std::vector<double> residuals(8);
    std::iota(residuals.begin(), residuals.end(), 0.1);
    std::vector<int> is_invented(12);
    is_invented[3] = 1;
    const std::vector<Eigen::Vector3d> normals(8, {0, 0.6, -0.8});
    const io::SurfaceColumns columns{.vertex_columns = {{"residual", residuals}, {"quality", residuals}},
                                     .face_columns = {{"invented", is_invented}},
                                     .normals = normals};
    const TemporaryFolder folder;
    io::write_surface_mesh(folder / "s.ply", data, columns);
    const std::string bytes = io::read_file(folder / "s.ply");
    const std::string head =
        "ply\nformat binary_little_endian 1.0\nelement vertex 8\nproperty double x\nproperty double y\n"
        "property double z\nproperty double nx\nproperty double ny\nproperty double nz\nproperty double residual\n"
        "property double quality\nelement face 12\nproperty list uchar int vertex_indices\nproperty int invented\n"
        "end_header\n";
    CHECK(bytes.starts_with(head));
    CHECK(bytes.size() == head.size() + 8 * 8 * 8 + 12 * (1 + 4 * 4));
    CHECK(bytes.substr(head.size() + 6 * 8, 8) == bytes_of(residuals[0]));
    CHECK(bytes.substr(head.size() + 8 * 8 * 8 + 3 * 17 + 13, 4) == bytes_of(1));
    CHECK(io::read_surface_mesh(folder / "s.ply").triangles == data.triangles);
    CHECK(same_bits(io::read_points(folder / "s.ply").normals, normals));
    for (const char* name : {"s.off", "s.obj", "s.stl"}) {
        io::write_surface_mesh(folder / name, data, columns);
        const std::string with_columns = io::read_file(folder / name);
        io::write_surface_mesh(folder / name, data);
        CHECK(io::read_file(folder / name) == with_columns);
    }
}

TEST_CASE("the format of a surface follows the extension") {
    CHECK(io::surface_format("a/house.STL") == io::SurfaceFormat::stl);
    CHECK(io::surface_format("house.1.obj") == io::SurfaceFormat::obj);
    for (const char* path : {"house.mesh", "house", "house.off.gz"}) {
        INFO(path);
        CHECK_THROWS_WITH(io::surface_format(path), Catch::EndsWith("; use .off, .obj, .ply or .stl"));
        CHECK_THROWS_AS(io::write_surface_mesh(path, {}), core::InputError);
        CHECK_THROWS_AS(io::require_writable_surface_mesh(path), core::InputError);
    }
}

TEST_CASE("a surface file that can't be read or written is refused") {
    const TemporaryFolder folder;
    for (const char* name : {"none.off", "none.obj", "none.ply", "none.stl"}) {
        INFO(name);
        CHECK_THAT(input_error(folder / name, io::read_surface_mesh), Catch::Contains("can't be read: No such file"));
        CHECK_THAT(
            input_error(folder / name, io::read_points),
            Catch::EndsWith(name == std::string("none.stl") ? "use .xyz, .ply, .off or .obj" : "check the path"));
        CHECK_THROWS_AS(io::write_surface_mesh(folder.path() / "no folder" / name, box()), core::InputError);
    }
    std::filesystem::create_directory(folder / "folder.ply");
    CHECK_THAT(input_error(folder / "folder.ply", io::read_surface_mesh),
               Catch::Contains("Is a directory; name a file"));
}

TEST_CASE("the shared surfaces are what their tables say", "[shared]") {
    DSC_NEEDS_SHARED_DATA("surface/README.md");
    const std::string table = io::read_file(shared_data("surface/README.md"));
    const std::regex row(R"(\n\| (\w+\.off) \| (\d+) \| (\d+) \| (-?\d+) \|)");
    int rows = 0;
    for (std::sregex_iterator match(table.begin(), table.end(), row), end; match != end; ++match, ++rows) {
        const std::string name = (*match)[1];
        INFO(name);
        const SurfaceData data = io::read_surface_mesh(shared_data("surface/" + name));
        CHECK(data.vertices.size() == std::stoul((*match)[2]));
        CHECK(data.triangles.size() == std::stoul((*match)[3]));
        const geometry::SurfaceCheck check = geometry::check_surface(data);
        CHECK(check.euler_characteristic == std::stol((*match)[4]));
        CHECK(check.genus.has_value());
        CHECK(check.volume.value() > 0);
        for (const char* copy : {"s.off", "s.obj", "s.ply"}) {
            const SurfaceData same = written_and_read(data, copy);
            CHECK(same_bits(same.vertices, data.vertices));
            CHECK(same.triangles == data.triangles);
        }
    }
    CHECK(rows == 9);
}

TEST_CASE("the shared truths of point clouds are what their table says", "[shared]") {
    DSC_NEEDS_SHARED_DATA("points/README.md");
    const std::string table = io::read_file(shared_data("points/README.md"));
    const std::regex row(R"(\n\| (\w+\.off) \| (\d+) \| (\d+) \| (\d)(, 0)? \|)");
    int rows = 0;
    for (std::sregex_iterator match(table.begin(), table.end(), row), end; match != end; ++match, ++rows) {
        const std::string name = (*match)[1];
        INFO(name);
        const SurfaceData data = io::read_surface_mesh(shared_data("points/" + name));
        CHECK(data.triangles.size() == std::stoul((*match)[2]));
        const geometry::SurfaceCheck check = geometry::check_surface(data);
        CHECK(check.components == std::stoul((*match)[3]));
        CHECK(check.genus.value() == std::stol((*match)[4]));
    }
    CHECK(rows == 11);
}
