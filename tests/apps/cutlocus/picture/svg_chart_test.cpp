// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/picture/svg_chart.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <sstream>

#include "apps/cutlocus/picture/polyline.h"
#include "apps/cutlocus/picture/svg_front.h"
#include "core/errors.h"
#include "tests/apps/cutlocus/picture/samples.h"
#include "tests/support/xml.h"

using namespace dsc::cutlocus;
using dsc::tests::parse_xml;
using dsc::tests::PictureSample;
using dsc::tests::XmlElement;

namespace {

std::vector<Polyline> lines_of_path(const std::string& data) {
    std::vector<Polyline> lines;
    std::string spaced;
    for (const char c : data)
        spaced += c == 'M' || c == 'L' || c == 'Z' ? std::string(" ") + c + " " : std::string(1, c);
    std::istringstream words(spaced);
    for (std::string word; words >> word;) {
        if (word == "Z") continue;
        if (word == "M") lines.emplace_back();
        Point2 x;
        words >> x.x() >> x.y();
        lines.back().push_back(x);
    }
    return lines;
}

std::vector<Polyline> drawn_lines(const XmlElement& svg, const std::string& group) {
    std::vector<Polyline> lines;
    for (const XmlElement* g : svg.all("g")) {
        if (g->attributes.at("data-name") != group) continue;
        for (const XmlElement* path : g->all("path"))
            for (Polyline& line : lines_of_path(path->attributes.at("d"))) lines.push_back(std::move(line));
    }
    return lines;
}

double length(const std::vector<Polyline>& lines) {
    double sum = 0;
    for (const Polyline& line : lines)
        for (std::size_t i = 1; i < line.size(); ++i) sum += (line[i] - line[i - 1]).norm();
    return sum;
}

std::vector<Polyline> arcs(const CutGraph& graph) {
    std::vector<Polyline> lines;
    for (const CutArc& arc : graph.arcs) {
        lines.emplace_back();
        for (const CutSample& sample : arc.samples) lines.back().push_back(sample.x);
    }
    return lines;
}

/// All lines in the picture, and none across it.
void check_lines(const XmlElement& svg, int columns) {
    const double width = std::stod(svg.attributes.at("width")), height = std::stod(svg.attributes.at("height"));
    CHECK(svg.attributes.at("viewBox") == "0 0 " + svg.attributes.at("width") + " " + svg.attributes.at("height"));
    for (const XmlElement* g : svg.all("g")) {
        const std::string& name = g->attributes.at("data-name");
        for (const Polyline& line : drawn_lines(svg, name)) {
            for (std::size_t i = 0; i < line.size(); ++i) {
                CHECK((line[i].x() >= 0 && line[i].x() <= width && line[i].y() >= 0 && line[i].y() <= height));
                if (i > 0 && name != "axes") CHECK((line[i] - line[i - 1]).norm() <= width / columns / 10);
            }
        }
    }
}

}  // namespace

TEST_CASE("a chart shows the whole cut locus and nothing across the picture") {
    for (const PictureSample* sample : {&dsc::tests::torus_sample(), &dsc::tests::flat_sample()}) {
        const std::string text = svg_chart(sample->metric, sample->p, sample->locus);
        CHECK(text.size() < 400'000);
        const XmlElement svg = parse_xml(text);
        check_lines(svg, 1);
        const double scale = 800 / *sample->metric.periods().u;
        CHECK(length(drawn_lines(svg, "cut locus")) == Approx(scale * length(arcs(sample->locus.graph))).epsilon(0.01));
        CHECK(!drawn_lines(svg, "geodesics").empty());
        CHECK(!drawn_lines(svg, "distance circles").empty());
    }
}

TEST_CASE("a cut locus on the seams is seen on both sides") {
    const PictureSample& sample = dsc::tests::seam_sample();
    const XmlElement svg = parse_xml(svg_chart(sample.metric, sample.p, sample.locus));
    check_lines(svg, 1);
    const auto lines = drawn_lines(svg, "cut locus");
    // Both borders twice, and the part of the outer equator beyond the conjugate points.
    const double equator = 2 * (std::numbers::pi - std::numbers::pi / std::sqrt(3.0));
    CHECK(length(lines) == Approx(4 * 800 + 800 / (2 * std::numbers::pi) * equator).epsilon(0.01));
}

TEST_CASE("geodesics beyond the cut locus and the growing front are drawn without jumps") {
    for (const PictureSample* sample : {&dsc::tests::torus_sample(), &dsc::tests::flat_sample()}) {
        const std::string geodesics = svg_geodesics(sample->metric, sample->p, sample->locus);
        const std::string front = svg_front(sample->metric, sample->p, sample->locus.front);
        CHECK(geodesics.size() < 400'000);
        CHECK(front.size() < 400'000);
        check_lines(parse_xml(geodesics), 1);
        check_lines(parse_xml(front), 3);
    }
}

TEST_CASE("a picture has title and surface, or neither") {
    const PictureSample& sample = dsc::tests::flat_sample();
    const auto with = svg_chart(sample.metric, sample.p, sample.locus, {.surface = "flat < torus"});
    CHECK(with.find("Cut locus of p = (0.1, 0.2), flat &lt; torus") != std::string::npos);
    const auto without = svg_chart(sample.metric, sample.p, sample.locus, {.has_title = false});
    CHECK(without.find("Cut locus of") == std::string::npos);
}

TEST_CASE("a front without snapshots can't be drawn") {
    const PictureSample& sample = dsc::tests::flat_sample();
    FrontResult front = sample.locus.front;
    front.snapshots.clear();
    CHECK_THROWS_AS(svg_front(sample.metric, sample.p, front), dsc::core::UsageError);
}
