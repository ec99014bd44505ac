// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "io/atomic_file.h"
#include "io/json.h"
#include "io/planar_mesh.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

using namespace dsc;
using namespace dsc::tests;

namespace {

ProgramResult run_flow(const std::vector<std::string>& arguments, const std::string& folder) {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), {"--dimension", "2", "-o", folder});
    return run_program(DSC_FLOW_PROGRAM, all);
}

void check_fails(const std::vector<std::string>& arguments, const std::string& folder, int code,
                 const std::string& word) {
    CAPTURE(arguments);
    const ProgramResult result = run_flow(arguments, folder);
    INFO(result.err);
    CHECK(result.exit_code == code);
    CHECK(result.err_lines() == 1);
    CHECK_THAT(result.err, Catch::Contains(word));
}

}  // namespace

TEST_CASE("a run in the plane leaves curves, mesh, series, report and page, from which another one goes on") {
    const TemporaryFolder folder;
    const std::string out = (folder / "turned").string();
    const ProgramResult result = run_flow({"labelled-block", "--angle", "20", "--steps", "4"}, out);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    CHECK(result.err.empty());
    CHECK_THAT(result.out, Catch::Contains("label 3: area"));
    for (const char* name : {"final.obj", "final.mesh", "series.pvd", "series_0004.vtp", "report.json", "index.html"})
        CHECK(std::filesystem::exists(std::filesystem::path(out) / name));
    const io::Json report = io::Json::parse(io::read_file(out + "/report.json"));
    CHECK(report["end"].string() == "done");
    CHECK(report["dimension"].integer() == 2);
    REQUIRE(report["steps"].size() == 5);
    const io::Json& last = report["steps"][4];
    CHECK(last["inverted"].integer() == 0);
    CHECK(last["labels"].size() == 4);
    CHECK(last["labels"][1]["area"].number() == Approx(0.08).epsilon(1e-9));
    CHECK(last["unchanged_share"].number() == 1);
    CHECK(last["ms"]["deform"].number() >= 0);
    CHECK(io::read_planar_mesh(out + "/final.mesh").triangles.size() ==
          static_cast<std::size_t>(last["triangles"].integer()));
    const std::string curves = io::read_file(out + "/final.obj");
    CHECK(std::ranges::count(curves, 'l') == 6);
    CHECK_THAT(io::read_file(out + "/index.html"), Catch::Contains("<title>turned"));

    check_fails({out + "/final.mesh", "--angle", "-20", "--steps", "4"}, out, 2, "overwritten");
    const std::string back = (folder / "back").string();
    REQUIRE(run_flow({out + "/final.mesh", "--angle", "-20", "--steps", "4", "--snapshots", "0"}, back).exit_code == 0);
    CHECK_FALSE(std::filesystem::exists(back + "/series.pvd"));
    const io::Json second = io::Json::parse(io::read_file(back + "/report.json"));
    CHECK(second["steps"][4]["labels"][1]["area"].number() == Approx(0.08).epsilon(1e-9));
}

TEST_CASE("on a torus, curves and triangles at the seam are written in one piece") {
    const TemporaryFolder folder;
    const std::string out = (folder / "out").string();
    REQUIRE(run_flow({"disc", "--torus", "--motion", "translate", "--velocity", "0.4,0.3", "--steps", "10"}, out)
                .exit_code == 0);
    const geometry::SurfaceData data = io::read_planar_mesh(out + "/final.mesh");
    double area = 0;
    for (const auto& [a, b, c] : data.triangles) {
        const Eigen::Vector3d u = data.vertices[b] - data.vertices[a], w = data.vertices[c] - data.vertices[a];
        const double twice = u.x() * w.y() - u.y() * w.x();
        CHECK(twice > 0);
        area += twice / 2;
    }
    CHECK(area == Approx(1).epsilon(1e-12));
}

TEST_CASE("bad input in the plane is told in one line") {
    const TemporaryFolder folder;
    const std::string out = (folder / "out").string();
    const auto file = [&](const std::string& name, const std::string& text) {
        io::write_file(folder / name, text);
        return (folder / name).string();
    };
    check_fails({file("open.svg", "<svg><path d='M0 0L1 0L1 1'/></svg>")}, out, 2, "open");
    check_fails({file("bow.csv", "0,0\n1,1\n1,0\n0,1\n")}, out, 2, "(0.5, 0.5)");
    check_fails({"absent.csv"}, out, 2, "absent.csv");
    check_fails({"disc", "--edge-length", "0"}, out, 2, "--edge-length");
    check_fails({"disc", "--radius", "0.6", "--domain", "0,0,1,1"}, out, 2, "leaves the box");
    check_fails({"disc", "--motion", "expression", "--velocity", "(y"}, out, 2, "--velocity");
    check_fails({"disc", "--motion", "expression", "--velocity", "(0/(x-x), 0)"}, out, 1, "not finite");
    check_fails({"disc", "--motion", "translate", "--velocity", "1,0"}, out, 1, "out of the box");
    CHECK(std::filesystem::exists(out + "/final.mesh"));
}
