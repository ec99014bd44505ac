// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/improve/report.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <iterator>
#include <sstream>

#include "tests/apps/improve/samples.h"

using namespace dsc;
using namespace dsc::improve;

namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::vector<std::string> words_of(const std::string& line) {
    std::istringstream stream(line);
    return {std::istream_iterator<std::string>(stream), {}};
}

// The words of the line that begins with `name`.
std::vector<std::string> row(const std::string& text, const std::string& name) {
    for (const std::string& line : lines_of(text)) {
        const std::size_t begin = line.find_first_not_of(' ');
        if (begin != std::string::npos && line.compare(begin, name.size(), name) == 0)
            return words_of(line.substr(begin + name.size()));
    }
    return {};
}

}  // namespace

TEST_CASE("the text has the figures before and after side by side") {
    const tests::ImprovedBox box;
    const std::string text = report_text(box.improvement);
    INFO(text);
    CHECK(row(text, "tetrahedra") == std::vector<std::string>{"384", "384"});
    CHECK(row(text, "vertices") == std::vector<std::string>{"125", "125"});
    CHECK(row(text, "smallest dihedral angle, degrees").back() == "45.0000");
    CHECK(row(text, "largest dihedral angle, degrees").back() == "90.0000");
    CHECK(row(text, "50 % of all dihedral angles up to").back() == "60.0000");
    CHECK(row(text, "worst quality, biased-sine").size() == 2);
    CHECK_THAT(text, Catch::Contains("converged") && Catch::Contains("4 rounds, 1.50 s") &&
                         Catch::Contains("11 smoothings, 12 edge removals, 13 multi-face removals, 14 multi-face "
                                         "retriangulations, 15 collapses, 16 escapes"));
    for (const std::string& line : lines_of(text)) {
        CHECK((line.empty() || line.back() != ' '));
    }
}

TEST_CASE("the histogram has a line for each 10 degrees, and the highest bar is the longest") {
    const tests::ImprovedBox box;
    const std::string text = report_text(box.improvement);
    CHECK(row(text, "40 to  50").at(0) == std::to_string(angle_histogram(box.improvement.before, 18)[4]));
    CHECK(row(text, "90 to 100").back() == std::string(22, '#'));
    CHECK(row(text, "170 to 180").size() >= 2);
}

TEST_CASE("a report on a mesh that stays as it is has one column") {
    const std::string text = report_text(tests::ImprovedBox().judged());
    CHECK(row(text, "tetrahedra") == std::vector<std::string>{"384"});
    CHECK_THAT(text, !Catch::Contains("before") && !Catch::Contains("after") && !Catch::Contains("smoothings"));
}

TEST_CASE("the end is given with its reason") {
    tests::ImprovedBox box;
    box.improvement.parameters.target_angle = 20;
    box.improvement.run->end = dsc3d::ImproveEnd::reached_target_angle;
    CHECK_THAT(end_reason(box.improvement), Catch::Contains("between 20 and 160 degrees"));
    box.improvement.parameters.time_limit = 2.5;
    box.improvement.run->end = dsc3d::ImproveEnd::reached_time_limit;
    CHECK_THAT(end_reason(box.improvement), Catch::Contains("2.5 s"));
    box.improvement.run->end = dsc3d::ImproveEnd::cancelled;
    CHECK(end_reason(box.improvement) == "stopped by the user");
}

TEST_CASE("the JSON report reads back with every figure") {
    const tests::ImprovedBox box;
    const io::Json report = io::Json::parse(report_json(box.improvement).dump(1));
    CHECK(report["input"].string() == "folder/box.mesh");
    CHECK(report["output"].is_null());
    CHECK(report["measure"].string() == "biased-sine");
    CHECK(report["parameters"]["schedule"].string() == "thesis");
    CHECK(report["parameters"]["time_limit"].is_null());
    CHECK(report["before"]["min_dihedral"].number() == box.improvement.before.smallest_angle);
    CHECK(report["after"]["max_dihedral"].number() == box.improvement.after->largest_angle);
    CHECK(report["after"]["dihedral_percentiles"]["99"].number() == box.improvement.after->angle_percentiles.back());
    CHECK(report["after"]["dihedral_histogram"].size() == 180);
    CHECK(report["before"]["volume"].number() == box.improvement.before.volume);
    CHECK(report["end"].string() == "converged");
    CHECK(report["operations"]["escapes"].integer() == 16);
    CHECK(report["seconds"]["improve"].number() == 1.5);
}

TEST_CASE("the JSON report has the same keys whether or not the mesh was improved") {
    const tests::ImprovedBox box;
    const io::Json improved = report_json(box.improvement), judged = report_json(box.judged());
    REQUIRE(improved.size() == judged.size());
    for (std::size_t i = 0; i < improved.size(); ++i) CHECK(improved.members()[i].first == judged.members()[i].first);
    CHECK(judged["after"].is_null());
    CHECK(judged["end"].is_null());
    CHECK(judged["seconds"]["improve"].is_null());
}
