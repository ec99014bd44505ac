// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/apps/flow/killed_runs.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::tests;

namespace fs = std::filesystem;

namespace {

Arguments in_the_plane(Arguments arguments) {
    arguments.insert(arguments.end(), {"--dimension", "2", "--checkpoint", "3"});
    return arguments;
}

}  // namespace

TEST_CASE("a run in the plane that is killed goes on bit for bit, through a merger too") {
    core::Random random(seed(43));
    check_killed(in_the_plane({"two-discs", "--motion", "offset", "--distance", "0.03", "--topology", "adaptive"}), 30,
                 4, random);
}

TEST_CASE("a run in the plane goes on in other motions, killed at twenty random moments", "[slow]") {
    core::Random random(seed(44));
    const std::vector<Arguments> runs = {
        {"slotted-disc", "--motion", "rotate"},
        {"slotted-disc", "--torus", "--motion", "translate", "--velocity", "5.3,-0.7"},
        {"two-discs", "--motion", "offset", "--distance", "0.03", "--topology", "preserved"},
        {"labelled-block", "--motion", "curl-noise", "--speed", "0.4", "--topology", "adaptive"}};
    for (const Arguments& run : runs) {
        CAPTURE(run);
        check_killed(in_the_plane(run), 60, 5, random);
    }
}

TEST_CASE("--resume takes the dimension of the checkpoint, and refuses another one or a damaged file") {
    const TemporaryFolder folder;
    const fs::path out = folder / "run";
    const Arguments disc = in_the_plane({"disc", "--angle", "5", "--steps", "4"});
    check_refused(into(out, {"--dimension", "2", "--resume"}), "there is no checkpoint");
    REQUIRE(run_program(DSC_FLOW_PROGRAM, into(out, disc)).exit_code == 0);
    for (const Arguments& again : {Arguments{"--resume"}, Arguments{"--dimension", "2", "--resume"}})
        CHECK(run_program(DSC_FLOW_PROGRAM, into(out, again)).exit_code == 0);
    check_refused(into(out, {"--resume", "--dimension", "3"}), "--dimension: was 2");
    check_refused(into(out, {"--resume", "--torus"}), "--torus: was not given");

    std::string bytes = io::read_file(out / "checkpoint");
    bytes[bytes.size() / 2] ^= 4;
    io::write_file(out / "checkpoint", bytes);
    check_refused(into(out, {"--resume"}), "damaged or cut off");
}
