// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/kd_tree.h"

#include <catch2/catch.hpp>

#include <algorithm>

#include "tests/apps/reconstruct/clouds.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::reconstruct;

TEST_CASE("nearest points are those of a search through all") {
    core::Random random(tests::seed(1));
    std::vector<geometry::Point3> points;
    for (int i = 0; i < 700; ++i) points.emplace_back(random.uniform(), random.uniform(), 0.01 * random.uniform());
    points.push_back(points.front());  // equal ones ascend by number
    const KdTree tree(points);
    std::vector<KdTree::Neighbour> found;
    for (int query = 0; query < 40; ++query) {
        const geometry::Point3 p(random.uniform(-0.2, 1.2), random.uniform(), random.uniform(-0.1, 0.1));
        std::vector<KdTree::Neighbour> all;
        for (std::uint32_t i = 0; i < points.size(); ++i) all.push_back({(points[i] - p).squaredNorm(), i});
        std::sort(all.begin(), all.end());
        tree.nearest(p, 17, found);
        REQUIRE(found.size() == 17);
        for (std::size_t k = 0; k < found.size(); ++k) CHECK(found[k].index == all[k].index);
        CHECK(tree.nearest(p).index == all.front().index);
        tree.within(p, 0.2, found);
        const auto near =
            std::count_if(all.begin(), all.end(), [](const auto& a) { return a.squared_distance <= 0.04; });
        REQUIRE(static_cast<std::ptrdiff_t>(found.size()) == near);
        for (std::size_t k = 0; k < found.size(); ++k) CHECK(found[k].index == all[k].index);
    }
    tree.nearest(points.front(), 10000, found);
    CHECK(found.size() == points.size());
}
