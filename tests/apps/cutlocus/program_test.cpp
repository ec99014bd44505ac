// SPDX-License-Identifier: GPL-3.0-or-later
// What the program cutlocus writes when all is well.
#include <cmath>
#include <numbers>

#include "tests/apps/cutlocus/program.h"

using namespace dsc;
using namespace dsc::tests;

namespace {

using std::numbers::pi;
const std::string flat = "E=1;F=0;G=1";

/// Runs the program, which must succeed and say nothing on stderr; its stdout.
std::string run(const Arguments& arguments) {
    const ProgramResult result = cutlocus_program(arguments);
    INFO(result.err);
    CHECK(result.exit_code == 0);
    CHECK(result.err.empty());
    return result.out;
}

io::Json read_json(const std::filesystem::path& path) { return io::Json::parse(io::read_file(path), path.string()); }

const std::vector<std::string> columns{"u", "v", "distance", "theta", "theta2", "arc"};

}  // namespace

TEST_CASE("without any output the program prints a summary and draws a picture in the folder it runs in", "[slow]") {
    const TemporaryFolder folder;
    const ProgramResult result = run_program(
        "/bin/sh", {"-c", "cd \"$0\" && exec \"$@\"", folder.path().string(), DSC_CUTLOCUS_PROGRAM, "--metric", flat});
    CHECK(result.exit_code == 0);
    CHECK(result.err.empty());
    CHECK_THAT(result.out,
               Catch::Contains("certificate holds") && Catch::Contains("vertex 0") && Catch::Contains("arc "));
    CHECK(folder.content() == std::vector<std::string>{"cutlocus.svg"});
}

TEST_CASE("with -o it prints nothing and writes the CSV and JSON files as they are described", "[slow]") {
    const TemporaryFolder folder;
    const auto csv = folder / "a.csv", json = folder / "a.json";
    CHECK(run({"--metric", flat, "--point", "0.5,0.25pi", "-o", csv.string(), "--json", json.string()}).empty());
    CHECK(folder.content() == std::vector<std::string>{"a.csv", "a.json"});

    const io::CsvTable table = io::read_csv(csv);
    CHECK(table.columns == columns);
    const io::Json report = read_json(json);
    for (const char* key : {"metric",       "metric_params", "p",
                            "frame",        "betti1",        "components",
                            "n_vertices",   "n_arcs",        "area_injectivity_domain",
                            "area_surface", "area_rel_err",  "length",
                            "min_distance", "min_at",        "max_distance",
                            "max_at",       "points",        "seconds",
                            "vertices",     "arcs"}) {
        INFO(key);
        CHECK(report.has(key));
    }
    for (const io::Json& vertex : report["vertices"].elements())
        for (const char* key : {"id", "kind", "degree", "u", "v", "distance", "thetas", "conjugate", "residual"})
            CHECK(vertex.has(key));
    for (const io::Json& arc : report["arcs"].elements())
        for (const char* key : {"id", "start", "end", "lattice", "length", "announced"}) CHECK(arc.has(key));
    CHECK(report["contacts"].size() > 0);
    CHECK(report["certificate"]["holds"].boolean());
    CHECK(report["p"][0].number() == 0.5);
    CHECK(std::abs(report["p"][1].number() - pi / 4) < 1e-15);
    CHECK(report["n_vertices"].integer() == static_cast<std::int64_t>(report["vertices"].size()));
    CHECK(report["n_arcs"].integer() == static_cast<std::int64_t>(report["arcs"].size()));
    CHECK(report["points"].integer() == static_cast<std::int64_t>(table.rows.size()));
    for (const auto& row : table.rows) {
        CHECK((row[0] >= -pi && row[0] <= pi && row[1] >= -pi && row[1] <= pi));
        CHECK((row[5] >= 0 && row[5] < static_cast<double>(report["n_arcs"].integer())));
    }
}

TEST_CASE("the report of a built-in torus has the parameters that the comparison reads", "[slow]") {
    const TemporaryFolder folder;
    run({"--torus", "elliptic", "--lambda", "2", "-o", (folder / "a.csv").string(), "--json",
         (folder / "a.json").string()});
    const io::Json report = read_json(folder / "a.json");
    CHECK(report["metric_params"]["kind"].string() == "rev");
    CHECK(report["metric_params"]["R"].number() == 2);
    CHECK(report["metric_params"]["lam"].number() == 2);
}

TEST_CASE("a point outside the chart is the same point inside", "[slow]") {
    const TemporaryFolder folder;
    const auto a = folder / "a.json", b = folder / "b.json";
    run({"--torus", "circular", "--point", "0,0.2pi", "--json", a.string(), "-o", (folder / "a.csv").string()});
    run({"--torus", "circular", "--point", "4pi,-1.8pi", "--json", b.string(), "-o", (folder / "b.csv").string()});
    CHECK(std::abs(read_json(b)["p"][0].number()) < 1e-14);
    CHECK(std::abs(read_json(b)["p"][1].number() - 0.2 * pi) < 1e-14);
    CHECK(std::abs(read_json(a)["length"].number() - read_json(b)["length"].number()) < 1e-9);
}

TEST_CASE("a negative major radius is allowed with a note", "[slow]") {
    const TemporaryFolder folder;
    const auto a = folder / "a.json", b = folder / "b.json";
    Arguments arguments{"--torus", "circular", "--major-radius", "-2", "--point", "pi,-0.8pi", "--json", a.string()};
    const ProgramResult result = cutlocus_program(arguments);
    CHECK(result.exit_code == 0);
    CHECK(result.err_lines() == 1);
    CHECK_THAT(result.err, Catch::Contains("note: --major-radius -2") && Catch::Contains("shifted by half a period"));
    arguments.push_back("--quiet");
    run(arguments);
    run({"--torus", "circular", "--point", "0,0.2pi", "--json", b.string()});
    CHECK(std::abs(read_json(a)["length"].number() - read_json(b)["length"].number()) < 1e-9);
}

TEST_CASE("a batch writes two files per point, and --resume makes only those that are missing", "[slow]") {
    const TemporaryFolder folder;
    const auto points = folder / "points.txt", results = folder / "results";
    io::write_file(points, "# two points\n0, 0\n\n1,0.5pi\n");
    const Arguments arguments{"--metric", flat, "--points", points.string(), "-o", results.string()};
    run(arguments);
    for (const char* name : {"0001.csv", "0001.json", "0002.csv", "0002.json"}) {
        INFO(name);
        REQUIRE(std::filesystem::exists(results / name));
    }
    CHECK(read_json(results / "0002.json")["p"][0].number() == 1);
    CHECK(io::read_csv(results / "0001.csv").columns == columns);

    io::write_file(results / "0001.json", "kept");
    std::filesystem::remove(results / "0002.json");
    Arguments again = arguments;
    again.push_back("--resume");
    run(again);
    CHECK(io::read_file(results / "0001.json") == "kept");
    CHECK(read_json(results / "0002.json")["p"][0].number() == 1);
}

TEST_CASE("--distance gives the distance and the directions of all minimising geodesics", "[slow]") {
    const TemporaryFolder folder;
    const auto json = folder / "a.json";
    const auto ask = [&](const std::string& target) {
        const std::string summary = run({"--metric", flat, "--distance", target, "--json", json.string()});
        CHECK_THAT(summary, Catch::Contains("distance to"));
        return read_json(json)["distance_to"];
    };
    const io::Json inside = ask("1,-2");
    CHECK(std::abs(inside["distance"].number() - std::sqrt(5.0)) < 1e-9);
    REQUIRE(inside["thetas"].size() == 1);
    CHECK(std::abs(inside["thetas"][0].number() - std::atan2(-2, 1)) < 1e-9);
    const io::Json across = ask("pi,1");
    CHECK(std::abs(across["distance"].number() - std::hypot(pi, 1)) < 1e-9);
    CHECK(across["thetas"].size() == 2);
    CHECK(ask("pi,pi")["thetas"].size() == 4);
}

TEST_CASE("--method front writes where the front stopped", "[slow]") {
    const TemporaryFolder folder;
    const auto csv = folder / "a.csv", json = folder / "a.json";
    CHECK(run({"--torus", "circular", "--method", "front", "--time-step", "0.1", "-o", csv.string(), "--json",
               json.string()})
              .empty());
    const io::CsvTable table = io::read_csv(csv);
    CHECK(table.columns == columns);
    CHECK(table.rows.size() > 10);
    CHECK(read_json(json)["method"].string() == "front");
}

TEST_CASE("the pictures are written", "[slow]") {
    const TemporaryFolder folder;
    const auto svg = folder / "a.svg", html = folder / "a.html", fronts = folder / "fronts";
    run({"--torus", "circular", "-o", (folder / "a.csv").string(), "--svg", svg.string(), "--html", html.string(),
         "--fronts", fronts.string()});
    CHECK_THAT(io::read_file(svg), Catch::Contains("<svg"));
    CHECK_THAT(io::read_file(html), Catch::Contains("<html"));
    CHECK_FALSE(std::filesystem::is_empty(fronts));
}
