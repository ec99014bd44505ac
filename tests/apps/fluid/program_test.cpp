// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "io/atomic_file.h"
#include "io/json.h"
#include "io/surface_mesh.h"
#include "io/tet_mesh.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

using namespace dsc;
using namespace dsc::tests;

namespace fs = std::filesystem;

namespace {

using Arguments = std::vector<std::string>;

const Arguments short_run = {"--scene", "droplet", "--edge-length", "0.4", "--steps", "12", "--checkpoint", "4"};

Arguments with(Arguments arguments, const Arguments& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

void check_program_refuses(const Arguments& arguments, const std::string& word) {
    CAPTURE(arguments);
    const ProgramResult result = run_program(DSC_FLUID_PROGRAM, arguments);
    INFO(result.err);
    CHECK(result.exit_code == 2);
    CHECK(result.out.empty());
    CHECK(result.err_lines() == 1);
    CHECK_THAT(result.err, Catch::Contains(word));
}

// The report without the folder and what differs from run to run.
std::string timeless_report(const fs::path& folder) {
    io::Json report = io::Json::parse(io::read_file(folder / "report.json"));
    report["seconds"] = 0;
    report["options"]["--output"] = "";
    for (std::size_t i = 0; i < report["steps"].size(); ++i) report["steps"][i]["ms"] = 0;
    return report.dump();
}

}  // namespace

TEST_CASE("a run leaves the surfaces, the mesh, the series, the report and the page", "[fluid]") {
    const TemporaryFolder folder;
    const fs::path out = folder / "run";
    const ProgramResult result = run_program(DSC_FLUID_PROGRAM, with(short_run, {"-o", out.string()}));
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    CHECK_THAT(result.out, Catch::Contains("volume"));
    for (const char* name : {"final.mesh", "series.pvd", "series_0000.vtp", "report.json", "index.html", "checkpoint"})
        CHECK(fs::exists(out / name));
    const io::Json report = io::Json::parse(io::read_file(out / "report.json"));
    CHECK(report["end"].string() == "done");
    REQUIRE(report["steps"].size() == 13);
    const io::Json& first = report["steps"][0];
    CHECK(io::read_surface_mesh(out / "surface_0000.obj").triangles.size() ==
          static_cast<std::size_t>(first["surface_faces"].integer()));
    const io::Json& last = report["steps"][12];
    CHECK(io::read_tet_mesh(out / "final.mesh").data.tets.size() == static_cast<std::size_t>(last["tets"].integer()));
    CHECK(last["time"].number() > 0);
    CHECK(last["kinetic_energy"].number() > 0);
    CHECK(last["surface_energy"].number() < first["surface_energy"].number());
    CHECK(last["volumes"][0].number() == Approx(first["volumes"][0].number()).epsilon(1e-4));
}

TEST_CASE("a run that was killed goes on to the same results", "[fluid]") {
    const TemporaryFolder folder;
    const fs::path whole = folder / "whole", killed = folder / "killed";
    REQUIRE(run_program(DSC_FLUID_PROGRAM, with(short_run, {"-o", whole.string()})).exit_code == 0);
    run_program_killed(DSC_FLUID_PROGRAM, with(short_run, {"-o", killed.string()}),
                       [&] { return fs::exists(killed / "checkpoint"); });
    REQUIRE(run_program(DSC_FLUID_PROGRAM, {"--resume", "-o", killed.string()}).exit_code == 0);
    CHECK(io::read_file(killed / "final.mesh") == io::read_file(whole / "final.mesh"));
    CHECK(timeless_report(killed) == timeless_report(whole));
}

TEST_CASE("bad input is refused in one line", "[fluid]") {
    const TemporaryFolder folder;
    const std::string out = (folder / "out").string();
    check_program_refuses({"-o", out}, "scene");
    check_program_refuses({"--scene", "droplet"}, "-o");
    check_program_refuses({"--scene", "nothing", "-o", out}, "--scene");
    check_program_refuses({"absent.json", "-o", out}, "absent.json");
    check_program_refuses({"--scene", "droplet", "--density", "0", "-o", out}, "--density");
    check_program_refuses({"--scene", "droplet", "--dt", "fast", "-o", out}, "--dt");
    check_program_refuses({"--scene", "droplet", "--velocity", "1", "-o", out}, "--velocity");
    check_program_refuses({"--scene", "tank", "--compensation", "2", "-o", out}, "--compensation");
    check_program_refuses({"--resume", "-o", out}, "checkpoint");
    const std::string scene = (folder / "scene.json").string();
    io::write_file(scene, R"({"bodies": [{"radius": 0}]})");
    check_program_refuses({scene, "-o", out}, "bodies[0].radius");
    check_program_refuses({scene, "--scene", "droplet", "-o", out}, "both");
    check_program_refuses({"--scene", "droplet", "--capillary-share", "4", "-o", out}, "--second-order");
}

TEST_CASE("a drop that is thrown at a wall stays in the domain, and keeps its volume", "[fluid]") {
    const TemporaryFolder folder;
    const std::string scene = (folder / "scene.json").string();
    const fs::path out = folder / "run";
    io::write_file(scene, R"({"edge_length": 0.5, "until": 1.5, "bodies": [{"velocity": [2, 0, 0]}]})");
    const ProgramResult result = run_program(DSC_FLUID_PROGRAM, {scene, "--quiet", "-o", out.string()});
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    const io::Json report = io::Json::parse(io::read_file(out / "report.json"));
    const auto volume = [&](std::size_t step) {
        double sum = 0;
        const io::Json& volumes = report["steps"][step]["volumes"];
        for (std::size_t i = 0; i < volumes.size(); ++i) sum += volumes[i].number();
        return sum;
    };
    CHECK(volume(report["steps"].size() - 1) == Approx(volume(0)).epsilon(0.01));
    const geometry::TetData mesh = io::read_tet_mesh(out / "final.mesh").data;
    double farthest = 0;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        if (mesh.labels[t] == 0) continue;
        for (const std::uint32_t v : mesh.tets[t]) {
            CHECK(mesh.vertices[v].cwiseAbs().maxCoeff() <= 2);
            farthest = std::max(farthest, mesh.vertices[v].x());
        }
    }
    CHECK(farthest == 2);
}
