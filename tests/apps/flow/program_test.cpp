// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "dsc3d/generate/blocks.h"
#include "io/atomic_file.h"
#include "io/json.h"
#include "io/surface_mesh.h"
#include "io/tet_mesh.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

using namespace dsc;
using namespace dsc::tests;

namespace {

void check_program_refuses(const std::vector<std::string>& arguments, const std::string& word) {
    const ProgramResult result = run_program(DSC_FLOW_PROGRAM, arguments);
    INFO(result.err);
    CHECK(result.exit_code == 2);
    CHECK(result.out.empty());
    CHECK(result.err_lines() == 1);
    CHECK_THAT(result.err, Catch::Contains(word));
}

}  // namespace

TEST_CASE("a run leaves the surface, the mesh, the series, the report and the page") {
    const TemporaryFolder folder;
    const std::string out = (folder / "turned").string();
    const ProgramResult result = run_program(DSC_FLOW_PROGRAM, {"labelled-block", "--edge-length", "0.1", "--motion",
                                                                "rotate", "--angle", "20", "--steps", "4", "-o", out});
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    CHECK(result.err.empty());
    CHECK_THAT(result.out, Catch::Contains("label 3: volume"));
    for (const char* name : {"final.obj", "final.mesh", "series.pvd", "series_0004.vtp", "report.json", "index.html"})
        CHECK(std::filesystem::exists(std::filesystem::path(out) / name));

    const io::Json report = io::Json::parse(io::read_file(out + "/report.json"));
    CHECK(report["end"].string() == "done");
    REQUIRE(report["steps"].size() == 5);
    const io::Json& last = report["steps"][4];
    CHECK(last["inverted"].integer() == 0);
    CHECK(last["labels"].size() == 4);
    CHECK(last["labels"][1]["volume"].number() == Approx(0.032).epsilon(1e-9));
    CHECK(last["unchanged_share"].number() == 1);
    CHECK(last["ms"]["deform"].number() >= 0);
    const geometry::TetData data = io::read_tet_mesh(out + "/final.mesh").data;
    CHECK(data.tets.size() == static_cast<std::size_t>(last["tets"].integer()));
    CHECK(io::read_surface_mesh(out + "/final.obj").triangles.size() ==
          static_cast<std::size_t>(last["interface_faces"].integer()));
}

TEST_CASE("bad input is refused in one line") {
    const TemporaryFolder folder;
    const std::string out = (folder / "out").string();
    check_program_refuses({"absent.off", "-o", out}, "absent.off");
    check_program_refuses({"sphere"}, "-o");
    check_program_refuses({"sphere", "--radius", "0.6", "--domain", "0,0,0,1,1,1", "-o", out}, "leaves the box");
    geometry::SurfaceData surface = dsc3d::box_surface({geometry::Point3(0, 0, 0), geometry::Point3(1, 1, 1)}, 0.5);
    surface.triangles.erase(surface.triangles.begin());
    const std::string open = (folder / "open.off").string();
    io::write_surface_mesh(open, surface);
    check_program_refuses({open, "-o", out}, "open edge");
    check_program_refuses({open, "--edge-length", "0", "-o", out}, "--edge-length");
    const std::string box = (folder / "box.off").string();
    io::write_surface_mesh(box, dsc3d::box_surface({geometry::Point3(0, 0, 0), geometry::Point3(1, 1, 1)}, 0.5));
    check_program_refuses({box, "--edge-length", "1e-7", "-o", out}, "edge_length");
    check_program_refuses({"sphere", "--domain", "-1e200,-1e200,-1e200,1e200,1e200,1e200", "-o", out}, "1e100");
    check_program_refuses({"sphere", "--radius", "1e-12", "-o", out}, "times as large");
}

TEST_CASE("going on from a result needs another folder, and an earlier series does not outlive a run without one") {
    const TemporaryFolder folder;
    const std::filesystem::path out = folder / "out";
    const std::vector<std::string> coarse = {
        "labelled-block", "--edge-length", "0.2", "--angle", "2", "--steps", "1", "-o", out.string() + "/"};
    REQUIRE(run_program(DSC_FLOW_PROGRAM, coarse).exit_code == 0);
    CHECK_THAT(io::read_file(out / "index.html"), Catch::Contains("<title>out"));
    const std::string before = io::read_file(out / "final.mesh");
    check_program_refuses({(out / "final.mesh").string(), "--angle", "2", "--steps", "1", "-o", out.string()},
                          "overwritten");
    CHECK(io::read_file(out / "final.mesh") == before);
    std::vector<std::string> without = coarse;
    without.insert(without.end(), {"--snapshots", "0"});
    REQUIRE(run_program(DSC_FLOW_PROGRAM, without).exit_code == 0);
    CHECK(!std::filesystem::exists(out / "series.pvd"));
    CHECK(!std::filesystem::exists(out / "index.html"));
    CHECK(std::filesystem::exists(out / "final.mesh"));
}

TEST_CASE("a velocity on a grid moves the interface, and a file without one is refused") {
    const TemporaryFolder folder;
    const std::string wind = (folder / "wind.vti").string(), out = (folder / "out").string();
    // 0.1 in x at the one layer below, 0.3 at the other: 0.2 halfway.
    io::write_file(
        wind,
        R"(<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian"><ImageData WholeExtent="0 0 0 0 0 1">
<Piece Extent="0 0 0 0 0 1"><PointData><DataArray type="Float64" Name="wind" NumberOfComponents="3" format="ascii">
0.1 0 0 0.3 0 0</DataArray></PointData></Piece></ImageData></VTKFile>)");
    const std::vector<std::string> run = {
        "labelled-block", "--edge-length", "0.1", "--motion", "grid", "--steps", "2", "--dimension", "3", "-o", out,
        "--velocity"};
    const auto with = [&](const std::string& file) {
        std::vector<std::string> arguments = run;
        arguments.push_back(file);
        return arguments;
    };
    REQUIRE(run_program(DSC_FLOW_PROGRAM, with(wind)).exit_code == 0);
    double least = 1, largest = 0;
    const geometry::SurfaceData surface = io::read_surface_mesh(out + "/final.obj");
    for (const geometry::Point3& p : surface.vertices) {
        // Where a vertex that is at x now, and has kept its height, was at the start: within the block of side 0.4.
        CHECK(std::abs(p.x() - 0.1 - 0.2 * p.z() - 0.5) < 0.2 + 1e-12);
        least = std::min(least, p.x());
        largest = std::max(largest, p.x());
    }
    CHECK(least == Approx(0.3 + 0.1 + 0.2 * 0.3).epsilon(1e-12));
    CHECK(largest == Approx(0.7 + 0.1 + 0.2 * 0.7).epsilon(1e-12));
    check_program_refuses(with((folder / "absent.vti").string()), "absent.vti");
    io::write_file(wind, "<VTKFile/>");
    check_program_refuses(with(wind), "wind.vti");
}
