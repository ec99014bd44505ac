// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/common/command_line.h"

#include <catch2/catch.hpp>

#include "core/errors.h"
#include "tests/support/temporary_folder.h"

using namespace dsc;
using apps::CommandLine;

namespace {

// The command line of a program with one option of every kind.
struct Options {
    double lambda = 1;
    std::optional<double> spacing;
    std::optional<std::array<double, 2>> point;
    int steps = 10;
    std::string torus = "circular";
    std::optional<std::string> metric;
    bool is_exact = false;
    std::optional<std::string> points;
    std::optional<std::string> fronts;
    apps::CommonOptions common;
    io::Json given;

    explicit Options(std::vector<const char*> arguments, const apps::CommonHelp& help = {}) {
        CommandLine line("test", "Test", "test --lambda 2", help);
        line.number("--lambda", lambda, "height", {.above = 0});
        line.number("--spacing", spacing, "spacing");
        line.pair("--point", point, "place");
        line.integer("--steps", steps, "steps", {.at_least = 1, .at_most = 100});
        line.choice("--torus", torus, {"circular", "elliptic"}, "surface");
        line.text("--metric", metric, "metric");
        line.flag("--exact", is_exact, "exact");
        line.input_file("--points", points, "points");
        line.output_folder("--fronts", fronts, "fronts");
        line.alternatives({"--torus", "--metric"}, false);
        arguments.insert(arguments.begin(), "test");
        if (!line.parse(static_cast<int>(arguments.size()), arguments.data())) return;
        common = line.common();
        given = line.given();
    }
};

}  // namespace

TEST_CASE("options are what was given, or their defaults") {
    const Options defaults({});
    CHECK(defaults.lambda == 1);
    CHECK_FALSE(defaults.spacing);
    CHECK(defaults.common.seed == 1);
    CHECK(defaults.given.size() == 0);

    const Options options({"--lambda", "2.5e-1", "--point", "-1,0.5", "--steps=7", "--torus", "elliptic", "--exact",
                           "--seed", "9223372036854775807", "--threads", "2", "--quiet"});
    CHECK(options.lambda == 0.25);
    CHECK(*options.point == std::array<double, 2>{-1, 0.5});
    CHECK(options.steps == 7);
    CHECK(options.torus == "elliptic");
    CHECK(options.is_exact);
    CHECK(options.common.seed == 9223372036854775807);
    CHECK(options.common.threads == 2);
    CHECK(options.common.progress == apps::ProgressMode::none);
    CHECK(options.given["--point"].string() == "-1,0.5");
    CHECK(options.given["--exact"].boolean());
}

TEST_CASE("wrong values are refused with the name of their option") {
    const std::vector<std::vector<const char*>> wrong{
        {"--lambda", "nan"},        {"--lambda", "inf"},   {"--lambda", "-inf"}, {"--lambda", "0"},
        {"--lambda", "-1"},         {"--lambda", "1e400"}, {"--lambda", "two"},  {"--lambda", ""},
        {"--spacing", "nan"},       {"--point", "1"},      {"--point", "1,nan"}, {"--point", "1,2,3"},
        {"--point", "a,b"},         {"--steps", "0"},      {"--steps", "101"},   {"--steps", "1.5"},
        {"--steps", "99999999999"}, {"--torus", "round"},  {"--seed", "x"},      {"--fronts", ""}};
    for (const auto& arguments : wrong) {
        INFO(arguments[0] << ' ' << arguments[1]);
        CHECK_THROWS_AS(Options(arguments), core::UsageError);
        CHECK_THROWS_WITH(Options(arguments), Catch::StartsWith(arguments[0]));
    }
    CHECK_THROWS_WITH(Options({"--lambda", "1", "--lambda", "2"}), "--lambda is given twice");
    CHECK_THROWS_AS(Options({"--torus", "elliptic", "--metric", "E=1"}), core::UsageError);
}

TEST_CASE("outputs are probed before anything runs") {
    const tests::TemporaryFolder folder;
    const std::string a = (folder / "a").string();
    const std::string same = (folder / "./a").string();
    CHECK_THROWS_AS(Options({"-o", a.c_str(), "--json", same.c_str()}), core::UsageError);
    CHECK_THROWS_AS(Options({"-o", "/no/such/a"}), core::InputError);
    const std::string fronts = (folder / "fronts").string();
    CHECK_THROWS_AS(Options({"--fronts", fronts.c_str(), "-o", "/no/such/a"}), core::InputError);
    CHECK(folder.content().empty());
    CHECK_NOTHROW(Options({"-o", a.c_str(), "--fronts", fronts.c_str()}));
    CHECK(folder.content() == std::vector<std::string>{"fronts"});
}

TEST_CASE("an input is never replaced, except where that is meant") {
    const tests::TemporaryFolder folder;
    const std::string input = (folder / "a.xyz").string();
    const std::string same = (folder / "./a.xyz").string();
    const std::string other = (folder / "b.xyz").string();
    CHECK_THROWS_WITH(Options({"--points", input.c_str(), "-o", same.c_str()}),
                      Catch::StartsWith("--output would replace the input"));
    CHECK_THROWS_WITH(Options({"--json", same.c_str(), "--points", input.c_str()}),
                      Catch::StartsWith("--json would replace the input"));
    CHECK_NOTHROW(Options({"--points", input.c_str(), "-o", other.c_str()}));
    CHECK_NOTHROW(Options({"--points", input.c_str(), "-o", same.c_str()}, {.may_replace_input = true}));
    CHECK_THROWS_AS(Options({"--points", input.c_str(), "--json", same.c_str()}, {.may_replace_input = true}),
                    core::UsageError);
}
