// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of the program flow that are killed and resumed, in space and in the plane, against those that were not.
#pragma once

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
#include "tests/support/temporary_folder.h"

namespace dsc::tests {

using Arguments = std::vector<std::string>;

inline Arguments into(const std::filesystem::path& folder, Arguments arguments) {
    arguments.insert(arguments.end(), {"--quiet", "-o", folder.string()});
    return arguments;
}

/// The program refuses them in one line that has these words.
inline void check_refused(const Arguments& arguments, const std::string& words) {
    CAPTURE(arguments);
    const ProgramResult result = run_program(DSC_FLOW_PROGRAM, arguments);
    INFO(result.err);
    CHECK(result.exit_code == 2);
    CHECK(result.err_lines() == 1);
    CHECK_THAT(result.err, Catch::Contains(words));
}

/// report.json without the folder and what differs from run to run.
inline std::string timeless_report(const std::filesystem::path& folder) {
    io::Json report = io::Json::parse(io::read_file(folder / "report.json"));
    report["seconds"] = 0;
    report["options"]["--output"] = "";
    for (std::size_t i = 0; i < report["steps"].size(); ++i) report["steps"][i]["ms"] = 0;
    return report.dump();
}

/// All files but the checkpoints are the same byte by byte.
inline void check_same_results(const std::filesystem::path& folder, const std::filesystem::path& expected) {
    const auto names = [](const std::filesystem::path& of) {
        std::vector<std::string> found;
        for (const auto& entry : std::filesystem::directory_iterator(of)) found.push_back(entry.path().filename());
        std::ranges::sort(found);
        return found;
    };
    CHECK(names(folder) == names(expected));
    for (const std::string& name : names(expected)) {
        if (name == "checkpoint" || name == "report.json") continue;
        CAPTURE(name);
        CHECK((io::read_file(folder / name) == io::read_file(expected / name)));
    }
    CHECK((timeless_report(folder) == timeless_report(expected)));
}

/// Kills the run in each `kills`th part of its steps, at a random moment, and goes on from there each time.
inline void check_killed(Arguments arguments, std::uint64_t steps, std::uint64_t kills, core::Random& random) {
    const TemporaryFolder folder;
    const std::filesystem::path undisturbed = folder / "a" / "run", killed = folder / "b" / "run";
    std::filesystem::create_directory(folder / "a");
    std::filesystem::create_directory(folder / "b");
    arguments.insert(arguments.end(), {"--steps", std::to_string(steps), "--snapshots", std::to_string(steps + 1)});
    REQUIRE(run_program(DSC_FLOW_PROGRAM, into(undisturbed, arguments)).exit_code == 0);
    const auto snapshot_file = [&](std::uint64_t number) {
        const std::string digits = std::to_string(number);
        return killed / ("series_" + std::string(4 - digits.size(), '0') + digits + ".vtp");
    };
    const auto command = [&] {
        return std::filesystem::exists(killed / "checkpoint") ? into(killed, {"--resume"}) : into(killed, arguments);
    };
    int killed_count = 0;
    for (std::uint64_t i = 0; i < kills; ++i) {
        const std::filesystem::path sign = snapshot_file(steps * i / kills + random.below(steps / kills));
        const double pause = random.uniform(0, 0.01);
        std::optional<core::Stopwatch> since_sign;
        const int code = run_program_killed(DSC_FLOW_PROGRAM, command(), [&] {
            if (!since_sign && std::filesystem::exists(sign)) since_sign.emplace();
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

}  // namespace dsc::tests
