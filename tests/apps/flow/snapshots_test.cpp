// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/snapshots.h"

#include <catch2/catch.hpp>

#include "dsc3d/generate/lattice.h"
#include "tests/support/temporary_folder.h"

using namespace dsc;
using namespace dsc::flow;

TEST_CASE("snapshots go to a series of files and to one surface for each pair of labels") {
    geometry::TetData data = dsc3d::lattice({Point3(0, 0, 0), Point3(1, 1, 1)}, 0.25);
    for (const auto& tet : data.tets) {
        const Point3 p =
            (data.vertices[tet[0]] + data.vertices[tet[1]] + data.vertices[tet[2]] + data.vertices[tet[3]]) / 4;
        data.labels.push_back(p.z() < 0.5 ? 0 : p.x() < 0.5 ? 1 : 2);
    }
    const dsc3d::Mesh mesh(data);
    const tests::TemporaryFolder folder;
    Snapshots snapshots(folder.path(), 4, 3);
    for (int step = 0; step < 4; ++step) snapshots.add(mesh, step, 0.25 * step);
    snapshots.add_last(mesh, 3, 0.75);
    CHECK(folder.content() ==
          std::vector<std::string>{"series.pvd", "series_0000.vtp", "series_0001.vtp", "series_0002.vtp"});
    const std::vector<io::ViewSurfaceSeries> series = snapshots.series();
    REQUIRE(series.size() == 3);
    for (const io::ViewSurfaceSeries& surface : series) {
        CHECK(surface.times == std::vector<double>{0, 0.5, 0.75});
        REQUIRE(surface.frames.size() == 3);
        CHECK_FALSE(surface.frames[2].triangles.empty());
    }
    CHECK(series[2].name == "between 1 and 2");

    const tests::TemporaryFolder empty;
    Snapshots none(empty.path(), 4, 0);
    none.add(mesh, 0, 0);
    none.add_last(mesh, 1, 1);
    CHECK(empty.content().empty());
}
