// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/fluid/tracked_fluid.h"

#include <catch2/catch.hpp>
#include <numeric>

#include "apps/fluid/initial_mesh.h"
#include "core/errors.h"
#include "dsc3d/components.h"

using namespace dsc;
using namespace dsc::fluid_app;

namespace {

TrackedState start_of(const Scene& scene, double& edge_length) {
    core::Observer observer;
    InitialMesh mesh = initial_mesh(scene, observer);
    edge_length = mesh.edge_length;
    return {.tets = std::move(mesh.tets), .velocities = std::move(mesh.velocities)};
}

TrackedParameters parameters_of(const Scene& scene, double edge_length) {
    TrackedParameters parameters{.container = Container(scene)};
    parameters.flow.fluid.gravity = scene.gravity;
    parameters.flow.tensions = {.free_surface = {scene.tension}};
    parameters.deform.edge_length = edge_length;
    parameters.deform.growth = tracked_growth;
    return parameters;
}

Scene coarse_drop() {
    Scene scene = named_scene("droplet");
    scene.edge_length = 0.4;
    return scene;
}

double energy(const TrackedFluid& fluid) { return fluid.flow().energies(fluid.fluid(), fluid.contacts()).sum(); }

}  // namespace

TEST_CASE("a drop in free fall falls as its integrator does", "[fluid]") {
    Scene scene = coarse_drop();
    scene.gravity = Point3(0, 0, -9.81);
    scene.domain.min().z() = -4;
    double edge_length = 0;
    const TrackedState start = start_of(scene, edge_length);
    dsc3d::Listener listener;
    TrackedFluid fluid(start, parameters_of(scene, edge_length), listener);
    const auto centre = [&] {
        return fluid::motion_of<3>(fluid.fluid().mesh.positions, fluid.fluid().masses, fluid.fluid().velocities).centre;
    };
    const double before = centre().z();
    double speed = 0, fallen = 0;
    for (int i = 0; i < 12; ++i) {
        const double dt = fluid.longest_step(0.05);
        fluid.step(dt);
        speed -= 9.81 * dt;
        fallen += speed * dt;
    }
    REQUIRE(fallen < -0.1);
    // The drop oscillates, and masses follow the volumes of cells that are not quite kept.
    CHECK(centre().z() - before == Approx(fallen).epsilon(1e-4));
}

TEST_CASE("a drop that oscillates keeps its momenta, and gains hardly any energy", "[fluid]") {
    Scene scene = coarse_drop();
    scene.balls[0].spin = Point3(0, 0.3, 0);
    scene.balls[0].velocity = Point3(0.1, 0.2, 0);
    double edge_length = 0;
    const TrackedState start = start_of(scene, edge_length);
    dsc3d::Listener listener;
    TrackedFluid fluid(start, parameters_of(scene, edge_length), listener);
    const auto motion = [&] {
        return fluid::motion_of<3>(fluid.fluid().mesh.positions, fluid.fluid().masses, fluid.fluid().velocities);
    };
    const auto before = motion();
    const double energy_before = energy(fluid);
    for (int i = 0; i < 30; ++i) {
        fluid.step(fluid.longest_step(1));
        CHECK(energy(fluid) < energy_before * (1 + 1e-3));
    }
    CHECK((motion().momentum - before.momentum).norm() < 1e-10);
    CHECK((motion().angular_momentum - before.angular_momentum).norm() < 1e-10);
    CHECK(dsc3d::validate(fluid.mesh()).empty());
}

TEST_CASE("water in a tank stays at rest", "[fluid]") {
    Scene scene = named_scene("tank");
    scene.edge_length = 0.25;
    double edge_length = 0;
    const TrackedState start = start_of(scene, edge_length);
    dsc3d::Listener listener;
    TrackedFluid fluid(start, parameters_of(scene, edge_length), listener);
    for (int i = 0; i < 20; ++i) {
        fluid.step(0.02);
        for (const Point3& velocity : fluid.fluid().velocities) REQUIRE(velocity.norm() < 1e-8 * std::sqrt(9.81 * 0.5));
    }
}

TEST_CASE("drops that collide become one, and its volume is that of both", "[fluid]") {
    Scene scene = named_scene("collide");
    scene.domain = {Point3(-3, -2, -2), Point3(3, 2, 2)};
    scene.edge_length = 0.4;
    for (Ball& ball : scene.balls) ball.centre *= 1.06 / 1.3;
    double edge_length = 0;
    const TrackedState start = start_of(scene, edge_length);
    dsc3d::Listener listener;
    TrackedFluid fluid(start, parameters_of(scene, edge_length), listener);
    REQUIRE(fluid.fluid().kept_volumes.size() == 2);
    const double volume = fluid.fluid().kept_volumes[0] + fluid.fluid().kept_volumes[1];
    for (int i = 0; i < 60 && fluid.fluid().kept_volumes.size() > 1; ++i) fluid.step(fluid.longest_step(0.02));
    REQUIRE(fluid.fluid().kept_volumes.size() == 1);
    CHECK(fluid.fluid().kept_volumes[0] == Approx(volume).epsilon(1e-12));
    for (int i = 0; i < 15; ++i) fluid.step(fluid.longest_step(0.02));
    CHECK(fluid::Elements<3>(fluid.fluid().mesh).total_volume() == Approx(volume).epsilon(1e-3));
    const auto motion =
        fluid::motion_of<3>(fluid.fluid().mesh.positions, fluid.fluid().masses, fluid.fluid().velocities);
    CHECK(motion.momentum.norm() < 1e-10);
    CHECK(dsc3d::validate(fluid.mesh()).empty());
}

TEST_CASE("fluid stays in its vessel, and comes to rest on its floor", "[fluid][slow]") {
    Scene scene = named_scene("vessel");
    scene.edge_length = 0.35;
    scene.balls = {{.centre = Point3(0, 0, -1), .radius = 0.8, .velocity = Point3(0, 0, -1)}};
    double edge_length = 0;
    const TrackedState start = start_of(scene, edge_length);
    dsc3d::Listener listener;
    TrackedFluid fluid(start, parameters_of(scene, edge_length), listener);
    const double volume = fluid::Elements<3>(fluid.fluid().mesh).total_volume();
    for (int i = 0; i < 25; ++i) {
        fluid.step(fluid.longest_step(0.03));
        for (const Point3& place : fluid.fluid().mesh.positions) CHECK(place.norm() <= 2 * (1 + 1e-12));
    }
    CHECK(fluid.contacts().size() > 3);
    CHECK(fluid::Elements<3>(fluid.fluid().mesh).total_volume() == Approx(volume).epsilon(2e-3));
    CHECK(dsc3d::validate(fluid.mesh()).empty());
}

TEST_CASE("a step that can't be made leaves everything as it was", "[fluid]") {
    const Scene scene = coarse_drop();
    double edge_length = 0;
    TrackedState start = start_of(scene, edge_length);
    for (Point3& velocity : start.velocities) velocity = Point3(100, 0, 0);
    dsc3d::Listener listener;
    TrackedFluid fluid(start, parameters_of(scene, edge_length), listener);
    const TrackedState before = fluid.state();
    CHECK_THROWS_WITH(fluid.step(0.1), Catch::Contains("leaves the domain"));
    const TrackedState after = fluid.state();
    CHECK(after.tets.vertices == before.tets.vertices);
    CHECK(after.velocities == before.velocities);
    CHECK(after.pressures == before.pressures);
}
