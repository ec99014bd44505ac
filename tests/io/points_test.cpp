// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/points.h"

#include <catch2/catch.hpp>
#include <regex>

#include "core/random.h"
#include "io/number.h"
#include "tests/geometry/surfaces.h"
#include "tests/io/surface/support.h"
#include "tests/support/seed.h"
#include "tests/support/shared_data.h"

using namespace dsc;
using namespace dsc::tests;
using Catch::Contains;
using geometry::PointData;

namespace {

using Points = std::vector<Eigen::Vector3d>;

const Points two{{0, -1, 0.5}, {100, 2, 3}};

}  // namespace

TEST_CASE("points of three columns are read in any spacing") {
    for (const char* text :
         {"0 -1 .5\n100 2 3\n", "0 -1 .5\n100 2 3", "# scan\n\n  0\t-1 5e-1 # first\r\n\r\n+1e2 2 3\r\n#end",
          "0,-1,0.5\n100,2,3\n", "0, -1, 0.5,\n100 , 2 ,3\n"}) {
        for (const char* name : {"p.xyz", "p.XYZ", "p.txt", "p.pts", "p.asc", "p.csv"}) {
            CAPTURE(name, text);
            const PointData data = points_in(name, text);
            CHECK(data.points == two);
            CHECK(data.normals.empty());
        }
    }
}

TEST_CASE("points of six columns and more have normals, unless these are colours") {
    const PointData data = points_in("p.xyz", "0 -1 .5 0 0 1\n100 2 3 0.6 -0.8 0\n");
    CHECK(data.points == two);
    CHECK(data.normals == Points{{0, 0, 1}, {0.6, -0.8, 0}});
    CHECK(points_in("p.xyz", "0 -1 .5 0 0 1 255 255 255\n100 2 3 0.6 -0.8 0 a nan b #\n").normals == data.normals);
    CHECK(points_in("p.xyz", "0 -1 .5 0 0 1\n100 2 3 0 1 0\n").normals == Points{{0, 0, 1}, {0, 1, 0}});
    CHECK(points_in("p.xyz", "0 -1 .5 0 0 2\n100 2 3 0 -1 0\n").normals.size() == 2);
    CHECK(points_in("p.xyz", "0 -1 .5 0 0 1\n100 2 3 255 128 0\n").normals.empty());
    CHECK(points_in("p.xyz", "0 -1 .5 0 0 1\n100 2 3 255 128 0\n").points == two);
}

TEST_CASE("a count or the names of the columns may stand before the points") {
    for (const char* text :
         {"2\n0 -1 .5\n100 2 3\n", "2\n0 -1 .5 -99\n100 2 3 7\n", "# scan\n\n2\n0 -1 .5 -99 0 0 1\n100 2 3 7 1 2 3\n",
          "2\n0 -1 .5 1 2 3\n100 2 3 255 0 0\n"}) {
        CAPTURE(text);
        const PointData data = points_in("p.pts", text);
        CHECK(data.points == two);
        CHECK(data.normals.empty());
    }
    for (const char* text :
         {"x,y,z\n0,-1,.5\n100,2,3\n", "\"X\",\"Y\",\"Z\"\n0,-1,.5\n100,2,3\n", "//X Y Z\n0 -1 .5\n100 2 3\n",
          "id,z,x,y\na,.5,0,-1\nb,3,100,2\n", "x,y,z,r,g,b,nx\n0,-1,.5,1,2,3,0\n100,2,3,1,2,3,1\n"}) {
        CAPTURE(text);
        const PointData data = points_in("p.csv", text);
        CHECK(data.points == two);
        CHECK(data.normals.empty());
    }
    CHECK(points_in("p.csv", "x,nx,y,ny,z,nz\n0,0.6,-1,-0.8,.5,0\n100,0,2,0,3,1\n").normals ==
          Points{{0.6, -0.8, 0}, {0, 0, 1}});
}

TEST_CASE("numbers of a point file are read exactly") {
    core::Random random(seed(84));
    Points points{{1e300, -5e-324, -0.0}};
    for (int i = 0; i < 100; ++i) points.emplace_back(random.uniform(), random.uniform(-1, 0), random.uniform(0, 1e-9));
    std::string text;
    for (const Eigen::Vector3d& p : points) {
        for (const double x : p) text += io::number_text(x) + " ";
        text += "\n";
    }
    CHECK(same_bits(points_in("p.xyz", text).points, points));
}

TEST_CASE("a wrong point file is refused with its line") {
    CHECK_THAT(points_error("p.xyz", ""), Contains("p.xyz: contains no points; give a point cloud"));
    CHECK_THAT(points_error("p.xyz", "# nothing\n\n"), Contains("p.xyz: contains no points"));
    CHECK_THAT(points_error("p.xyz", "\n# 4\n0 0 0 1\n"), Contains("line 3: the number of columns is 4; use 3, or 6"));
    CHECK_THAT(points_error("p.xyz", "2.5\n0 0 0\n"), Contains("line 1: the number of columns is 1; use 3, or 6"));
    CHECK_THAT(points_error("p.pts", "2\n0 0 0\n"), Contains("there are 1 points, but 2 in the line before them"));
    CHECK_THAT(points_error("p.pts", "2\n0 0 0\n1 1 1\n2 2 2\n"), Contains("there are 3 points, but 2 in"));
    CHECK_THAT(points_error("p.pts", "0\n"), Contains("contains no points"));
    CHECK_THAT(points_error("p.csv", "x,y,z\n"), Contains("contains no points"));
    CHECK_THAT(points_error("p.csv", "x,y,x\n0,0,0\n"),
               Contains("line 1: the names of the columns are not x, y and z"));
    CHECK_THAT(points_error("p.csv", "x,y,z\n0,0,0,0\n"), Contains("line 2: the number of columns is 4, but 3"));
    CHECK_THAT(points_error("p.xyz", "0 0 0\n0 0\n0 0 0\n"),
               Contains("line 2: the number of columns is 2, but 3 in the lines before; correct the line"));
    CHECK_THAT(points_error("p.xyz", "0 0 0\n1 0 0 0 # 0\n"), Contains("line 2: the number of columns is 4, but 3"));
    CHECK_THAT(points_error("p.xyz", "0 0 0\n1 0"), Contains("line 2: the number of columns is 2, but 3"));
    CHECK_THAT(points_error("p.csv", "0,0,0\n1,,0"), Contains("line 2: the number of columns is 2, but 3"));
    CHECK_THAT(points_error("p.xyz", "0 0 0 0 0 1 7\n1 0 0 0 0 1\n"),
               Contains("line 2: the number of columns is 6, but"));
    CHECK_THAT(points_error("p.xyz", "0 0 0\n1 nan 0\n"), Contains("line 2: \"nan\" where a coordinate is expected"));
    CHECK_THAT(points_error("p.xyz", "0 0 0\n1 -inf 0\n"), Contains("line 2: \"-inf\" where a coordinate is expected"));
    CHECK_THAT(points_error("p.csv", "0,y,0\n0,0,0\n"), Contains("line 1: \"y\" where a coordinate is expected"));
    CHECK_THAT(points_error("p.las", "LASF"), Contains("no format of points has the extension .las; use .xyz, .ply"));
    CHECK_THAT(points_error("p", "0 0 0"), Contains("has no extension that tells its format; use .xyz"));
}

TEST_CASE("a folder is no point file") {
    const TemporaryFolder folder;
    CHECK_THROWS_WITH(io::read_points(folder.path()), Contains("is a folder; name a file"));
}

TEST_CASE("the vertices of surfaces are points, whether or not there are faces") {
    const geometry::SurfaceData surface = box({0.1, 0.2, 0.3});
    const TemporaryFolder folder;
    for (const char* name : {"s.off", "s.obj", "s.ply"}) {
        INFO(name);
        io::write_surface_mesh(folder / name, surface);
        const PointData data = io::read_points(folder / name);
        CHECK(same_bits(data.points, surface.vertices));
        CHECK(data.normals.empty());
    }
    CHECK(points_in("p.off", "OFF\n2 0 0\n0 -1 .5\n100 2 3\n").points == two);
    CHECK(points_in("p.obj", "v 0 -1 .5\nv 100 2 3\n").points == two);
    CHECK_THAT(points_error("p.off", "OFF\n2 0 0\n0 -1 .5\n100 2 3\n0 0 0\n"),
               Contains("line 5: there are more vertices"));
    CHECK_THAT(points_error("p.off", "OFF\n0 0 0\n"), Contains("contains no points"));
    CHECK_THAT(points_error("p.obj", "# nothing\n"), Contains("contains no points"));
}

TEST_CASE("points of a PLY file have normals when there are all three components") {
    const std::string ascii =
        "ply\nformat ascii 1.0\nelement vertex 2\nproperty float nx\nproperty float ny\nproperty float nz\n"
        "property uchar red\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
        "0 0 1 255 0 -1 .5\n0.6 -0.8 0 0 100 2 3\n";
    CHECK(points_in("p.ply", ascii).points == two);
    CHECK(points_in("p.ply", ascii).normals == Points{{0, 0, 1}, {0.6, -0.8, 0}});
    const PointData without = points_in("p.ply", replaced(ascii, "float nz", "float curvature"));
    CHECK(without.points == two);
    CHECK(without.normals.empty());
    CHECK_THAT(points_error("p.ply", replaced(ascii, "vertex 2", "vertex 1")),
               Contains("line 13: there are more rows"));
    CHECK_THAT(points_error("p.ply", replaced(ascii, "vertex 2", "vertex 3")),
               Contains("ends where vertex is expected"));
    CHECK_THAT(points_error("p.ply", replaced(ascii, "vertex 2", "vertex 0")), Contains("there are more rows"));
    CHECK_THAT(points_error("p.ply", replaced(ascii, "element vertex", "element point")),
               Contains("no element vertex"));
}

TEST_CASE("the shared clouds have the counts of their table", "[shared]") {
    DSC_NEEDS_SHARED_DATA("points/README.md");
    const std::string table = io::read_file(shared_data("points/README.md"));
    const std::regex row(R"(\n\| (\w+\.xyz) \| (\d+) \|)");
    int rows = 0;
    for (std::sregex_iterator match(table.begin(), table.end(), row), end; match != end; ++match, ++rows) {
        const std::string name = (*match)[1];
        INFO(name);
        const PointData data = io::read_points(shared_data("points/" + name));
        CHECK(data.points.size() == std::stoul((*match)[2]));
        CHECK(data.normals.empty());
    }
    CHECK(rows == 31);
}
