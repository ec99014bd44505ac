// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/dipole_sum.h"

#include <catch2/catch.hpp>

#include "tests/apps/reconstruct/clouds.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::reconstruct;

namespace {

struct Sphere {
    tests::OrientedCloud cloud;
    std::vector<Vector3> moments;
    std::vector<double> widths;

    explicit Sphere(std::size_t count) {
        core::Random random(tests::seed(1));
        cloud = tests::sphere_cloud({0.1, 0.2, 0.3}, 0.5, count, random);
        for (const Vector3& n : cloud.normals) moments.emplace_back(n * std::numbers::pi / static_cast<double>(count));
        widths.assign(count, 0.02);
    }
};

// The definition, term by term.
double winding_number(const Sphere& sphere, const geometry::Point3& x) {
    double sum = 0;
    for (std::size_t i = 0; i < sphere.moments.size(); ++i) {
        const Vector3 d = sphere.cloud.points[i] - x;
        const double r = std::max(d.norm(), sphere.widths[i]);
        sum += sphere.moments[i].dot(d) / (4 * std::numbers::pi * r * r * r);
    }
    return sum;
}

}  // namespace

TEST_CASE("the winding number is that of its definition: 1 inside a sphere, 0 outside") {
    const Sphere sphere(4000);
    const KdTree tree(sphere.cloud.points);
    const DipoleSum sum(tree, sphere.cloud.points, 0);
    core::Random random(tests::seed(2));
    std::vector<geometry::Point3> places;
    for (int i = 0; i < 200; ++i)
        places.emplace_back(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const std::vector<double> found = sum.winding_numbers(sum.targets(places), sphere.moments, sphere.widths);
    for (std::size_t i = 0; i < places.size(); ++i) {
        CHECK(found[i] == Approx(winding_number(sphere, places[i])).margin(0.02));
        const double distance = (places[i] - geometry::Point3(0.1, 0.2, 0.3)).norm();
        if (std::abs(distance - 0.5) > 0.1) CHECK(found[i] == Approx(distance < 0.5 ? 1 : 0).margin(0.05));
    }
}

TEST_CASE("the gradient is that of the winding number") {
    const Sphere sphere(600);
    const KdTree tree(sphere.cloud.points);
    const DipoleSum sum(tree, sphere.cloud.points, 0);
    const std::vector<geometry::Point3> places{{0.1, 0.2, 0.9}, {0.5, 0.4, 0.0}, {0.15, 0.2, 0.3}};
    const std::vector<Vector3> found = sum.gradients(sum.targets(places), sphere.moments, sphere.widths);
    for (std::size_t i = 0; i < places.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            constexpr double h = 1e-5;
            const Vector3 step = h * Vector3::Unit(axis);
            const double slope =
                (winding_number(sphere, places[i] + step) - winding_number(sphere, places[i] - step)) / (2 * h);
            CHECK(found[i][axis] == Approx(slope).margin(0.05));
        }
    }
}

TEST_CASE("the adjoint gives the same product from the other side") {
    const Sphere sphere(800);
    const KdTree tree(sphere.cloud.points);
    const DipoleSum sum(tree, sphere.cloud.points, 0);
    const DipoleSum::Targets targets = sum.targets(sphere.cloud.points);
    core::Random random(tests::seed(3));
    std::vector<double> strengths;
    for (std::size_t i = 0; i < sphere.moments.size(); ++i) strengths.push_back(random.uniform());
    const std::vector<double> winding = sum.winding_numbers(targets, sphere.moments, sphere.widths);
    const std::vector<Vector3> adjoint = sum.adjoints(targets, strengths, sphere.widths);
    double one_side = 0, other_side = 0;
    for (std::size_t i = 0; i < strengths.size(); ++i) {
        one_side += strengths[i] * winding[i];
        other_side += adjoint[i].dot(sphere.moments[i]);
    }
    CHECK(one_side == Approx(other_side).epsilon(0.03));
}
