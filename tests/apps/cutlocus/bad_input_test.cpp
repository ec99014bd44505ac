// SPDX-License-Identifier: GPL-3.0-or-later
// Every bad input is refused with exit code 2 and one line that says what is wrong and where; nothing is overwritten.
#include "tests/apps/cutlocus/program.h"

using namespace dsc;
using namespace dsc::tests;

TEST_CASE("a surface that can't be is refused") {
    check_fails({}, 2, {"--torus"});
    check_fails({"--torus", "round"}, 2, {"--torus", "round"});
    check_fails({"--torus", "elliptic", "--lambda", "0"}, 2, {"--lambda"});
    check_fails({"--torus", "elliptic", "--lambda", "-1"}, 2, {"--lambda"});
    check_fails({"--torus", "elliptic", "--lambda", "nan"}, 2, {"--lambda"});
    check_fails({"--torus", "elliptic", "--lambda", "inf"}, 2, {"--lambda"});
    check_fails({"--torus", "circular", "--lambda", "2"}, 2, {"--lambda"});
    check_fails({"--torus", "circular", "--major-radius", "1"}, 2);
    check_fails({"--torus", "circular", "--major-radius", "0.5"}, 2);
    check_fails({"--torus", "circular", "--major-radius", "nan"}, 2, {"--major-radius"});
    check_fails({"--torus", "circular", "--metric", "E=1;F=0;G=1"}, 2, {"--torus", "--metric"});
    check_fails({"--embedding", "x=u;y=v;z=0", "--metric", "E=1;F=0;G=1"}, 2, {"--embedding", "--metric"});
    check_fails({"--metric", "E=1;F=0;G=1", "--lambda", "2"}, 2, {"--lambda"});
}

TEST_CASE("an expression that can't be read is refused with its column") {
    check_fails({"--metric", "E=1+;F=0;G=1"}, 2, {"--metric", "column"});
    check_fails({"--metric", "E=1;F=0;G=foo(u)"}, 2, {"--metric", "column 11"});
    check_fails({"--metric", "E=1;F=0;G=w"}, 2, {"column 11"});
    check_fails({"--metric", "E=1;F=0"}, 2, {"--metric"});
    check_fails({"--metric", "E=1;E=1;F=0;G=1"}, 2, {"--metric"});
    check_fails({"--metric", ""}, 2, {"--metric"});
    check_fails({"--embedding", "x=cos(u;y=v;z=0"}, 2, {"--embedding", "column"});
    check_fails({"--embedding", "x=1..2;y=v;z=0"}, 2, {"--embedding", "column"});
}

TEST_CASE("a metric that is none is refused with the place") {
    check_fails({"--metric", "E=1;F=2;G=1"}, 2, {"u = ", "v = ", "not positive definite"});
    check_fails({"--metric", "E=cos(u);F=0;G=1"}, 2, {"u = ", "not positive definite"});
    check_fails({"--metric", "E=-1;F=0;G=-1"}, 2, {"not positive definite"});
    check_fails({"--metric", "E=1/(cos(u)+cos(u)-2);F=0;G=1"}, 2, {"u = "});
    check_fails({"--metric", "E=1+0.1*sin(u/2);F=0;G=1"}, 2, {"u = ", "period", "in u"});
    check_fails({"--metric", "E=1;F=0;G=2+0.1*sin(v)", "--period", "2pi,3"}, 2, {"v = ", "period 3", "in v"});
    check_fails({"--embedding", "x=u;y=u;z=0*v"}, 2, {"u = ", "not positive definite"});
}

TEST_CASE("a number out of its range is refused") {
    const auto refused = [](const char* option, const char* value) {
        check_fails({"--torus", "elliptic", option, value}, 2, {option});
    };
    refused("--point", "nonsense");
    refused("--point", "1");
    refused("--point", "1,2,3");
    refused("--point", "nan,0");
    refused("--point", "inf,0");
    refused("--point", "");
    refused("--distance", "x,y");
    refused("--tolerance", "1e-12");
    refused("--tolerance", "0.1");
    refused("--tolerance", "-1e-9");
    refused("--tolerance", "nan");
    refused("--spacing", "0");
    refused("--spacing", "-1");
    refused("--spacing", "inf");
    refused("--front-spacing", "0");
    refused("--front-spacing", "0.2");
    refused("--max-distance", "0");
    refused("--max-distance", "nan");
    refused("--time-step", "0.05");  // without --method front
    refused("--method", "guess");
    check_fails({"--torus", "elliptic", "--method", "front", "--time-step", "0"}, 2, {"--time-step"});
    check_fails({"--torus", "elliptic", "--period", "1,1"}, 2, {"--period"});
    check_fails({"--metric", "E=1;F=0;G=1", "--period", "-1,1"}, 2, {"--period"});
    check_fails({"--metric", "E=1;F=0;G=1", "--period", "1"}, 2, {"--period"});
    check_fails({"--metric", "E=1;F=0;G=1", "--period", "0,0"}, 2, {"--max-distance"});
    check_fails({"--metric", "E=1;F=0;G=1", "--period", "2pi,0"}, 2, {"--max-distance"});
}

TEST_CASE("outputs that can't be written are refused before anything is overwritten") {
    const TemporaryFolder folder;
    const std::string old = (folder / "old.csv").string(), nowhere = (folder / "no" / "such.json").string();
    io::write_file(old, "old");
    for (const char* option : {"-o", "--json", "--svg", "--html"})
        check_fails({"--torus", "circular", option, nowhere}, 2);
    check_fails({"--torus", "circular", "-o", old, "--json", nowhere}, 2);
    check_fails({"--torus", "circular", "-o", folder.path().string()}, 2);
    check_fails({"--torus", "circular", "-o", old, "--json", old}, 2);
    CHECK(io::read_file(old) == "old");
    CHECK(folder.content() == std::vector<std::string>{"old.csv"});
}

TEST_CASE("a failing run leaves its outputs as they were") {
    const TemporaryFolder folder;
    const std::string csv = (folder / "a.csv").string(), json = (folder / "a.json").string();
    io::write_file(csv, "old");
    io::write_file(json, "older");
    for (const Arguments& wrong : {Arguments{"--torus", "elliptic", "--lambda", "-1"},
                                   Arguments{"--metric", "E=cos(u);F=0;G=1"}, Arguments{"--metric", "E=1"}}) {
        Arguments arguments = wrong;
        arguments.insert(arguments.end(), {"-o", csv, "--json", json});
        check_fails(arguments, 2);
        CHECK(io::read_file(csv) == "old");
        CHECK(io::read_file(json) == "older");
    }
    CHECK(folder.content().size() == 2);
}

TEST_CASE("a batch with a bad line is refused with the line's number, and nothing is written") {
    const TemporaryFolder folder;
    const std::string points = (folder / "points.txt").string(), results = (folder / "results").string();
    const auto refused = [&](const std::string& text, const std::vector<std::string>& words) {
        io::write_file(points, text);
        check_fails({"--torus", "circular", "--points", points, "-o", results}, 2, words);
        CHECK((!std::filesystem::exists(results) || std::filesystem::is_empty(results)));
    };
    refused("0,0\n# a remark\n\n0,x\n", {"points.txt", "line 4"});
    refused("0,0\n1\n", {"points.txt", "line 2"});
    refused("0,nan\n", {"points.txt", "line 1"});
    refused("", {"points.txt"});
    io::write_file(points, "0,0\n");
    check_fails({"--torus", "circular", "--points", points}, 2, {"-o"});
    check_fails({"--torus", "circular", "--points", points, "--point", "0,0", "-o", results}, 2, {"--point"});
    check_fails({"--torus", "circular", "--points", (folder / "absent").string(), "-o", results}, 2, {"absent"});
    check_fails({"--torus", "circular", "--resume"}, 2, {"--resume"});
}

TEST_CASE("an interrupted run ends with 1, one line and no output") {
    const TemporaryFolder folder;
    const std::string old = (folder / "old.csv").string(), json = (folder / "new.json").string();
    io::write_file(old, "old");
    const ProgramResult result = run_program(
        "/usr/bin/timeout", {"--foreground", "--preserve-status", "-s", "INT", "1", DSC_CUTLOCUS_PROGRAM, "--torus",
                             "elliptic", "--front-spacing", "0.0005", "-o", old, "--json", json});
    CHECK(result.exit_code == 1);
    CHECK(result.err == "cutlocus: cancelled\n");
    CHECK(result.out.empty());
    CHECK(io::read_file(old) == "old");
    CHECK(folder.content() == std::vector<std::string>{"old.csv"});
}
