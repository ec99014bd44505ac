// SPDX-License-Identifier: GPL-3.0-or-later
// How a run of the program improve ends before it has converged: the mesh so far is written, and the end is named.
#include "apps/improve/mesh_statistics.h"
#include "dsc3d/mesh.h"
#include "tests/apps/improve/box_mesh.h"
#include "tests/apps/improve/program.h"

using namespace dsc;
using namespace dsc::tests;

namespace {

double worst_biased_sine(const geometry::TetData& data) {
    return improve::mesh_statistics(data, geometry::QualityMeasure::minimum_biased_sine).worst_quality;
}

}  // namespace

TEST_CASE("a target or a time limit that ends the run is named, and the run is done") {
    const TemporaryFolder folder;
    const std::string json = (folder / "a.json").string();
    const std::string easy = write_mesh(folder, "easy.mesh", shaken_box(4, 0.3));
    improve_output({easy, "--json", json, "--target-angle", "5"});
    CHECK(read_json(json)["end"].string() == "target-angle");
    CHECK(read_json(json)["after"]["min_dihedral"].number() >= 5);
    CHECK(read_json(json)["after"]["max_dihedral"].number() <= 175);

    const std::string large = write_mesh(folder, "large.mesh", shaken_box(16));
    improve_output({large, "--json", json, "--time-limit", "0.01"});
    CHECK(read_json(json)["end"].string() == "time-limit");
    CHECK(read_json(json)["after"]["worst_quality"].number() >= read_json(json)["before"]["worst_quality"].number());
}

TEST_CASE("an interrupted run writes the mesh so far and ends with 1 and one line", "[slow]") {
    const TemporaryFolder folder;
    const geometry::TetData before = shaken_box(24);
    const std::string input = write_mesh(folder, "in.vtu", before), output = (folder / "out.vtu").string();
    const ProgramResult result =
        run_program("/usr/bin/timeout", {"--foreground", "--preserve-status", "-s", "INT", "1", DSC_IMPROVE_PROGRAM,
                                         input, "-o", output, "--schedule", "best"});
    CHECK(result.exit_code == 1);
    CHECK(result.err == "improve: stopped by the user; " + output + " has the mesh so far\n");
    CHECK_THAT(result.out, Catch::Contains("stopped by the user"));
    const geometry::TetData after = io::read_tet_mesh(output).data;
    CHECK(validate(dsc3d::Mesh(after)).empty());
    CHECK(worst_biased_sine(after) >= worst_biased_sine(before));
}
