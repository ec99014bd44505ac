// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/planar_mesh.h"

#include <catch2/catch.hpp>

#include "core/errors.h"
#include "io/atomic_file.h"
#include "tests/support/temporary_folder.h"

using namespace dsc;

TEST_CASE("a planar mesh is the same after writing and reading") {
    geometry::SurfaceData data;
    data.vertices = {{0.1, 1.0 / 3, 0}, {1e-300, -2, 0}, {3, 1e17, 0}, {5, 6, 0}};
    data.triangles = {{0, 1, 2}, {3, 2, 1}};
    data.labels = {7, -1};
    const tests::TemporaryFolder folder;
    io::write_planar_mesh(folder / "a.mesh", data);
    const geometry::SurfaceData found = io::read_planar_mesh(folder / "a.mesh");
    CHECK(found.vertices == data.vertices);
    CHECK(found.triangles == data.triangles);
    CHECK(found.labels == data.labels);
}

TEST_CASE("a mirrored mesh is turned as a whole; single clockwise or flat triangles stay") {
    const tests::TemporaryFolder folder;
    const auto turned = [&](const std::string& triangles) {
        io::write_file(folder / "a.mesh",
                       "MeshVersionFormatted 2\nDimension 2\nVertices\n5\n0 0 0\n1e-9 0 0\n1e-9 1e-9 0\n0 1e-9 0\n"
                       "2e-9 0 0\nTriangles\n2\n" +
                           triangles);
        return io::read_planar_mesh(folder / "a.mesh").triangles;
    };
    using Triangles = std::vector<std::array<std::uint32_t, 3>>;
    CHECK(turned("1 3 2 1\n1 4 3 2\n") == Triangles{{0, 1, 2}, {0, 2, 3}});
    CHECK(turned("1 2 3 1\n1 3 4 2\n") == Triangles{{0, 1, 2}, {0, 2, 3}});
    CHECK(turned("1 3 2 1\n1 3 4 2\n") == Triangles{{0, 2, 1}, {0, 2, 3}});
    CHECK(turned("1 3 2 1\n1 2 5 2\n") == Triangles{{0, 2, 1}, {0, 1, 4}});
}

TEST_CASE("what is no planar mesh is refused with its line") {
    const tests::TemporaryFolder folder;
    const auto check_refused = [&](const std::string& text, const std::string& word) {
        CAPTURE(text);
        io::write_file(folder / "a.mesh", text);
        CHECK_THROWS_AS(io::read_planar_mesh(folder / "a.mesh"), core::InputError);
        CHECK_THROWS_WITH(io::read_planar_mesh(folder / "a.mesh"), Catch::Contains(word) && Catch::Contains("a.mesh"));
    };
    const std::string head = "MeshVersionFormatted 2\nDimension 2\nVertices\n3\n0 0 0\n1 0 0\n0 1 0\n";
    check_refused("", "MeshVersionFormatted");
    check_refused("MeshVersionFormatted 2\nDimension 3\n", "dimension is not 2");
    check_refused(head, "no triangles");
    check_refused(head + "Triangles\n1\n1 2 4 0\n", "vertex 4");
    check_refused(head + "Triangles\n1\n1 2 0 0\n", "vertex 0");
    check_refused(head + "Triangles\n1\n1 2 3\n", "reference");
    check_refused(head + "Triangles\n1\n1 2 3 99999999999\n", "label");
    check_refused(head + "Triangles\n1000000\n1 2 3 0\n", "line 9");
    io::write_file(folder / "a.mesh", head + "Edges\n1\n1 2 5\nTriangles\n1\n1 2 3 4\nEnd\n");
    CHECK(io::read_planar_mesh(folder / "a.mesh").labels == std::vector<int>{4});
}
