// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/targets.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>

#include "apps/flow/initial_mesh.h"
#include "core/errors.h"
#include "dsc3d/mesh.h"

using namespace dsc;
using namespace dsc::flow;

namespace {

const Point3 centre(0.5, 0.5, 0.5);

dsc3d::Mesh mesh_of(const ShapeOptions& shape) {
    core::Observer observer;
    return dsc3d::Mesh(initial_mesh(shape, observer).data);
}

dsc3d::Mesh small_sphere() { return mesh_of({.shape = Shape::sphere, .radius = 0.2, .edge_length = 0.1}); }

std::vector<std::optional<Point3>> targets_of(const dsc3d::Mesh& mesh, const MotionOptions& motion, double time,
                                              double dt) {
    return motion_targets(motion, Eigen::AlignedBox3d(Point3(0, 0, 0), Point3(1, 1, 1)), 1)(mesh, time, dt).targets;
}

/// The mean distance of the targets from the centre.
double mean_radius(const std::vector<std::optional<Point3>>& targets) {
    double sum = 0;
    int count = 0;
    for (const auto& target : targets) {
        if (!target) continue;
        sum += (*target - centre).norm();
        ++count;
    }
    return sum / count;
}

template <class Use>
void for_each_target(const dsc3d::Mesh& mesh, const std::vector<std::optional<Point3>>& targets, Use&& use) {
    int count = 0;
    for (std::uint32_t i = 0; i < targets.size(); ++i) {
        if (!targets[i]) continue;
        ++count;
        REQUIRE(mesh.complex().is_interface(dsc3d::VertexId(i)));
        use(mesh.position(dsc3d::VertexId(i)), *targets[i]);
    }
    REQUIRE(count > 0);
}

}  // namespace

TEST_CASE("a velocity in words is integrated to the fifth power of the step, and knows the time") {
    const dsc3d::Mesh mesh = small_sphere();
    MotionOptions motion{.motion = Motion::expression, .expressions = "(-y, x, t)"};
    const double time = 0.3, dt = 0.1;
    const Eigen::AngleAxisd turn(dt, Point3::UnitZ());
    for_each_target(mesh, targets_of(mesh, motion, time, dt), [&](const Point3& from, const Point3& to) {
        const Point3 exact = turn * from + Point3(0, 0, (time + dt / 2) * dt);
        CHECK((to - exact).norm() < std::pow(dt, 5) / 100);
    });
}

TEST_CASE("the deformations of the unit cube come back when half the period has passed twice") {
    const dsc3d::Mesh mesh = small_sphere();
    for (const Motion kind : {Motion::enright, Motion::vortex}) {
        const MotionOptions motion{.motion = kind, .period = 2};
        const double dt = 0.02;
        const auto forwards = targets_of(mesh, motion, 1 - dt, dt), backwards = targets_of(mesh, motion, 1, dt);
        // Around half the period the velocity is odd in time: one step mirrors the other.
        for (std::size_t i = 0; i < forwards.size(); ++i) {
            REQUIRE(forwards[i].has_value() == backwards[i].has_value());
            if (!forwards[i]) continue;
            const Point3 there = *forwards[i] - mesh.position(dsc3d::VertexId(static_cast<std::uint32_t>(i)));
            const Point3 back = *backwards[i] - mesh.position(dsc3d::VertexId(static_cast<std::uint32_t>(i)));
            CHECK((there + back).norm() < 0.01 * there.norm() + 1e-9);
        }
    }
}

TEST_CASE(
    "a shear takes everything along its direction, by the distance along the gradient from the point that stays") {
    const dsc3d::Mesh mesh = small_sphere();
    const MotionOptions motion{
        .motion = Motion::shear, .about = Point3(0, 0.4, 0), .direction = Point3(0, 0, 3), .gradient = Point3(0, 2, 0)};
    for_each_target(mesh, targets_of(mesh, motion, 0, 0.1), [&](const Point3& from, const Point3& to) {
        CHECK((to - from - Point3(0, 0, 0.1 * 6 * (from.y() - 0.4))).norm() < 1e-14);
    });
    CHECK_THROWS_AS(motion_targets({.motion = Motion::shear, .gradient = Point3(1, 1, 0)}, {}, 1), core::UsageError);
}

TEST_CASE("curl noise has the largest speed it was given, other seeds, and stays within the walls") {
    const dsc3d::Mesh mesh = small_sphere();
    const Eigen::AlignedBox3d domain(Point3(0, 0, 0), Point3(1, 1, 1));
    MotionOptions motion{.motion = Motion::curl_noise, .speed = 0.5, .seed = 7};
    const double dt = 0.01;
    double largest = 0;
    const auto targets = targets_of(mesh, motion, 0, dt);
    for_each_target(mesh, targets, [&](const Point3& from, const Point3& to) {
        largest = std::max(largest, (to - from).norm() / dt);
    });
    CHECK(largest > 0.05);
    CHECK(largest < 0.5 * (1 + 1e-6));
    CHECK(targets_of(mesh, motion, 0.3, dt) == targets);
    motion.seed = 8;
    CHECK(targets_of(mesh, motion, 0, dt) != targets);
    // From next to a wall for a long time.
    const StepMotion step = motion_targets(motion, domain, 1)(mesh, 0, 1);
    Point3 p(0.4, 0.6, 1e-3);
    for (int i = 0; i < 1000; ++i) p = step.path(p, 0.01);
    CHECK(domain.contains(p));
}

TEST_CASE("a ball shrinks by its curvature at twice the inverse of its radius") {
    const dsc3d::Mesh mesh = small_sphere();
    const double before =
        mean_radius(targets_of(mesh, {.motion = Motion::translate, .velocity = Point3(0, 0, 0)}, 0, 1));
    const double dt = 1e-5;
    const double after = mean_radius(targets_of(mesh, {.motion = Motion::curvature}, 0, dt));
    CHECK((before - after) / dt == Approx(2 / before).epsilon(0.05));
}

TEST_CASE("offsetting a box moves its corners, edges and faces by the distance along each axis") {
    const dsc3d::Mesh mesh = mesh_of({.shape = Shape::box, .edge_length = 0.1});
    Eigen::AlignedBox3d box;
    for_each_target(mesh, targets_of(mesh, {.motion = Motion::translate, .velocity = Point3(0, 0, 0)}, 0, 1),
                    [&](const Point3& from, const Point3&) { box.extend(from); });
    for (const double distance : {0.04, -0.04}) {
        // The whole distance takes the time 1.
        const MotionOptions motion{.motion = Motion::offset, .distance = 2 * distance};
        for_each_target(mesh, targets_of(mesh, motion, 0, 0.5), [&](const Point3& from, const Point3& to) {
            for (int k = 0; k < 3; ++k) {
                const double way = from[k] == box.max()[k] ? distance : from[k] == box.min()[k] ? -distance : 0;
                CHECK(std::abs(to[k] - from[k] - way) < 1e-12);
            }
        });
    }
}

TEST_CASE("a velocity that can't be read is refused before anything is moved") {
    const MotionOptions motion{.motion = Motion::expression, .expressions = "(-y, x)"};
    CHECK_THROWS_AS(motion_targets(motion, {}, 1), core::InputError);
}
