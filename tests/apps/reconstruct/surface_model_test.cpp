// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/surface_model.h"

#include <catch2/catch.hpp>

#include "tests/apps/reconstruct/clouds.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::reconstruct;

namespace {

struct Model {
    Cloud cloud;
    KdTree tree;
    std::vector<Vector3> normals;
    SurfaceModel model;

    explicit Model(const tests::OrientedCloud& points)
        : cloud(prepared_cloud(points.points, {}, "points")),
          tree(cloud.points),
          normals(true_normals(cloud, points)),
          model(cloud, tree, normals, 0, {}) {}

    static std::vector<Vector3> true_normals(const Cloud& cloud, const tests::OrientedCloud& points) {
        std::vector<Vector3> normals;
        for (const std::uint32_t i : cloud.original) normals.push_back(points.normals[i]);
        return normals;
    }
    SurfacePlace place(const Point3& x, double reach) const {
        SurfacePlace found = model.place((x - cloud.origin) / cloud.scale, reach / cloud.scale, reach / cloud.scale);
        found.point = cloud.to_input(found.point);
        return found;
    }
};

}  // namespace

TEST_CASE("places next to faces, edges and corners of a box are on them") {
    core::Random random(tests::seed(1));
    const Model box(tests::box_cloud({Point3(0, 0, 0), Point3(1, 1, 1)}, 6000, random));
    SurfacePlace found = box.place({0.5, 0.4, 1.02}, 0.05);
    REQUIRE(found.sides == 1);
    CHECK((found.point - Point3(0.5, 0.4, 1)).norm() < 1e-6);
    found = box.place({0.98, 0.4, 1.01}, 0.05);
    REQUIRE(found.sides == 2);
    CHECK((found.point - Point3(1, 0.4, 1)).norm() < 1e-6);
    CHECK(std::abs(found.normals[0].dot(found.normals[1])) < 1e-6);
    found = box.place({0.98, 0.02, 1.01}, 0.06);
    REQUIRE(found.sides == 3);
    CHECK((found.point - Point3(1, 0, 1)).norm() < 1e-6);
    found = box.place({0.98, 0.4, 1.01}, 0);
    CHECK(found.sides == 1);
}

TEST_CASE("places on a sphere are nearer to it the denser the points are, and no crease is seen") {
    double last = 1;
    for (const std::size_t count : {1000, 4000}) {
        core::Random random(tests::seed(1));
        const Model sphere(tests::sphere_cloud({0, 0, 0}, 1, count, random));
        double sum = 0;
        for (int i = 0; i < 200; ++i) {
            const Vector3 x = Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)).normalized();
            const SurfacePlace found = sphere.place(1.01 * x, 0.1);
            REQUIRE(found.sides == 1);
            sum += std::abs(found.point.norm() - 1);
        }
        const double mean = sum / 200;
        // Four times as many points: half the spacing, so that an error of the second order is a quarter.
        CHECK(mean < 0.35 * last);
        last = mean;
    }
    CHECK(last < 1e-3);
}
