// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/generate/tetgen.h"

#include <stdlib.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "core/errors.h"
#include "dsc3d/generate/blocks.h"
#include "dsc3d/mesh.h"
#include "tests/dsc3d/volumes.h"
#include "tests/support/temporary_folder.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;

namespace {

TetGenInput cube() {
    const geometry::SurfaceData surface = box_surface({Point3(0, 0, 0), Point3(1, 1, 1)}, 0.5);
    return {.points = surface.vertices, .triangles = surface.triangles, .free_points = {Point3(0.3, 0.4, 0.6)}};
}

// Temporary folders go there as long as it lives.
class OwnTemporaryFolder {
public:
    OwnTemporaryFolder() { ::setenv("TMPDIR", folder_.path().c_str(), 1); }
    ~OwnTemporaryFolder() { ::unsetenv("TMPDIR"); }
    bool is_empty() const { return folder_.content().empty(); }

private:
    TemporaryFolder folder_;
};

void write_program(const std::string& path, const std::string& text) {
    std::ofstream(path) << text;
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
}

}  // namespace

TEST_CASE("TetGen fills a cube, keeps its vertices and uses the points given") {
    const OwnTemporaryFolder folder;
    core::Observer observer;
    const TetGenInput input = cube();
    const geometry::TetData data = tetgen(input, "tetgen", observer);
    REQUIRE(data.vertices.size() == input.points.size() + 1);
    for (std::size_t i = 0; i < input.points.size(); ++i) REQUIRE(data.vertices[i] == input.points[i]);
    CHECK(data.vertices.back() == input.free_points.front());
    const Mesh mesh(data);
    CHECK(validate(mesh).empty());
    CHECK(volume_of_label(mesh, 0) == Approx(1).epsilon(1e-14));
    CHECK(folder.is_empty());
}

TEST_CASE("a program that is missing or fails is reported with its name") {
    const OwnTemporaryFolder folder;
    core::Observer observer;
    CHECK_THROWS_AS(tetgen(cube(), "no-such-program", observer), core::RunError);
    CHECK_THROWS_WITH(tetgen(cube(), "no-such-program", observer),
                      Catch::Contains("no-such-program") && Catch::Contains("install"));
    CHECK_THROWS_AS(tetgen(cube(), "false", observer), core::RunError);
    CHECK_THROWS_WITH(tetgen(cube(), "false", observer), Catch::Contains("exit code 1"));
    CHECK_THROWS_AS(tetgen(cube(), "true", observer), core::RunError);
    CHECK(folder.is_empty());
}

TEST_CASE("a run of the program that is cancelled ends at once and leaves nothing behind") {
    const TemporaryFolder programs;
    const OwnTemporaryFolder folder;
    class Cancelled final : public core::Observer {
        bool is_cancelled() const override { return true; }
    } observer;
    const std::string program = (programs / "sleeper").string();
    write_program(program, "#!/bin/sh\nsleep 60\n");
    CHECK_THROWS_AS(tetgen(cube(), program, observer), core::Cancelled);
    CHECK(folder.is_empty());
}
