// SPDX-License-Identifier: GPL-3.0-or-later
// The built program as a user runs it: files, reports, and every bad input refused with one line.
#include <catch2/catch.hpp>

#include <filesystem>

#include "geometry/surface_check.h"
#include "io/atomic_file.h"
#include "io/json.h"
#include "io/number.h"
#include "io/surface_mesh.h"
#include "io/tet_mesh.h"
#include "tests/apps/reconstruct/clouds.h"
#include "tests/support/run_program.h"
#include "tests/support/seed.h"
#include "tests/support/temporary_folder.h"

using namespace dsc;
using namespace dsc::tests;

namespace {

std::string write_cloud(const TemporaryFolder& folder, const OrientedCloud& cloud) {
    std::string text;
    for (const Point3& p : cloud.points)
        text += io::number_text(p.x(), 9) + ' ' + io::number_text(p.y(), 9) + ' ' + io::number_text(p.z(), 9) + '\n';
    const std::filesystem::path path = folder / "cloud.xyz";
    io::write_file(path, text);
    return path.string();
}

void check_refused(const std::vector<std::string>& arguments, const std::vector<std::string>& words) {
    const ProgramResult result = run_program(DSC_RECONSTRUCT_PROGRAM, arguments);
    INFO(result.err);
    CHECK(result.exit_code == 2);
    CHECK(result.out.empty());
    CHECK(result.err_lines() == 1);
    CHECK(result.err.rfind("reconstruct: ", 0) == 0);
    for (const std::string& word : words) CHECK_THAT(result.err, Catch::Contains(word));
}

}  // namespace

TEST_CASE("surface, tetrahedra, report, page and stages are written") {
    const TemporaryFolder folder;
    core::Random random(seed(1));
    const std::string cloud = write_cloud(folder, sphere_cloud({0, 0, 0}, 1, 600, random));
    const auto path = [&](const char* name) { return (folder / name).string(); };
    const ProgramResult run = run_program(
        DSC_RECONSTRUCT_PROGRAM, {cloud, "-o", path("ball.ply"), "--tets", path("ball.vtu"), "--json",
                                  path("ball.json"), "--html", path("ball.html"), "--snapshots", path("stages")});
    INFO(run.err);
    CHECK(run.exit_code == 0);
    CHECK(run.err.empty());
    CHECK_THAT(run.out, Catch::Contains("genus 0"));
    const geometry::SurfaceData surface = io::read_surface_mesh(path("ball.ply"));
    CHECK(geometry::check_surface(surface).genus == 0);
    const io::Json report = io::Json::parse(io::read_file(path("ball.json")));
    CHECK(report["points"].integer() == 600);
    CHECK(report["surface"]["triangles"].integer() == static_cast<std::int64_t>(surface.triangles.size()));
    CHECK(report["tets"].integer() == static_cast<std::int64_t>(io::read_tet_mesh(path("ball.vtu")).data.tets.size()));
    CHECK_THAT(io::read_file(path("ball.html")), Catch::Contains("stage"));
    CHECK(std::filesystem::exists(folder / "stages" / "series.pvd"));
}

TEST_CASE("half a sphere is closed, and the triangles that close it are marked in PLY and JSON") {
    const TemporaryFolder folder;
    core::Random random(seed(1));
    OrientedCloud points = sphere_cloud({0, 0, 0}, 1, 2000, random);
    std::erase_if(points.points, [](const Point3& p) { return p.z() < 0; });
    const std::string cloud = write_cloud(folder, points);
    const std::string ply = (folder / "half.ply").string(), json = (folder / "half.json").string();
    const ProgramResult run = run_program(DSC_RECONSTRUCT_PROGRAM, {cloud, "-o", ply, "--json", json, "--genus", "0"});
    INFO(run.err);
    REQUIRE(run.exit_code == 0);
    const geometry::SurfaceData surface = io::read_surface_mesh(ply);
    CHECK(geometry::check_surface(surface).genus == 0);
    CHECK_THAT(io::read_file(ply), Catch::Contains("invented"));
    const io::Json invented = io::Json::parse(io::read_file(json))["surface"]["invented_triangles"];
    CHECK(invented.size() > 20);
    CHECK(invented.size() < surface.triangles.size());
}

TEST_CASE("bad clouds and options are refused in one line, and nothing is overwritten") {
    const TemporaryFolder folder;
    const std::string out = (folder / "out.obj").string();
    io::write_file(out, "old");
    const auto check_text = [&](const std::string& name, const std::string& text, std::vector<std::string> words) {
        const std::filesystem::path path = folder / name;
        io::write_file(path, text);
        words.push_back(name);
        check_refused({path.string(), "-o", out}, words);
        CHECK(io::read_file(out) == "old");
    };
    check_text("few.xyz", "0 0 0\n1 0 0\n0 1 0\n0 1 0\n", {"3 different points"});
    check_text("plane.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 1 0\n", {"in a plane"});
    check_text("line.xyz", "0 0 0\n1 1 1\n2 2 2\n3 3 3\n", {"on a line"});
    check_text("nan.xyz", "0 0 0\n1 0 nan\n0 1 0\n0 0 1\n", {"line 2"});
    check_text("columns.xyz", "0 0 0\n1 0\n0 1 0\n0 0 1\n", {"line 2"});
    check_refused({(folder / "absent.xyz").string(), "-o", out}, {"absent.xyz"});
    check_refused({folder.path().string(), "-o", out}, {"is a folder"});
    core::Random random(seed(1));
    const std::string cloud = write_cloud(folder, sphere_cloud({0, 0, 0}, 1, 100, random));
    check_refused({cloud, "-o", (folder / "out.txt").string()}, {"out.txt"});
    check_refused({cloud, "-o", out, "--detail", "0"}, {"--detail"});
    check_refused({cloud, "-o", out, "--noise", "-1"}, {"--noise"});
    check_refused({cloud, "-o", out, "--min-angle", "20"}, {"--tets"});
    check_refused({cloud, "-o", out, "--genus", "2"}, {"--genus"});
    check_refused({}, {"POINTS"});
}
