// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/improve/histogram_picture.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/apps/improve/samples.h"
#include "tests/support/xml.h"

using namespace dsc;
using namespace dsc::improve;

namespace {

const tests::XmlElement* group(const tests::XmlElement& picture, const std::string& name) {
    for (const tests::XmlElement* element : picture.all("g"))
        if (element->attributes.at("data-name") == name) return element;
    return nullptr;
}

std::size_t red_bars(const tests::XmlElement& bars) {
    const auto paths = bars.all("path");
    return static_cast<std::size_t>(
        std::ranges::count_if(paths, [](const auto* bar) { return bar->attributes.contains("fill"); }));
}

}  // namespace

TEST_CASE("the picture has a bar for each 2 degrees in which there are angles") {
    const tests::ImprovedBox box;
    const tests::XmlElement picture =
        tests::parse_xml(histogram_picture({{"before", box.improvement.before}, {"after", *box.improvement.after}}));
    for (const auto& [name, mesh] : {std::pair("before", box.improvement.before), {"after", *box.improvement.after}}) {
        const tests::XmlElement* bars = group(picture, name);
        REQUIRE(bars != nullptr);
        const auto histogram = angle_histogram(mesh, 90);
        CHECK(static_cast<std::ptrdiff_t>(bars->all("path").size()) ==
              std::ranges::count_if(histogram, [](std::size_t count) { return count > 0; }));
    }
    CHECK(picture.all("text").front()->text.find("before: ") == 0);
}

TEST_CASE("the few angles of a structured mesh are cut off and marked beside one with all kinds of angles") {
    const tests::ImprovedBox box;
    const tests::XmlElement both =
        tests::parse_xml(histogram_picture({{"before", box.improvement.before}, {"after", *box.improvement.after}}));
    CHECK(red_bars(*group(both, "after")) == 3);
    const tests::XmlElement alone = tests::parse_xml(histogram_picture({{"after", *box.improvement.after}}));
    CHECK(red_bars(*group(alone, "after")) == 0);
}

TEST_CASE("any name may be given") {
    const tests::ImprovedBox box;
    const std::string nasty = "</svg> & \"λ\"";
    const tests::XmlElement picture = tests::parse_xml(histogram_picture({{nasty, box.improvement.before}}));
    CHECK(group(picture, nasty) != nullptr);
}
