// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/orientation.h"

#include <catch2/catch.hpp>

#include "apps/reconstruct/normals.h"
#include "tests/apps/reconstruct/clouds.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::reconstruct;

namespace {

double share_turned(const tests::OrientedCloud& points) {
    const Cloud cloud = prepared_cloud(points.points, {}, "points");
    core::Observer observer;
    const Orientation found = oriented_normals(cloud, cloud_axes(cloud, 0, {}), 0, {}, observer);
    std::size_t turned = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i)
        turned += found.normals[i].dot(points.normals[cloud.original[i]]) < 0 ? 1 : 0;
    return static_cast<double>(turned) / static_cast<double>(cloud.size());
}

}  // namespace

TEST_CASE("normals point outwards, and into a cavity") {
    core::Random random(tests::seed(1));
    CHECK(share_turned(tests::torus_cloud(1, 0.4, 2000, random)) < 0.001);
    tests::OrientedCloud hollow = tests::box_cloud({Point3(-1, -1, -1), Point3(1, 1, 1)}, 3000, random);
    tests::OrientedCloud cavity = tests::sphere_cloud({0, 0, 0}, 0.5, 500, random);
    for (Vector3& n : cavity.normals) n = -n;
    tests::add(hollow, cavity);
    CHECK(share_turned(hollow) < 0.005);
}

TEST_CASE("the sides of a plate that is two spacings thick point away from each other") {
    core::Random random(tests::seed(1));
    // Spacing sqrt(2.16 / 3000) = 0.027.
    CHECK(share_turned(tests::box_cloud({Point3(0, 0, 0), Point3(1, 1, 0.055)}, 3000, random)) < 0.03);
}

TEST_CASE("a plate of two spacings is not thinned away among many points", "[slow]") {
    core::Random random(tests::seed(1));
    // Spacing sqrt(2.07 / 25000) = 0.0091; half of the points would leave a plate of 1.4 spacings.
    CHECK(share_turned(tests::box_cloud({Point3(0, 0, 0), Point3(1, 1, 0.0182)}, 25000, random)) < 0.01);
}
