// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "core/version.h"
#include "io/atomic_file.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

using dsc::tests::ProgramResult;

namespace {

ProgramResult probe(const std::vector<std::string>& arguments, const std::string& interrupt_at = {}) {
    return dsc::tests::run_program(DSC_PROBE_PROGRAM, arguments, interrupt_at);
}

}  // namespace

TEST_CASE("a program that is done returns 0 and prints its result only") {
    const ProgramResult result = probe({});
    CHECK(result.exit_code == 0);
    CHECK(result.out == "result\n");
    CHECK(result.err.empty());
}

TEST_CASE("every failure is one line on stderr and its exit code") {
    const auto check = [](const char* how, int code, const char* message) {
        INFO(how);
        const ProgramResult result = probe({"--end", how});
        CHECK(result.exit_code == code);
        CHECK(result.err == std::string("probe: ") + message + "\n");
        CHECK(result.out.empty());
    };
    check("usage", 2, "--x: wrong");
    check("input", 2, "file.csv: line 3: is wrong; mend it");
    check("run", 1, "did not converge in 10 steps");
    check("memory", 1, "out of memory");
    check("internal", 1, "internal error: surprise");
}

TEST_CASE("a wrong command line is one line and 2") {
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{{"--unknown"},
                                                                                           {"stray"},
                                                                                           {"--end"},
                                                                                           {"--end", "x"},
                                                                                           {"--seed", "1.5"},
                                                                                           {"--seed", "-1"},
                                                                                           {"--threads", "-2"},
                                                                                           {"--progress", "loud"},
                                                                                           {"-o", ""},
                                                                                           {"-o", "/no/such/folder/x"},
                                                                                           {"--json", "/"}}) {
        INFO(arguments.front());
        const ProgramResult result = probe(arguments);
        CHECK(result.exit_code == 2);
        CHECK(result.err_lines() == 1);
        CHECK(result.err.rfind("probe: ", 0) == 0);
        CHECK(result.out.empty());
    }
}

TEST_CASE("an interrupted program ends with 1 and writes nothing") {
    const dsc::tests::TemporaryFolder folder;
    dsc::io::write_file(folder / "a", "old");
    const ProgramResult result = probe({"--end", "wait", "-o", (folder / "a").string()}, "ready");
    CHECK(result.exit_code == 1);
    CHECK(result.err == "probe: cancelled\n");
    CHECK(dsc::io::read_file(folder / "a") == "old");
    CHECK(folder.content().size() == 1);
}

TEST_CASE("a failing program leaves its output as it was") {
    const dsc::tests::TemporaryFolder folder;
    dsc::io::write_file(folder / "a", "old");
    CHECK(probe({"--end", "run", "-o", (folder / "a").string()}).exit_code == 1);
    CHECK(dsc::io::read_file(folder / "a") == "old");
    CHECK(probe({"-o", (folder / "a").string()}).exit_code == 0);
    CHECK(dsc::io::read_file(folder / "a") == "result");
}

TEST_CASE("help has an example and the exit codes, version is the project's") {
    const ProgramResult help = probe({"--help"});
    CHECK(help.exit_code == 0);
    CHECK_THAT(help.out, Catch::Contains("Example:\n  probe --end run") && Catch::Contains("--threads"));
    const ProgramResult version = probe({"--version"});
    CHECK(version.exit_code == 0);
    CHECK(version.out == std::string("probe ") + dsc::core::version() + "\n");
}

TEST_CASE("progress is shown when asked for, and never with --quiet") {
    CHECK_THAT(probe({"--progress", "bar"}).err, Catch::Contains("working 50 %, half"));
    CHECK(probe({"--progress", "bar", "--quiet"}).err.empty());
    CHECK(probe({"--progress", "none"}).err.empty());
}
