// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/svg_paths.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/errors.h"
#include "io/atomic_file.h"
#include "tests/support/temporary_folder.h"

using namespace dsc;
using Eigen::Vector2d;

namespace {

std::vector<io::SvgPath> read(const std::string& body, std::optional<double> edge_length = 1e9) {
    const tests::TemporaryFolder folder;
    io::write_file(folder / "picture.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\">" + body + "</svg>");
    return io::read_svg_paths(folder / "picture.svg", edge_length);
}

std::vector<Vector2d> points(const std::string& data, std::optional<double> edge_length = 1e9) {
    const std::vector<io::SvgPath> paths = read("<path d=\"" + data + "\"/>", edge_length);
    REQUIRE(paths.size() == 1);
    return paths[0].points;
}

}  // namespace

TEST_CASE("absolute and relative lines say the same, with y upwards") {
    const std::vector<Vector2d> expected = {{1, -2}, {4, -2}, {4, -6}, {2, -7}};
    CHECK(points("M 1 2 L 4 2 L 4 6 L 2 7 Z") == expected);
    CHECK(points("m1,2l3,0l0,4l-2,1z") == expected);
    CHECK(points("M1 2H4V6L2 7Z") == expected);
    CHECK(points("m1 2h3v4l-2+1z") == expected);
    CHECK(points("M 1 2 4 2 4 6 2 7 Z") == expected);
    CHECK(points("m1 2 3 0 0 4-2 1z") == expected);
    CHECK(points("M1e0 .2e1L4.0 2 4 6 2 7 1 2") == expected);
}

TEST_CASE("a path is closed by Z or by its last point, and open otherwise; each subpath is one of its own") {
    CHECK(read("<path d='M0 0L1 0L1 1Z'/>")[0].is_closed);
    CHECK(read("<path d='M0 0L1 0L1 1L0 0'/>")[0].is_closed);
    CHECK(read("<path d='m0 0l.1 0l.2 .3l-.3 -.3'/>")[0].is_closed);
    CHECK_FALSE(read("<path d='M0 0L1 0L1 1'/>")[0].is_closed);
    const auto two = read("<path d='M0 0L4 0L4 4Z m1 1l1 0l0 1z'/><polygon points='7,7 8,7 8,8'/>");
    REQUIRE(two.size() == 3);
    CHECK(two[1].points[0] == Vector2d(1, -1));
    CHECK(two[2].points.size() == 3);
    CHECK(two[0].name == "path 1, part 1");
    CHECK(two[1].name == "path 1, part 2");
    CHECK(two[2].name == "path 2");
    for (const char* closed_twice : {"M0 0L1 0L1 1Z Z", "M0 0L1 0L1 1zzZ", "M5 5Z M0 0L1 0L1 1Z"})
        CHECK(points(closed_twice) == std::vector<Vector2d>{{0, 0}, {1, 0}, {1, -1}});
}

TEST_CASE("curves lie where they should, in even chords no longer than asked for") {
    // A quarter of a circle by a cubic: within 3e-4 of the circle.
    const auto cubic = points("M10 0C10 5.5228475 5.5228475 10 0 10L0 0Z", 0.5);
    REQUIRE(cubic.size() > 32);
    double shortest = 1e9;
    for (std::size_t i = 0; i + 2 < cubic.size(); ++i) {
        CHECK(cubic[i].norm() == Approx(10).epsilon(3e-4));
        CHECK((cubic[i + 1] - cubic[i]).norm() <= 0.5);
        shortest = std::min(shortest, (cubic[i + 1] - cubic[i]).norm());
    }
    CHECK(shortest > 0.45);
    // A parabola, by Q, by T that mirrors its control, and by the cubic of the same shape.
    for (const Vector2d& p : points("M0 0Q1 2 2 0L1 -5Z", 0.1))
        if (p.y() < 1e-9) CHECK(p.y() == Approx(-p.x() * (2 - p.x())).margin(1e-3));
    for (const Vector2d& p : points("M0 0Q1 2 2 0T4 0L2 -9Z", 0.1))
        if (p.x() > 2 && p.y() >= 0 && p.y() < 2) CHECK(p.y() == Approx((p.x() - 2) * (4 - p.x())).margin(1e-3));
    const auto smooth = points("M0 0C0 1 1 1 1 0S2 -1 2 0L1 -9Z", 0.05);
    const auto plain = points("M0 0C0 1 1 1 1 0C1 -1 2 -1 2 0L1 -9Z", 0.05);
    CHECK(smooth == plain);
}

TEST_CASE("a curve that ends where it begins is divided by the size of its control points") {
    const std::vector<io::SvgPath> paths = read("<path d='M0 0C10 10-10 10 0 0Z'/>", std::nullopt);
    REQUIRE(paths.size() == 1);
    CHECK(paths[0].is_closed);
    REQUIRE(paths[0].points.size() > 20);
    // The drop is (30 t (1-t)(1-2t), -30 t (1-t)) with t in [0, 1].
    for (const Vector2d& p : paths[0].points) {
        const double product = -p.y() / 30;
        CHECK(p.x() * p.x() == Approx(900 * product * product * (1 - 4 * product)).margin(1e-9));
    }
    for (std::size_t i = 0; i + 1 < paths[0].points.size(); ++i)
        CHECK((paths[0].points[i + 1] - paths[0].points[i]).norm() <= 0.2);
}

TEST_CASE("curves without length, tiny and huge ones are divided like others") {
    for (const std::optional<double> edge_length : {std::optional<double>(), std::optional(1e-9)})
        CHECK(points("M0 0C0 0 0 0 0 0Z", edge_length) == std::vector<Vector2d>{{0, 0}});
    const std::size_t count = points("M0 0C10 10-10 10 0 0Z", std::nullopt).size();
    for (const std::string scale : {"1e-200", "1e200"}) {
        const auto scaled = read("<path transform='scale(" + scale + ")' d='M0 0C10 10-10 10 0 0Z'/>", std::nullopt);
        REQUIRE(scaled.size() == 1);
        CHECK(scaled[0].points.size() == count);
    }
}

TEST_CASE("groups may lie in one another however deep") {
    constexpr int depth = 200'000;
    std::string body, end;
    for (int i = 0; i < depth; ++i) body += "<g transform='translate(1)'>";
    for (int i = 0; i < depth; ++i) end += "</g>";
    const auto found = read(body + "<path d='M0 0L1 0L1 1Z'/>" + end);
    REQUIRE(found.size() == 1);
    CHECK(found[0].points[0] == Vector2d(depth, 0));
}

TEST_CASE("paths come in the order of the picture") {
    const auto found =
        read("<g><path d='M1 0H9'/><g><path d='M2 0H9'/></g></g><path d='M3 0H9'/><g><path d='M4 0H9'/></g>");
    REQUIRE(found.size() == 4);
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(found[i].points[0].x() == static_cast<double>(i + 1));
        CHECK(found[i].name == "path " + std::to_string(i + 1));
    }
}

TEST_CASE("transforms of a path and of the groups around it are applied; definitions are no part of the picture") {
    const std::string path = "<path transform='rotate(90)' d='M1 0L2 0L1 1Z'/>";
    const auto found = read("<defs>" + path + "</defs><g transform='translate(10, 20) scale(2)'>" + path + "</g>");
    REQUIRE(found.size() == 1);
    CHECK((found[0].points[0] - Vector2d(10, -22)).norm() < 1e-12);
    CHECK((found[0].points[1] - Vector2d(10, -24)).norm() < 1e-12);
    CHECK((found[0].points[2] - Vector2d(8, -22)).norm() < 1e-12);
    CHECK(read("<path transform='matrix(1 2 3 4 5 6)' d='M1 1L2 0L3 1Z'/>")[0].points[0] == Vector2d(9, -12));
}

TEST_CASE("what can't be read is refused with its place") {
    const auto check_refused = [](const std::string& body, const std::string& word, double edge_length = 1e9) {
        CAPTURE(body);
        CHECK_THROWS_AS(read(body, edge_length), core::InputError);
        CHECK_THROWS_WITH(read(body, edge_length), Catch::Contains(word) && Catch::Contains("picture.svg"));
    };
    check_refused("<path d='M0 0L1 0A1 1 0 0 0 2 2Z'/>", "character 10");
    check_refused("<path d='M0 0L1 x'/>", "path 1");
    check_refused("<path d='L0 0'/>", "begin with M");
    check_refused("<path d='M0 0L1 1Z 3 4'/>", "command");
    check_refused("<path d='M0 0L1e999 1'/>", "number");
    check_refused("<path transform='twist(3)' d='M0 0L1 0L1 1Z'/>", "transform");
    check_refused("<g/>", "no path");
    check_refused("<path d='M5 5Z'/>", "no path");
    for (const std::string name : {"rect", "circle", "ellipse", "line", "use", "text", "image", "svg:rect"}) {
        const std::string kind = name == "svg:rect" ? "rect" : name;
        check_refused("<path d='M0 0L1 0L1 1Z'/><g><" + name + "/></g>", '"' + kind + '"');
        CHECK(read("<defs><" + name + "/></defs><path d='M0 0L1 0L1 1Z'/>").size() == 1);
    }
    check_refused("<g transform='scale(1e200)'><path transform='scale(1e200)' d='M0 0L1 0L1 1Z'/></g>", "too large");
    for (const double edge_length : {1e-9, 1e-30, 5e-324})
        check_refused("<path d='M0 0L1 0L1 1Z'/><path d='M0 0C10 10-10 10 0 0Z'/>", "path 2: its curves", edge_length);
    // Not one curve, but all of them.
    check_refused("<path d='M0 0Q1 2 2 0T4 0T6 0T8 0T10 0T12 0Z'/>", "million", 8e-6);
    CHECK(read("<path d='M0 0Q1 2 2 0Z'/>", 8e-6)[0].points.size() > 200'000);
    check_refused("<path", "picture.svg");
}
