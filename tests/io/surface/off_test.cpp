// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "tests/io/surface/support.h"

using namespace dsc;
using namespace dsc::tests;
using Catch::Contains;

namespace {

// A pyramid over a square.
const std::string off_text =
    "OFF\n# made by hand\n5 5 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n.5 .5 1e0\n4 0 3 2 1\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 "
    "4\n";
const Triangles off_triangles{{0, 3, 2}, {0, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};

std::string off_error(const std::string& what, const std::string& replacement) {
    return surface_error("s.off", replaced(off_text, what, replacement));
}

}  // namespace

TEST_CASE("an OFF file is read in any spacing and with colours, polygons as fans") {
    const geometry::SurfaceData data = surface_in("s.off", off_text);
    CHECK(data.vertices.size() == 5);
    CHECK(data.vertices[4] == Eigen::Vector3d(0.5, 0.5, 1));
    CHECK(data.triangles == off_triangles);
    CHECK(data.labels.empty());
    for (const std::string& other :
         {replaced(off_text, "OFF\n", "OFF "), replaced(off_text, "5 5 0", "5 5"),
          replaced(off_text, "5 5 0", "\n5 5 8 # edges"), replaced(off_text, "0 0 0\n", "\n\n\t0 0 0 # first\r\n"),
          replaced(off_text, "3 0 1 4", "3 0 1 4 255 0 0"), replaced(off_text, "3 0 1 4", "3 0 1 4 0.5 0.5 0.5 1"),
          off_text.substr(0, off_text.size() - 1)}) {
        INFO(other);
        const geometry::SurfaceData same = surface_in("s.off", other);
        CHECK(same_bits(same.vertices, data.vertices));
        CHECK(same.triangles == off_triangles);
    }
}

TEST_CASE("OFF files with more at their vertices are read without it") {
    const std::string faces = "3 0 1 2\n";
    const std::vector<std::pair<std::string, std::string>> kinds{
        {"NOFF", " 0 0 1"}, {"COFF", " 255 0 0 255"}, {"CNOFF", " 0 0 1 9 9 9"}, {"STCNOFF", " 0 0 1 1 1 1 1 .5 .5"}};
    for (const auto& [head, more] : kinds) {
        INFO(head);
        const std::string vertices = "0 0 0" + more + "\n1 0 0" + more + "\n0 1 0" + more + "\n";
        const geometry::SurfaceData data = surface_in("s.off", head + "\n3 1 0\n" + vertices + faces);
        CHECK(data.vertices[1] == Eigen::Vector3d(1, 0, 0));
        CHECK(data.triangles == Triangles{{0, 1, 2}});
        CHECK(points_in("s.off", head + "\n3 1 0\n" + vertices + faces).normals.size() == (head == "COFF" ? 0 : 3));
    }
}

TEST_CASE("a wrong OFF file is refused with its line") {
    CHECK_THAT(surface_error("s.off", ""), Contains("s.off: line 1: ends where OFF is expected"));
    CHECK_THAT(off_error("OFF", "4OFF"), Contains("line 1: is no OFF file in space"));
    CHECK_THAT(off_error("OFF", "solid"), Contains("line 1: is no OFF file in space"));
    CHECK_THAT(off_error("OFF\n", "OFF BINARY\n"),
               Contains("line 1: \"BINARY\" where the number of vertices is expected"));
    CHECK_THAT(off_error("5 5 0", "6 5 0"), Contains("line 9: there are more numbers than expected"));
    CHECK_THAT(off_error("5 5 0", "4 5 0"),
               Contains("line 8: \".5\" where the number of vertices of a face is expected"));
    CHECK_THAT(off_error("5 5 0", "5 4 0"), Contains("line 13: there are more faces than announced"));
    CHECK_THAT(off_error("5 5 0", "5 6 0"), Contains("line 14: ends where a face is expected; the file is truncated"));
    CHECK_THAT(off_error("5 5 0", "99999999999 5 0"),
               Contains("line 3: 99999999999 vertices are announced, more than"));
    CHECK_THAT(off_error("5 5 0", "5 99999999 0"), Contains("line 3: 99999999 faces are announced, more than"));
    CHECK_THAT(off_error("5 5 0", "5 0 0"), Contains("there are more faces than announced"));
    CHECK_THAT(off_error("5 5 0", "-5 5 0"), Contains("line 3: the number of vertices is negative"));
    CHECK_THAT(off_error("1 0 0\n", "1 nan 0\n"), Contains("line 5: \"nan\" where a coordinate is expected"));
    CHECK_THAT(off_error("1 0 0\n", "1 -inf 0\n"), Contains("line 5: \"-inf\" where a coordinate is expected"));
    CHECK_THAT(off_error("1 0 0\n", "1 0\n"), Contains("line 5: there are fewer numbers than expected"));
    CHECK_THAT(off_error("1 0 0\n", "1 0 0 0\n"), Contains("line 5: there are more numbers than expected"));
    CHECK_THAT(off_error("3 0 1 4", "3 0 1 5"), Contains("line 10: vertex 5 does not exist; use 0 to 4"));
    CHECK_THAT(off_error("3 0 1 4", "3 0 1 -1"), Contains("line 10: vertex -1 does not exist; use 0 to 4"));
    CHECK_THAT(off_error("3 0 1 4", "3 0 1 1"), Contains("line 10: a face has the same vertex twice"));
    CHECK_THAT(off_error("4 0 3 2 1", "4 0 3 0 1"), Contains("line 9: a face has the same vertex twice"));
    CHECK_THAT(off_error("3 0 1 4", "2 0 1"), Contains("line 10: a face has fewer than 3 vertices"));
    CHECK_THAT(off_error("3 0 1 4", "0"), Contains("line 10: a face has fewer than 3 vertices"));
    CHECK_THAT(off_error("3 0 1 4", "4 0 1 4"), Contains("line 10: there are fewer numbers than expected"));
    CHECK_THAT(off_error("3 0 1 4", "999999 0 1 4"), Contains("line 10: 999999 vertices of a face are announced"));
    CHECK_THAT(surface_error("s.off", "OFF\n0 0 0\n"), Contains("s.off: contains no faces; give a surface"));
}
