// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/improve/html_page.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/apps/improve/samples.h"
#include "tests/support/xml.h"

using namespace dsc;
using namespace dsc::improve;

TEST_CASE("the page has a view of the mesh before and one after, turned together, and the histograms") {
    const tests::ImprovedBox box;
    const io::HtmlPage page = html_page(box.improvement, box.before, &box.after);
    REQUIRE(page.views.size() == 2);
    CHECK(page.views[0].name == "before");
    CHECK(page.views[1].name == "after");
    CHECK(page.shares_camera);
    CHECK(page.title == "box.mesh");
    CHECK(page.views[0].tets->tets.size() == box.before.tets.size());
    CHECK(page.views[0].tets->values == qualities(box.before, box.improvement.parameters.measure));
    CHECK_FALSE(tests::parse_xml(page.figure).all("g").empty());
    CHECK(io::html_page(page).size() < 2'000'000);
}

TEST_CASE("the page of a mesh that stays as it is has one view") {
    const tests::ImprovedBox box;
    CHECK(html_page(box.judged(), box.before, nullptr).views.size() == 1);
}

TEST_CASE("of a large mesh the worst tetrahedra are shown, at their places") {
    const tests::ImprovedBox box;
    const io::HtmlPage page = html_page(box.improvement, box.before, &box.after, {.most_tets = 50});
    const io::ViewTets& shown = *page.views[0].tets;
    REQUIRE(shown.tets.size() == 50);
    CHECK(shown.name == "the worst 50 of 384 tetrahedra");
    std::vector<double> quality = qualities(box.before, box.improvement.parameters.measure);
    std::ranges::sort(quality);
    CHECK(std::ranges::max(shown.values) == quality[49]);
    for (std::size_t i = 0; i < shown.tets.size(); ++i) {
        const auto& [a, b, c, d] = shown.tets[i];
        CHECK(geometry::quality(box.improvement.parameters.measure, shown.vertices.at(a), shown.vertices.at(b),
                                shown.vertices.at(c), shown.vertices.at(d)) == shown.values[i]);
    }
    // All of the unshaken box are equal: the first ones are taken.
    CHECK(page.views[1].tets->vertices.front() == box.after.vertices[box.after.tets[0][0]]);
}
