// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/planar/polygon_file.h"

#include <catch2/catch.hpp>

#include "core/errors.h"
#include "io/atomic_file.h"
#include "tests/support/temporary_folder.h"

using namespace dsc;
using dsc2d::Point2;
using dsc2d::Region;

namespace {

std::vector<Region> read(const std::string& name, const std::string& text, std::optional<double> edge_length = {}) {
    const tests::TemporaryFolder folder;
    io::write_file(folder / name, text);
    return flow::planar::read_polygons((folder / name).string(), edge_length);
}

void check_file_refused(const std::string& name, const std::string& text, const std::string& word) {
    CAPTURE(text);
    CHECK_THROWS_AS(read(name, text), core::InputError);
    CHECK_THROWS_WITH(read(name, text), Catch::Contains(word) && Catch::Contains(name));
}

}  // namespace

TEST_CASE("polygons from CSV, JSON and SVG are the same") {
    const std::vector<Point2> triangle = {{0, 0}, {2, 0}, {1, 1}}, square = {{5, 0}, {6, 0}, {6, 1}, {5, 1}};
    for (const auto& regions :
         {read("a.csv", "x,y,polygon\n5,0,8\n6,0,8\n6,1,8\n5,1,8\n0,0,7\n2,0,7\n1,1,7\n0,0,7\n"),
          read("a.json", "[[[0,0],[2,0],[1,1]], [[5,0],[6,0],[6,1],[5,1],[5,0]]]"),
          read("a.svg", "<svg><path d='M0 0H2L1-1Z'/><polygon points='5,0 6,0 6,-1 5,-1'/></svg>")}) {
        REQUIRE(regions.size() == 2);
        for (const Region& region : regions) {
            CHECK(region.label == 1);
            CHECK(region.outline == (region.outline.size() == 3 ? triangle : square));
        }
    }
}

TEST_CASE("without labels a polygon inside another one is a hole, and the next one an object again") {
    const auto regions = read(
        "a.json", "[[[2,2],[3,2],[3,3]], [[0,0],[9,0],[9,9],[0,9]], [[1,1],[5,1],[5,5],[1,5]], [[6,6],[8,6],[8,8]]]");
    REQUIRE(regions.size() == 4);
    CHECK(regions[0].outline.front() == Point2(0, 0));
    CHECK(regions[0].label == 1);
    CHECK(regions[1].outline.front() == Point2(1, 1));
    CHECK(regions[1].label == 0);
    CHECK(regions[2].label == 0);  // the triangle beside it
    CHECK(regions[3].label == 1);
    const auto labelled = read("a.csv", "0,0,1,4\n9,0,1,4\n9,9,1,4\n5,1,2,-2\n8,1,2,-2\n8,2,2,-2\n");
    CHECK(labelled[0].label == 4);
    CHECK(labelled[1].label == -2);
}

TEST_CASE("labels have to be whole numbers in range, one for each polygon, and not all those of the outside") {
    for (const std::string label : {"99999999999", "4294967296", "4294967297", "-2147483649", "9223372036854775808"}) {
        check_file_refused("a.json", "[{\"label\": " + label + ", \"points\": [[0,0],[1,0],[1,1]]}]", "polygon 1");
        check_file_refused("a.csv", "0,0,1," + label + "\n1,0,1," + label + "\n1,1,1," + label + "\n", "line 1");
    }
    check_file_refused("a.json", R"([{"label": 1.5, "points": [[0,0],[1,0],[1,1]]}])", "polygon 1");
    check_file_refused("a.json", R"([[[5,5],[6,5],[6,6]], {"label": 4294967296, "points": [[0,0],[1,0],[1,1]]}])",
                       "polygon 2: the label 4294967296");
    const std::string several = "x,y,polygon,label\n0,0,1,3\n5,0,2,7\n6,0,2,7\n# the odd one\n1,0,1,4\n6,1,2,7\n";
    check_file_refused("a.csv", several, "line 6: polygon 1 gets the label 4 after 3");
    for (const auto& [name, text] : {std::pair("a.csv", "0,0,1,0\n1,0,1,0\n1,1,1,0\n"),
                                     std::pair("a.json", R"([{"label": 0, "points": [[0,0],[1,0],[1,1]]}])")})
        check_file_refused(name, text, "label 0");
    // A hole may have the label of the outside.
    CHECK(read("a.csv", "0,0,1,2\n9,0,1,2\n9,9,1,2\n5,1,2,0\n8,1,2,0\n8,2,2,0\n")[1].label == 0);
}

TEST_CASE("numbers beyond what can be calculated with are refused, and more edges than make sense") {
    check_file_refused("a.json", "[[[0,0],[1e308,0],[1e308,1e308],[-1e308,1e308]]]",
                       "polygon 1: its point (1e+308, 0)");
    check_file_refused("a.svg", "<svg><path d='M0 0L1e300 0L1e300 1e300Z'/></svg>", "path 1: its point");
    check_file_refused("a.csv", "0,0\n1e-100,0\n1e-100,1e-100\n", "smaller");
    CHECK(read("a.csv", "0,0\n1e-50,0\n1e-50,1e-50\n").size() == 1);
    const std::string triangle = "0,0\n4,0\n0,3\n", square = "[[[0,0],[1,0],[1,1],[0,1]]]";
    CHECK_THROWS_WITH(read("a.csv", triangle, 1e-9), Catch::Contains("a.csv") && Catch::Contains("1.2e+10 times"));
    CHECK_THROWS_WITH(read("a.json", square, 5e-324), Catch::Contains("a.json") && Catch::Contains("inf times"));
    CHECK(read("a.csv", triangle, 1e-4).size() == 1);
    CHECK(read("a.svg", "<svg><path d='M0 0C10 10-10 10 0 0Z'/></svg>").size() == 1);
}

TEST_CASE("polygons that are open, meet themselves or each other are refused with the place") {
    check_file_refused("a.csv", "0,0\n1,1\n1,0\n0,1\n", "side 1 meets side 3 at (0.5, 0.5)");
    check_file_refused("a.csv", "0,0,1\n1,0,1\n1,1,1\n0.5,0.5,2\n2,0.5,2\n2,0.6,2\n", "of polygon 2 at (1, 0.5)");
    check_file_refused("a.svg", "<svg><path d='M1 2L3 4L5 7'/></svg>",
                       "open: it begins at (1, -2) and ends at (5, -7)");
    check_file_refused("a.csv", "0,0\n1,0\n", "fewer than three");
    check_file_refused("a.csv", "0,0\n1,0\n0,0\n", "fewer than three");
    check_file_refused("a.csv", "x,y\n0,0\n1,nan\n", "line 3");
    check_file_refused("a.csv", "1,2,3,4,5\n", "columns");
    check_file_refused("a.csv", "0,0,1,0.5\n", "label 0.5");
    check_file_refused("a.svg", "<svg><path d='M0 0H9V9Z M1 1 H2'/></svg>", "path 1, part 2: is open");
    check_file_refused("a.svg", "<svg><path d='M0 0C0 0 0 0 0 0Z'/></svg>", "fewer than three");
    check_file_refused("a.csv", "x,y\n", "no polygon");
    check_file_refused("a.json", "[[[0,0],[1,0],[1]]]", "polygon 1");
    check_file_refused("a.json", "[[[0,0],[1,0],[1,1]], 7]", "polygon 2");
    check_file_refused("a.json", "{", "a.json");
    check_file_refused("a.txt", "", ".txt");
}
