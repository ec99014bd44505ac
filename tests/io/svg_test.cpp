// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/svg.h"

#include <catch2/catch.hpp>
#include <limits>
#include <vector>

#include "tests/support/xml.h"

using dsc::io::Svg;
using dsc::tests::parse_xml;
using dsc::tests::XmlElement;

TEST_CASE("a picture is well-formed whatever its texts are") {
    Svg picture({0, 0}, {2, 1});
    picture.title("a < b & \"c\" > 'd'");
    picture.begin_group("<g>", {.stroke = "red\" onload=\"x"});
    picture.label({1, 0.5}, "λ & </text>\x01");
    picture.end_group();
    const XmlElement svg = parse_xml(picture.text());
    CHECK(svg.all("title").at(0)->text == "a < b & \"c\" > 'd'");
    CHECK(svg.all("text").at(0)->text == "λ & </text>");
    CHECK(svg.all("g").at(0)->attributes.at("stroke") == "red\" onload=\"x");
}

TEST_CASE("user coordinates have y up and are scaled to the width") {
    Svg picture({-1, -1}, {1, 3}, 200, 10);
    picture.dot({-1, 3}, 4);
    picture.circle({1, -1}, 0.5);
    const XmlElement svg = parse_xml(picture.text());
    CHECK(svg.attributes.at("viewBox") == "0 0 220 420");
    const auto dots = svg.all("circle");
    CHECK(dots.at(0)->attributes.at("cx") == "10");
    CHECK(dots.at(0)->attributes.at("cy") == "10");
    CHECK(dots.at(1)->attributes.at("cx") == "210");
    CHECK(dots.at(1)->attributes.at("cy") == "410");
    CHECK(dots.at(1)->attributes.at("r") == "50");
}

TEST_CASE("a point that is not finite interrupts a line and draws nothing alone") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Svg picture({0, 0}, {10, 10}, 100, 0);
    const std::vector<Eigen::Vector2d> points{{0, 10}, {1, 9}, {nan, 0}, {2, 8}, {3, 7}};
    picture.line(points);
    picture.line(std::vector<Eigen::Vector2d>{{nan, nan}});
    picture.dot({nan, 0}, 1);
    picture.polygon(std::vector<Eigen::Vector2d>{{0, 0}, {1, 0}, {0, 1}});
    const XmlElement svg = parse_xml(picture.text());
    const auto paths = svg.all("path");
    REQUIRE(paths.size() == 2);
    CHECK(paths[0]->attributes.at("d") == "M0 0L10 10M20 20L30 30");
    CHECK(paths[1]->attributes.at("d") == "M0 100L10 100L0 90Z");
    CHECK(svg.all("circle").empty());
}

TEST_CASE("a clipped group refers to the box of the picture") {
    Svg picture({0, 0}, {1, 1}, 100, 10);
    picture.begin_clipped_group("inside", {});
    picture.end_group();
    const XmlElement svg = parse_xml(picture.text());
    CHECK(svg.all("g").at(0)->attributes.at("clip-path") == "url(#box)");
    CHECK(svg.all("clipPath").at(0)->attributes.at("id") == "box");
    CHECK(svg.all("clipPath").at(0)->children.at(0).attributes.at("width") == "100");
}
