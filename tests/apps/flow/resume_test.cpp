// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/apps/flow/killed_runs.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::tests;

namespace fs = std::filesystem;

TEST_CASE("a run that is killed goes on bit for bit, through a merger too") {
    core::Random random(seed(41));
    check_killed({"two-spheres", "--edge-length", "0.07", "--gap", "0.03", "--motion", "offset", "--distance", "0.05",
                  "--topology", "adaptive", "--checkpoint", "3"},
                 20, 4, random);
}

TEST_CASE("... in other motions, killed at twenty random moments", "[slow]") {
    core::Random random(seed(42));
    const Arguments start = {"sphere", "--radius", "0.2", "--edge-length", "0.07", "--checkpoint", "4"};
    const std::vector<Arguments> motions = {{"--motion", "rotate"},
                                            {"--motion", "curvature", "--until", "0.005"},
                                            {"--motion", "vortex", "--until", "0.3"},
                                            {"--motion", "expression", "--velocity", "(-y, x, t)", "--until", "0.1"}};
    for (const Arguments& motion : motions) {
        CAPTURE(motion);
        Arguments arguments = start;
        arguments.insert(arguments.end(), motion.begin(), motion.end());
        check_killed(arguments, 40, 5, random);
    }
}

TEST_CASE("--resume takes the options of the checkpoint and refuses others, or a checkpoint that is damaged") {
    const TemporaryFolder folder;
    const fs::path out = folder / "run";
    const Arguments coarse = {"labelled-block", "--edge-length", "0.2", "--angle", "2", "--steps", "2"};
    check_refused(into(out, {"--resume"}), "there is no checkpoint");
    REQUIRE(run_program(DSC_FLOW_PROGRAM, into(out, coarse)).exit_code == 0);

    check_refused(into(out, {"--resume", "--steps", "3"}), "--steps: was 2");
    check_refused(into(out, {"sphere", "--resume"}), "SHAPE: was labelled-block");
    check_refused(into(out, {"--resume", "--seed", "2"}), "--seed: was not given");
    check_refused(into(out, {"--resume", "--dimension", "2"}), "--dimension: was not given");
    Arguments again = into(out, coarse);
    again.push_back("--resume");
    for (const char* unfinished : {".final.obj.1-0.part", ".probe.1-0.part"})
        io::write_file(out / unfinished, "v 0 0 ");
    CHECK(run_program(DSC_FLOW_PROGRAM, again).exit_code == 0);
    for (const char* unfinished : {".final.obj.1-0.part", ".probe.1-0.part"}) CHECK_FALSE(fs::exists(out / unfinished));

    std::string bytes = io::read_file(out / "checkpoint");
    io::write_file(out / "checkpoint", bytes.substr(0, bytes.size() / 2));
    check_refused(into(out, {"--resume"}), "damaged or cut off");
    bytes[bytes.size() / 3] ^= 1;
    io::write_file(out / "checkpoint", bytes);
    check_refused(into(out, {"--resume"}), "damaged or cut off");
}

TEST_CASE("a run without checkpoints leaves none of an earlier one") {
    const TemporaryFolder folder;
    const fs::path out = folder / "run";
    const Arguments coarse = {"labelled-block", "--edge-length", "0.2", "--angle", "2", "--steps", "1"};
    REQUIRE(run_program(DSC_FLOW_PROGRAM, into(out, coarse)).exit_code == 0);
    REQUIRE(fs::exists(out / "checkpoint"));
    Arguments without = coarse;
    without.insert(without.end(), {"--checkpoint", "0"});
    REQUIRE(run_program(DSC_FLOW_PROGRAM, into(out, without)).exit_code == 0);
    CHECK_FALSE(fs::exists(out / "checkpoint"));
    REQUIRE(run_program(DSC_FLOW_PROGRAM, into(out, coarse)).exit_code == 0);
    const Arguments disc = {"disc", "--dimension", "2", "--steps", "1", "--checkpoint", "0"};
    REQUIRE(run_program(DSC_FLOW_PROGRAM, into(out, disc)).exit_code == 0);
    CHECK_FALSE(fs::exists(out / "checkpoint"));
}
