// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/cloud.h"

#include <catch2/catch.hpp>

#include "core/errors.h"
#include "tests/apps/reconstruct/clouds.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::reconstruct;

namespace {

tests::OrientedCloud sphere(std::size_t count) {
    core::Random random(tests::seed(1));
    return tests::sphere_cloud({0, 0, 0}, 1, count, random);
}

}  // namespace

TEST_CASE("the spacing squared is the area of the surface for each point") {
    const tests::OrientedCloud points = sphere(4000);
    const Cloud cloud = prepared_cloud(points.points, {}, "sphere");
    const double area = 4 * std::numbers::pi / static_cast<double>(points.points.size());
    CHECK(cloud.median_spacing * cloud.scale == Approx(std::sqrt(area)).epsilon(0.05));
    CHECK(cloud.strays.empty());
    CHECK(cloud.to_input(cloud.points[7]).isApprox(points.points[cloud.original[7]], 1e-12));
}

TEST_CASE("equal points count once, and points far off are strays") {
    tests::OrientedCloud points = sphere(1500);
    points.points.push_back(points.points[3]);
    points.points.emplace_back(0, 0, 0);
    points.points.emplace_back(3, 3, 3);
    points.points.emplace_back(1e5, 0, 0);
    const Cloud cloud = prepared_cloud(points.points, {}, "sphere");
    CHECK(cloud.duplicates == 1);
    CHECK(cloud.strays == std::vector<std::uint32_t>{1501, 1502, 1503});
    CHECK(cloud.scale == Approx(std::sqrt(12)).epsilon(0.01));
}

TEST_CASE("strays near each other are no part of the surface") {
    tests::OrientedCloud points = sphere(10000);
    core::Random random(tests::seed(2));
    std::vector<std::uint32_t> strays;
    for (int i = 0; i < 19; ++i) {
        strays.push_back(static_cast<std::uint32_t>(points.points.size()));
        // As far from the surface as from each other.
        points.points.emplace_back(1.2 + random.uniform(), random.uniform(), random.uniform());
    }
    CHECK(prepared_cloud(points.points, {}, "sphere").strays == strays);
}

TEST_CASE("a stray, however far, takes no digits from the others") {
    tests::OrientedCloud points = sphere(1500);
    points.points.emplace_back(1e12, 0, 0);
    const Cloud cloud = prepared_cloud(points.points, {}, "sphere");
    CHECK(cloud.strays == std::vector<std::uint32_t>{1500});
    CHECK(cloud.to_input(cloud.points[7]).isApprox(points.points[cloud.original[7]], 1e-12));
}

TEST_CASE("points that enclose nothing are refused") {
    const auto refused = [](const std::vector<Point3>& points, const std::string& word) {
        CHECK_THROWS_WITH(prepared_cloud(points, {}, "few.xyz"), Catch::Contains("few.xyz") && Catch::Contains(word));
        CHECK_THROWS_AS(prepared_cloud(points, {}, "few.xyz"), core::InputError);
    };
    refused({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}}, "3 different points");
    refused(std::vector<Point3>(10, Point3(1, 2, 3)), "1 different points");
    std::vector<Point3> line, plane;
    for (int i = 0; i < 30; ++i) {
        line.emplace_back(i, 2 * i, -i);
        plane.emplace_back(i % 6, i * i % 7, 0.5 * (i % 6) + 1);
    }
    refused(line, "on a line");
    refused(plane, "in a plane");
    refused({{-1e200, 0, 0}, {1e200, 0, 0}, {0, 1, 0}, {0, 0, 1}}, "too large");
}

TEST_CASE("parameters out of their range are refused by name") {
    CloudParameters parameters;
    parameters.neighbours = 3;
    CHECK_THROWS_WITH(parameters.validate(), Catch::Contains("neighbours"));
    parameters = {};
    parameters.stray_distance = 0.5;
    CHECK_THROWS_WITH(parameters.validate(), Catch::Contains("stray_distance"));
}
