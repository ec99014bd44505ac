// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/denoising.h"

#include <catch2/catch.hpp>

#include "apps/reconstruct/quadratic_patch.h"
#include "tests/apps/reconstruct/clouds.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::reconstruct;

namespace {

struct NoisyCloud {
    Cloud cloud;
    std::vector<Vector3> normals;  ///< the true ones

    NoisyCloud(tests::OrientedCloud points, double noise, core::Random& random) {
        tests::add_noise(points, noise, random);
        cloud = prepared_cloud(points.points, {}, "points");
        for (const std::uint32_t i : cloud.original) normals.push_back(points.normals[i]);
    }
};

}  // namespace

TEST_CASE(
    "a patch through points of a paraboloid is the paraboloid, and its standard error that of a mean where flat") {
    QuadraticPatch patch(Point3(0, 0, 0.1), Vector3::UnitZ(), 1);
    for (int i = -3; i <= 3; ++i)
        for (int j = -3; j <= 3; ++j) patch.add({0.1 * i, 0.1 * j, 0.2 + 0.05 * i + 0.03 * i * j});
    patch.solve();
    CHECK((patch.point() - Point3(0, 0, 0.2)).norm() < 1e-9);
    CHECK((patch.normal() - Vector3(-0.5, 0, 1).normalized()).norm() < 1e-9);
    const double quadratic = patch.standard_error();
    patch.stiffen(1e6, 1e6);
    CHECK(patch.standard_error() == Approx(1.0 / 7).epsilon(0.05));
    CHECK(quadratic > patch.standard_error());
}

TEST_CASE("a noisy sphere becomes smoother by far and keeps its radius") {
    core::Random random(tests::seed(1));
    constexpr double noise = 0.02;
    NoisyCloud sphere(tests::sphere_cloud({0, 0, 0}, 1, 5000, random), noise, random);
    const double left = denoise(sphere.cloud, sphere.normals, noise / sphere.cloud.scale, {}) * sphere.cloud.scale;
    CHECK(left < 0.5 * noise);
    double sum = 0, squares = 0;
    for (const Point3& p : sphere.cloud.points) {
        const double off = sphere.cloud.to_input(p).norm() - 1;
        sum += off;
        squares += off * off;
    }
    const auto count = static_cast<double>(sphere.cloud.size());
    CHECK(std::sqrt(squares / count) < 0.3 * noise);
    CHECK(std::abs(sum / count) < 0.05 * noise);
}

TEST_CASE("points next to the edge of a noisy box stay on their side") {
    core::Random random(tests::seed(1));
    constexpr double noise = 0.01;
    NoisyCloud box(tests::box_cloud({Point3(0, 0, 0), Point3(1, 1, 1)}, 6000, random), noise, random);
    const std::vector<Vector3> truth = box.normals;
    denoise(box.cloud, box.normals, noise / box.cloud.scale, {});
    double squares = 0;
    for (std::size_t i = 0; i < box.cloud.size(); ++i) {
        const Point3 p = box.cloud.to_input(box.cloud.points[i]);
        const double height = truth[i].dot(p);
        const double off = truth[i].sum() > 0 ? height - 1 : height;
        squares += off * off;
    }
    CHECK(std::sqrt(squares / static_cast<double>(box.cloud.size())) < 0.25 * noise);
}

TEST_CASE("a cloud without noise is left as it is") {
    core::Random random(tests::seed(1));
    NoisyCloud sphere(tests::sphere_cloud({0, 0, 0}, 1, 500, random), 0, random);
    const std::vector<Point3> before = sphere.cloud.points;
    CHECK(denoise(sphere.cloud, sphere.normals, 0, {}) == 0);
    CHECK(sphere.cloud.points == before);
}
