// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/html_view.h"

#include <catch2/catch.hpp>
#include <limits>

#include "io/json.h"

using namespace dsc::io;

namespace {

const std::string nasty = "</script><script>alert(1)</script><!-- & \" 'λ'";

HtmlPage example() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const ViewLine line{{0, 0, 0}, {1, 0, 0.5}, {nan, nan, nan}, {1, 1, 1}};
    HtmlView view{.name = nasty};
    view.surfaces.push_back({.name = nasty,
                             .vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1.0 / 3, 0}},
                             .triangles = {{0, 1, 2}},
                             .colours = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                             .opacity = 0.5});
    view.tets = ViewTets{.name = nasty,
                         .vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1.0 / 3}},
                         .tets = {{0, 1, 2, 3}},
                         .values = {0.25},
                         .value_name = nasty};
    view.lines.push_back({.name = "arcs", .lines = {line, {}}});
    view.points.push_back({.name = "p", .positions = {{0, 0, 0}}, .labels = {nasty}});
    view.series.push_back({.name = "front", .times = {0.5, 1}, .frames = {{line}, {line, line}}});
    view.surface_series.push_back(
        {.name = nasty,
         .times = {0, 2},
         .frames = {{.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}}}, {}}});
    view.fan = ViewFan{.name = "geodesics", .rays = {line}, .values = {{0, 1, 2, 3}}, .labels = {"θ = 0"}};
    return {.title = nasty,
            .facts = {{"length", nasty}},
            .figure = "<svg>" + nasty + "</svg>",
            .views = {view, HtmlView{.name = "chart", .is_flat = true}}};
}

// The text of the JSON element as a browser sees it: up to the next "</script".
Json scene_of(const std::string& page) {
    const std::string start = "<script type=\"application/json\" id=\"scene\">";
    const std::size_t begin = page.find(start) + start.size();
    return Json::parse(page.substr(begin, page.find("</script", begin) - begin));
}

// The page without what stands in its script elements.
std::string markup_of(const std::string& page) {
    std::string markup;
    std::size_t at = 0;
    for (std::size_t begin; (begin = page.find("<script", at)) != std::string::npos;
         at = page.find("</script", begin)) {
        markup += page.substr(at, page.find('>', begin) + 1 - at);
    }
    return markup + page.substr(at);
}

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t n = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
    return n;
}

}  // namespace

TEST_CASE("the scene in the page is the scene that was given, whatever texts it has") {
    const Json scene = scene_of(html_page(example()));
    CHECK(scene["title"].string() == nasty);
    CHECK(scene["facts"][0][1].string() == nasty);
    REQUIRE(scene["views"].size() == 2);
    CHECK(scene["views"][1]["flat"].boolean());
    const Json& view = scene["views"][0];
    CHECK(view["surfaces"][0]["vertices"].size() == 9);
    CHECK(view["surfaces"][0]["vertices"][7].number() == Approx(1.0 / 3).epsilon(1e-6));
    CHECK(view["surfaces"][0]["triangles"].size() == 3);
    CHECK(view["surfaces"][0]["colours"].size() == 9);
    CHECK(view["surfaces"][0]["opacity"].number() == 0.5);
    CHECK(view["tets"]["name"].string() == nasty);
    CHECK(view["tets"]["valueName"].string() == nasty);
    CHECK(view["tets"]["vertices"].size() == 12);
    CHECK(view["tets"]["tets"] == Json::array({0, 1, 2, 3}));
    CHECK(view["tets"]["values"][0].number() == 0.25);
    CHECK(view["tets"]["best"].number() == 1);
    CHECK(view["lines"][0]["lines"][0].size() == 12);
    CHECK(view["lines"][0]["lines"][0][6].is_null());
    CHECK(view["lines"][0]["lines"][1].size() == 0);
    CHECK(view["points"][0]["labels"][0].string() == nasty);
    CHECK(view["series"][0]["frames"][1].size() == 2);
    CHECK(view["surfaceSeries"][0]["name"].string() == nasty);
    CHECK(view["surfaceSeries"][0]["times"].size() == 2);
    CHECK(view["surfaceSeries"][0]["frames"][0]["vertices"].size() == 9);
    CHECK(view["surfaceSeries"][0]["frames"][0]["triangles"] == Json::array({0, 1, 2}));
    CHECK(view["surfaceSeries"][0]["frames"][1]["triangles"].size() == 0);
    CHECK(view["fan"]["values"][0].size() == 4);
    CHECK(scene["views"][1]["fan"].is_null());
    CHECK(scene["views"][1]["tets"].is_null());
    CHECK(scene["figure"].string() == "<svg>" + nasty + "</svg>");
    CHECK_FALSE(scene["sharesCamera"].boolean());
}

TEST_CASE("no text of the scene can end its element or begin another one") {
    const std::string page = html_page(example());
    // One element for the scene, seven for three.js, its parts and the viewer.
    CHECK(count(page, "</script") == 8);
    CHECK(count(markup_of(page), "<script") == 8);
    CHECK(count(markup_of(page), "alert(1)") == count(markup_of(page), "&lt;script&gt;alert(1)&lt;/script&gt;"));
    HtmlPage with_script = example();
    with_script.script = "const text = '</script><!--';";
    CHECK(count(html_page(with_script), "</script") == 9);
}

TEST_CASE("the page loads nothing and keeps the licence of three.js") {
    const std::string page = html_page(example());
    CHECK(page.find("default-src 'none'") != std::string::npos);
    const std::string markup = markup_of(page);
    CHECK(markup.find("src=") == std::string::npos);
    CHECK(markup.find("href=") == std::string::npos);
    CHECK(markup.find("url(") == std::string::npos);
    CHECK(markup.find("@import") == std::string::npos);
    CHECK(markup.find("://") == std::string::npos);
    CHECK(page.find("The MIT License") != std::string::npos);
    CHECK(page.find("WebGLRenderer") != std::string::npos);
    CHECK(page.find("OrbitControls") != std::string::npos);
}
