// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/normals.h"

#include <catch2/catch.hpp>

#include "tests/apps/reconstruct/clouds.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::reconstruct;

namespace {

// Share of the normals that are off by more than the angle [degree].
double share_off(const Cloud& cloud, const std::vector<Vector3>& axes, const std::vector<Vector3>& truth,
                 double angle) {
    std::size_t off = 0;
    for (std::size_t i = 0; i < axes.size(); ++i)
        off += std::abs(axes[i].dot(truth[cloud.original[i]])) < std::cos(angle * std::numbers::pi / 180) ? 1 : 0;
    return static_cast<double>(off) / static_cast<double>(axes.size());
}

}  // namespace

TEST_CASE("normals of a sphere are radial") {
    core::Random random(tests::seed(1));
    const tests::OrientedCloud points = tests::sphere_cloud({1, 2, 3}, 2, 3000, random);
    const Cloud cloud = prepared_cloud(points.points, {}, "sphere");
    CHECK(share_off(cloud, cloud_axes(cloud, 0, {}), points.normals, 8) < 0.02);
}

TEST_CASE("normals next to the edges of a box are those of a face, not of both") {
    core::Random random(tests::seed(1));
    const tests::OrientedCloud points = tests::box_cloud({Point3(0, 0, 0), Point3(1, 1, 1)}, 4000, random);
    const Cloud cloud = prepared_cloud(points.points, {}, "box");
    // Planes of all neighbours are off at a quarter of the points.
    CHECK(share_off(cloud, cloud_axes(cloud, 0, {}), points.normals, 5) < 0.03);
}

TEST_CASE("the noise is what was added, and a clean curved surface has none") {
    core::Random random(tests::seed(1));
    tests::OrientedCloud points = tests::sphere_cloud({0, 0, 0}, 1, 6000, random);
    CHECK(estimated_noise(prepared_cloud(points.points, {}, "clean")) * 3.46 < 0.002);
    for (const double noise : {0.01, 0.02}) {
        tests::OrientedCloud noisy = points;
        tests::add_noise(noisy, noise, random);
        const Cloud cloud = prepared_cloud(noisy.points, {}, "noisy");
        CHECK(estimated_noise(cloud) * cloud.scale == Approx(noise).epsilon(0.3));
    }
}
