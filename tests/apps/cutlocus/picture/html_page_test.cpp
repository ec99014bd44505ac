// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/picture/html_page.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>

#include "tests/apps/cutlocus/picture/samples.h"
#include "tests/support/temporary_folder.h"

using namespace dsc::cutlocus;
using dsc::io::HtmlPage;
using dsc::tests::PictureSample;

TEST_CASE("the page of a surface in space has two views, that of a metric only the chart") {
    const PictureSample& torus = dsc::tests::torus_sample();
    const HtmlPage page = html_page(torus.metric, torus.p, torus.locus, {.surface = "torus"});
    REQUIRE(page.views.size() == 2);
    CHECK_FALSE(page.views[0].is_flat);
    CHECK(page.views[1].is_flat);
    const PictureSample& flat = dsc::tests::flat_sample();
    const HtmlPage chart = html_page(flat.metric, flat.p, flat.locus);
    REQUIRE(chart.views.size() == 1);
    CHECK(chart.views[0].is_flat);
}

TEST_CASE("every sample of the fan has its distance, which grows along a ray") {
    const PictureSample& torus = dsc::tests::torus_sample();
    for (const dsc::io::HtmlView& view : html_page(torus.metric, torus.p, torus.locus).views) {
        REQUIRE(view.fan);
        REQUIRE(view.fan->rays.size() == view.fan->values.size());
        for (std::size_t i = 0; i < view.fan->rays.size(); ++i) {
            const auto& values = view.fan->values[i];
            REQUIRE(values.size() == view.fan->rays[i].size());
            CHECK(values.front() == 0);
            CHECK(std::is_sorted(values.begin(), values.end()));
            CHECK(values.back() <= torus.locus.graph.farthest.distance + 1e-5);
            CHECK(values.back() >= torus.locus.graph.nearest.distance - 1e-5);
        }
        CHECK(view.series.at(0).times.size() == torus.locus.front.snapshots.size());
    }
}

TEST_CASE("nothing in the chart leads across the seams") {
    const PictureSample& torus = dsc::tests::seam_sample();
    const HtmlPage page = html_page(torus.metric, torus.p, torus.locus);
    const double longest = 2 * std::numbers::pi / 10;
    const auto check = [&](const dsc::io::ViewLine& line) {
        for (std::size_t i = 1; i < line.size(); ++i)
            if (line[i].allFinite() && line[i - 1].allFinite()) CHECK((line[i] - line[i - 1]).norm() < longest);
    };
    for (const auto& lines : page.views.at(1).lines)
        for (const auto& line : lines.lines) check(line);
    for (const auto& frame : page.views[1].series.at(0).frames)
        for (const auto& line : frame) check(line);
    for (const auto& ray : page.views[1].fan->rays) check(ray);
}

TEST_CASE("the page is one file below 8 MB that loads nothing") {
    const PictureSample& torus = dsc::tests::torus_sample();
    const dsc::tests::TemporaryFolder folder;
    write_html(folder / "locus.html", torus.metric, torus.p, torus.locus);
    CHECK(folder.content() == std::vector<std::string>{"locus.html"});
    std::ifstream file(folder / "locus.html");
    const std::string text(std::istreambuf_iterator<char>(file), {});
    CHECK(text.size() < 8'000'000);
    CHECK(text.find("default-src 'none'") != std::string::npos);
    CHECK(text.find("<link") == std::string::npos);
    CHECK(text.find("<script src") == std::string::npos);
    CHECK(text.find("<img") == std::string::npos);
}
