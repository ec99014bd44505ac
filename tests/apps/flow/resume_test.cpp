// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/random.h"
#include "core/stopwatch.h"
#include "io/atomic_file.h"
#include "io/json.h"
#include "tests/support/run_program.h"
#include "tests/support/seed.h"
#include "tests/support/temporary_folder.h"

using namespace dsc;
using namespace dsc::tests;

namespace fs = std::filesystem;

namespace {

using Arguments = std::vector<std::string>;

Arguments into(const fs::path& folder, Arguments arguments) {
    arguments.insert(arguments.end(), {"--quiet", "-o", folder.string()});
    return arguments;
}

// The report without the folder and what differs from run to run.
std::string timeless_report(const fs::path& folder) {
    io::Json report = io::Json::parse(io::read_file(folder / "report.json"));
    report["seconds"] = 0;
    report["options"]["--output"] = "";
    for (std::size_t i = 0; i < report["steps"].size(); ++i) report["steps"][i]["ms"] = 0;
    return report.dump();
}

void check_same_results(const fs::path& folder, const fs::path& expected) {
    std::vector<std::string> names, expected_names;
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
    for (const auto& entry : fs::directory_iterator(expected)) expected_names.push_back(entry.path().filename());
    std::ranges::sort(names);
    std::ranges::sort(expected_names);
    CHECK(names == expected_names);
    for (const std::string& name : expected_names) {
        if (name == "checkpoint" || name == "report.json") continue;
        CAPTURE(name);
        CHECK((io::read_file(folder / name) == io::read_file(expected / name)));
    }
    CHECK((timeless_report(folder) == timeless_report(expected)));
}

void check_refused(const Arguments& arguments, const std::string& word) {
    CAPTURE(arguments);
    const ProgramResult result = run_program(DSC_FLOW_PROGRAM, arguments);
    INFO(result.err);
    CHECK(result.exit_code == 2);
    CHECK(result.err_lines() == 1);
    CHECK_THAT(result.err, Catch::Contains(word));
}

fs::path snapshot_file(const fs::path& folder, std::uint64_t number) {
    const std::string digits = std::to_string(number);
    return folder / ("series_" + std::string(4 - digits.size(), '0') + digits + ".vtp");
}

// Kills the run in each `kills`th part of its steps, at a random moment, and goes on from there each time.
void check_killed(Arguments arguments, std::uint64_t steps, std::uint64_t kills, core::Random& random) {
    const TemporaryFolder folder;
    const fs::path undisturbed = folder / "a" / "run", killed = folder / "b" / "run";
    fs::create_directory(folder / "a");
    fs::create_directory(folder / "b");
    arguments.insert(arguments.end(), {"--steps", std::to_string(steps), "--snapshots", std::to_string(steps + 1)});
    REQUIRE(run_program(DSC_FLOW_PROGRAM, into(undisturbed, arguments)).exit_code == 0);
    int killed_count = 0;
    const auto command = [&] {
        return fs::exists(killed / "checkpoint") ? into(killed, {"--resume"}) : into(killed, arguments);
    };
    for (std::uint64_t i = 0; i < kills; ++i) {
        const fs::path sign = snapshot_file(killed, steps * i / kills + random.below(steps / kills));
        const double pause = random.uniform(0, 0.01);
        std::optional<core::Stopwatch> since_sign;
        const int code = run_program_killed(DSC_FLOW_PROGRAM, command(), [&] {
            if (!since_sign && fs::exists(sign)) since_sign.emplace();
            return since_sign && since_sign->seconds() >= pause;
        });
        CHECK((code == 0 || code == 128 + 9));
        killed_count += code == 0 ? 0 : 1;
    }
    CHECK(killed_count > 0);
    const ProgramResult last = run_program(DSC_FLOW_PROGRAM, command());
    INFO(last.err);
    REQUIRE(last.exit_code == 0);
    check_same_results(killed, undisturbed);
}

}  // namespace

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
    check_refused(into(out, {"--resume", "--dimension", "2"}), "--dimension 2");
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
    REQUIRE(run_program(DSC_FLOW_PROGRAM, into(out, {"disc", "--dimension", "2", "--steps", "1"})).exit_code == 0);
    CHECK_FALSE(fs::exists(out / "checkpoint"));
}
