// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/parts.h"

#include <catch2/catch.hpp>
#include <numeric>

#include "tests/fluid/samples.h"

using namespace dsc;
using namespace dsc::fluid;

namespace {

// Discs beside each other, with these radii.
SimplexMesh<2> discs(const std::vector<double>& radii) {
    SimplexMesh<2> result;
    double x = 0;
    for (const double radius : radii) {
        const SimplexMesh<2> one = disc(2);
        const auto first = static_cast<std::uint32_t>(result.positions.size());
        for (const auto& p : one.positions) result.positions.push_back(radius * p + Vector<2>(x, 0));
        for (const auto& cell : one.cells) result.cells.push_back({cell[0] + first, cell[1] + first, cell[2] + first});
        x += 10;
    }
    result.phases.assign(result.cells.size(), 0);
    return result;
}

}  // namespace

TEST_CASE("drops are parts, and so are phases that touch", "[fluid]") {
    SimplexMesh<2> mesh = discs({1, 2});
    const Elements<2> elements(mesh);
    const Parts two = parts<2>(mesh, elements, facets(mesh));
    REQUIRE(two.volumes.size() == 2);
    CHECK(two.volumes[1] == Approx(4 * two.volumes[0]));
    mesh.phases[0] = 1;
    CHECK(parts<2>(mesh, elements, facets(mesh)).volumes.size() == 3);
}

TEST_CASE("drops that merge and split share the volume they had", "[fluid]") {
    const SimplexMesh<2> mesh = discs({1, 2, 1});
    const Parts parts = fluid::parts<2>(mesh, Elements<2>(mesh), facets(mesh));
    const double unit = parts.volumes[0];
    // Before, the first two were one drop of volume 8, and the third one of 4 was there already.
    std::vector<std::int32_t> old_part(mesh.positions.size());
    for (std::size_t i = 0; i < old_part.size(); ++i) old_part[i] = mesh.positions[i].x() < 15 ? 0 : 1;
    const PartGroups groups = group_parts<2>(2, old_part, mesh, parts);
    CHECK(groups.count == 2);
    CHECK(groups.of_new == std::vector<std::size_t>{0, 0, 1});
    const auto kept = regrouped_volumes(std::vector<double>{8, 4}, groups, parts);
    REQUIRE(kept.size() == 3);
    CHECK(kept[0] == Approx(8.0 / 5));
    CHECK(kept[1] == Approx(8.0 * 4 / 5));
    CHECK(kept[2] == Approx(4));
    // A part that grows by a tenth of what it misses in a step of 0.1.
    const auto growth = compensating_growth(Elements<2>(mesh).volumes, parts, kept, 0.1, 0.1);
    double sum = 0;
    for (std::size_t j = 0; j < growth.size(); ++j)
        if (parts.of_cell[j] == 2) sum += growth[j];
    CHECK(sum == Approx(4 - unit));
}

TEST_CASE("the volume of a drop that has vanished goes to the others", "[fluid]") {
    const SimplexMesh<2> mesh = discs({1, 1});
    const Parts parts = fluid::parts<2>(mesh, Elements<2>(mesh), facets(mesh));
    std::vector<std::int32_t> old_part(mesh.positions.size());
    for (std::size_t i = 0; i < old_part.size(); ++i) old_part[i] = mesh.positions[i].x() < 5 ? 0 : 1;
    const PartGroups groups = group_parts<2>(3, old_part, mesh, parts);
    const auto kept = regrouped_volumes(std::vector<double>{4, 5, 6}, groups, parts);
    CHECK(std::accumulate(kept.begin(), kept.end(), 0.0) == Approx(15));
    CHECK(kept[0] == Approx(7));
    CHECK(kept[1] == Approx(8));
}
