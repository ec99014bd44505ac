// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "geometry/surface_check.h"
#include "tests/geometry/surfaces.h"
#include "tests/io/surface/support.h"

using namespace dsc;
using namespace dsc::tests;
using Catch::Contains;

namespace {

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
    return "  facet normal 0 0 nan\n    outer loop\n      vertex " + a + "\n      vertex " + b + "\n      vertex " + c +
           "\n    endloop\n  endfacet\n";
}

const std::string text = "solid made by hand\n" + facet("0 0 0", "1 0 0", "0 1 0") +
                         facet("1 0 0", "1e0 1 0", "-0 1.0 0") + "endsolid made by hand\n";

std::string stl_error(const std::string& what, const std::string& replacement) {
    return surface_error("s.stl", replaced(text, what, replacement));
}

std::string binary(const std::vector<std::array<float, 9>>& facets, std::string head = "") {
    head.resize(80, '\0');
    std::string bytes = head + bytes_of(static_cast<std::uint32_t>(facets.size()));
    for (const auto& corners : facets) {
        bytes.append(12, '\0');
        for (const float x : corners) bytes += bytes_of(x);
        bytes.append(2, '\x7f');
    }
    return bytes;
}

const std::vector<std::array<float, 9>> facets{{0, 0, 0, 1, 0, 0, 0, 1, 0}, {1, 0, 0, 1, 1, 0, -0.0F, 1, 0}};
const Triangles stl_triangles{{0, 1, 2}, {1, 3, 2}};

}  // namespace

TEST_CASE("an STL file is read, corners at the same place as one vertex") {
    std::string upper = text;
    for (char& c : upper) c = static_cast<char>(std::toupper(c));
    for (const std::string& file : {text, upper, replaced(text, "solid made by hand", "solid"),
                                    replaced(text, "  endfacet\n", "  endfacet\nendsolid\n\nsolid second\n"),
                                    binary(facets, "solid of nothing"), binary(facets)}) {
        INFO(file);
        const geometry::SurfaceData data = surface_in("s.stl", file);
        CHECK(data.vertices == std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
        CHECK(data.triangles == stl_triangles);
    }
}

TEST_CASE("triangles that vanish when corners become one are left out") {
    const std::string more = facet("0 0 0", "1 0 0", "0 0 0") + facet("1 1 0", "1 1 0", "1 1 0") + "endsolid";
    CHECK(surface_in("s.stl", replaced(text, "endsolid", more)).triangles == stl_triangles);
    // A sphere of which many triangles are too small for floats, far from the origin, stays closed.
    geometry::SurfaceData sphere = icosphere(4);
    for (Eigen::Vector3d& p : sphere.vertices) p += Eigen::Vector3d(1 << 20, 1 << 20, 1 << 20);
    const TemporaryFolder folder;
    io::write_surface_mesh(folder / "s.stl", sphere);
    const geometry::SurfaceData rounded = io::read_surface_mesh(folder / "s.stl");
    CHECK(rounded.triangles.size() < sphere.triangles.size());
    CHECK(geometry::check_surface(rounded).open_edges.empty());
}

TEST_CASE("an STL file is written with unit normals, whatever the size of the triangles") {
    for (const float scale : {1e-37F, 1.0F, 1e37F}) {
        geometry::SurfaceData surface = box({0, 0, 0}, static_cast<double>(scale));
        const TemporaryFolder folder;
        io::write_surface_mesh(folder / "s.stl", surface);
        const std::string bytes = io::read_file(folder / "s.stl");
        CHECK(bytes.size() == 84 + 50 * 12);
        CHECK(bytes.substr(84, 12) == bytes_of(0.0F) + bytes_of(0.0F) + bytes_of(-1.0F));
    }
}

TEST_CASE("coordinates that floats can't hold are not written") {
    const TemporaryFolder folder;
    CHECK_THAT(input_error(folder / "s.stl",
                           [](const auto& path) {
                               io::write_surface_mesh(path, box({1e39, 0, 0}));
                           }),
               Contains("s.stl: vertex 0: a coordinate is beyond the floats that STL has room for; choose .ply"));
    CHECK(folder.content().empty());
}

TEST_CASE("a wrong ASCII STL file is refused with its line") {
    CHECK_THAT(surface_error("s.stl", ""), Contains("s.stl: line 1: ends where solid is expected"));
    CHECK_THAT(surface_error("s.stl", "solid\nendsolid\n"), Contains("contains no facets"));
    CHECK_THAT(stl_error("vertex 1 0 0", "vertex 1 0"), Contains("line 6: \"vertex\" where a coordinate is expected"));
    CHECK_THAT(stl_error("vertex 1 0 0", "vertex 1 0 inf"), Contains("line 5: \"inf\" where a coordinate is expected"));
    CHECK_THAT(stl_error("vertex 1 0 0", "corner 1 0 0"), Contains("line 5: \"corner\" where vertex is expected"));
    CHECK_THAT(stl_error("    endloop", "vertex 1 1 1\n    endloop"), Contains("line 7: \"vertex\" where endloop is"));
    CHECK_THAT(stl_error("  facet", "  face"), Contains("line 2: \"face\" where facet or endsolid is expected"));
    CHECK_THAT(stl_error("endsolid made by hand\n", ""),
               Contains("ends where facet or endsolid is expected; the file is"));
}

TEST_CASE("a wrong binary STL file is refused") {
    const std::string whole = binary(facets, "made by hand");
    for (const std::string& file : {whole.substr(0, whole.size() - 1), whole + "x", whole.substr(0, 83)}) {
        CHECK_THAT(surface_error("s.stl", file),
                   Contains("s.stl: is neither an ASCII STL file nor has it the size of"));
    }
    CHECK_THAT(surface_error("s.stl", binary({})), Contains("contains no facets"));
    auto wrong = facets;
    wrong[1][4] = std::numeric_limits<float>::infinity();
    CHECK_THAT(surface_error("s.stl", binary(wrong)), Contains("s.stl: facet 2: a coordinate is not a finite number"));
}
