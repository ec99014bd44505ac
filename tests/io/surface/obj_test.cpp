// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "tests/io/surface/support.h"

using namespace dsc;
using namespace dsc::tests;
using Catch::Contains;

namespace {

const std::string obj_text =
    "# made by hand\nmtllib a.mtl\no pyramid\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv .5 .5 1\n"
    "vt 0 0\nvn 0 0 -1\ng base\nusemtl red\ns off\nf 1 4 3 2\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
const Triangles obj_triangles{{0, 3, 2}, {0, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};

std::string obj_error(const std::string& what, const std::string& replacement) {
    return surface_error("s.obj", replaced(obj_text, what, replacement));
}

}  // namespace

TEST_CASE("an OBJ file is read with indices in all their forms") {
    const geometry::SurfaceData data = surface_in("s.obj", obj_text);
    CHECK(data.vertices.size() == 5);
    CHECK(data.vertices[4] == Eigen::Vector3d(0.5, 0.5, 1));
    CHECK(data.triangles == obj_triangles);
    for (const std::string& other :
         {replaced(obj_text, "f 1 4 3 2", "f 1/1 4/1 3/1 2/1"),
          replaced(obj_text, "f 1 4 3 2", "f 1//1 4//1 3//1 2//1"),
          replaced(obj_text, "f 1 4 3 2", "f 1/1/1 4/1/1 3/-1/-1 2/1/1"),
          replaced(obj_text, "f 1 4 3 2", "f -5 -2 -3 -4"),
          replaced(obj_text, "f 1 4 3 2", "f -5/-1/-1 -2/-1/-1 3 2 # mixed"),
          replaced(obj_text, "f 1 4 3 2", "f 1 4 \\\n3 2"), replaced(obj_text, "f 1 4 3 2", "f 1 4\\\n 3\\\r\n\\\n 2"),
          replaced(obj_text, "f 1 4 3 2", "\tf  1\t4 3 2 \r"), replaced(obj_text, "v 1 0 0", "v 1 0 0 1"),
          replaced(obj_text, "v 1 0 0", "v 1 0 0 0.5 0.5 0.5"), replaced(obj_text, "v 1 0 0", "v 1 \\\n 0 0"),
          replaced(obj_text, "g base", "g base \\\n f 1 2 3"),
          replaced(obj_text, "g base", "l 1 2\np 1\ncstype bezier"), obj_text.substr(0, obj_text.size() - 1)}) {
        INFO(other);
        const geometry::SurfaceData same = surface_in("s.obj", other);
        CHECK(same_bits(same.vertices, data.vertices));
        CHECK(same.triangles == obj_triangles);
    }
}

TEST_CASE("negative indices are counted back from where they stand") {
    const std::string one = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n";
    CHECK(surface_in("s.obj", one + one).triangles == Triangles{{0, 1, 2}, {3, 4, 5}});
}

TEST_CASE("a wrong OBJ file is refused with its line") {
    CHECK_THAT(surface_error("s.obj", ""), Contains("s.obj: contains no faces; give a surface, not points"));
    CHECK_THAT(obj_error("v 1 0 0", "v 1 0"), Contains("line 5: a vertex has fewer than 3 coordinates"));
    CHECK_THAT(obj_error("v 1 0 0", "v 1 0 x"), Contains("line 5: \"x\" where a coordinate is expected"));
    CHECK_THAT(obj_error("v 1 0 0", "v 1 0 nan"), Contains("line 5: \"nan\" where a coordinate is expected"));
    CHECK_THAT(obj_error("v 1 0 0", "v 1 0 1e999"), Contains("line 5: \"1e999\" where a coordinate is expected"));
    CHECK_THAT(obj_error("v 1 0 0", "w 1 0 0"), Contains("line 5: \"w\" where a keyword is expected"));
    CHECK_THAT(obj_error("f 1 2 5", "f 1 2 6"), Contains("line 15: vertex 6 does not exist; use 1 to 5"));
    CHECK_THAT(obj_error("f 1 2 5", "f 1 2 0"), Contains("line 15: vertex 0 does not exist; use 1 to 5"));
    CHECK_THAT(obj_error("f 1 2 5", "f 1 2 -6"), Contains("line 15: vertex -6 does not exist; use -1 to -5"));
    CHECK_THAT(obj_error("f 1 2 5", "f 1 2 99999999999999999999"),
               Contains("where the number of a vertex is expected"));
    CHECK_THAT(obj_error("f 1 2 5", "f 1 2 1.5"),
               Contains("line 15: \"1.5\" where the number of a vertex is expected"));
    CHECK_THAT(obj_error("f 1 2 5", "f 1 2 /1"), Contains("line 15: \"/1\" where the number of a vertex is expected"));
    CHECK_THAT(obj_error("f 1 2 5", "f 1 2 -4"), Contains("line 15: a face has the same vertex twice"));
    CHECK_THAT(obj_error("f 1 2 5", "f 1 2"), Contains("line 15: a face has fewer than 3 vertices"));
    CHECK_THAT(obj_error("f 1 2 5", "f"), Contains("line 15: a face has fewer than 3 vertices"));
    CHECK_THAT(obj_error("f 1 2 5", "f 1 2 \\\n 6"), Contains("line 16: vertex 6 does not exist"));
    CHECK_THAT(surface_error("s.obj", "f 1 2 3\nv 0 0 0\n"), Contains("line 1: a face comes before all vertices"));
    CHECK_THAT(surface_error("s.obj", "f -1 -2 -3\nv 0 0 0\n"), Contains("line 1: a face comes before all vertices"));
}
