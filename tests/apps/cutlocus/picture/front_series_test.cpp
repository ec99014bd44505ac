// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/picture/front_series.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

#include "tests/apps/cutlocus/picture/samples.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/xml.h"

using namespace dsc::cutlocus;
using dsc::tests::parse_xml;
using dsc::tests::PictureSample;

namespace {

std::string content(const std::filesystem::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("the series has a file per snapshot, in ascending order of time") {
    for (const PictureSample* sample : {&dsc::tests::torus_sample(), &dsc::tests::flat_sample()}) {
        const dsc::tests::TemporaryFolder folder;
        write_front_series(folder / "fronts", sample->metric, sample->p, sample->locus.front);
        const auto index = parse_xml(content(folder / "fronts/front.pvd"));
        const auto entries = index.all("DataSet");
        REQUIRE(entries.size() == sample->locus.front.snapshots.size());
        double before = 0;
        for (const auto* entry : entries) {
            const double time = std::stod(entry->attributes.at("timestep"));
            CHECK(time > before);
            before = time;
            const auto file = parse_xml(content(folder / ("fronts/" + entry->attributes.at("file"))));
            CHECK(file.all("Piece").size() == 1);
            std::vector<std::string> names;
            for (const auto* data : file.all("PointData").at(0)->all("DataArray"))
                names.push_back(data->attributes.at("Name"));
            CHECK(names == std::vector<std::string>{"chart", "distance", "theta"});
        }
    }
}
