// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/deformer.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "core/errors.h"
#include "core/random.h"
#include "dsc3d/generate/fit.h"
#include "dsc3d/generate/lattice.h"
#include "tests/dsc3d/volumes.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;

namespace {

using Targets = std::vector<std::optional<Point3>>;

Mesh box_with(const std::function<double(const Point3&)>& function, double spacing) {
    Mesh mesh(lattice({Point3(0, 0, 0), Point3(1, 1, 1)}, spacing));
    fit(mesh, function);
    return mesh;
}

double ball(const Point3& p) { return (p - Point3(0.5, 0.65, 0.5)).norm() - 0.2; }

double two_balls(const Point3& p) {
    return std::min((p - Point3(0.3, 0.5, 0.5)).norm(), (p - Point3(0.7, 0.5, 0.5)).norm()) - 0.14;
}

template <class Flow>
Targets targets_of(const Mesh& mesh, Flow&& flow) {
    Targets targets(mesh.complex().vertex_capacity());
    for (std::uint32_t i = 0; i < targets.size(); ++i) {
        const VertexId v(i);
        if (!mesh.complex().is_deleted(v) && mesh.complex().is_interface(v)) targets[i] = flow(mesh.position(v));
    }
    return targets;
}

}  // namespace

TEST_CASE("a turning ball keeps its triangles and its volume, and every vertex arrives") {
    Mesh mesh = box_with(ball, 0.12);
    Deformer deformer(mesh, {.edge_length = 0.1});
    const auto triangles = interface_triangles(mesh.complex());
    const double volume = volume_of_label(mesh, 1);
    const Eigen::AngleAxisd turn(0.03, Point3::UnitZ());
    const Point3 pivot(0.5, 0.5, 0.5);
    for (int step = 0; step < 20; ++step) {
        const Targets targets = targets_of(mesh, [&](const Point3& p) { return Point3(pivot + turn * (p - pivot)); });
        const StepReport report = deformer.step(targets);
        REQUIRE(report.is_complete);
        REQUIRE(report.unfinished.empty());
        for (std::uint32_t i = 0; i < targets.size(); ++i)
            if (targets[i]) REQUIRE(mesh.position(VertexId(i)) == *targets[i]);
        REQUIRE(validate(mesh).empty());
    }
    CHECK(interface_triangles(mesh.complex()) == triangles);
    CHECK(volume_of_label(mesh, 1) == Approx(volume).epsilon(1e-12));
    CHECK(volume_of_label(mesh, 0) + volume_of_label(mesh, 1) == Approx(1).epsilon(1e-12));
}

TEST_CASE("balls that are driven into each other are stopped, and what is left of their motion is reported") {
    Mesh mesh = box_with(two_balls, 0.12);
    Deformer deformer(mesh, {.edge_length = 0.1});
    const auto triangles = interface_triangles(mesh.complex());
    REQUIRE(components_of_label(mesh.complex(), 1) == 2);
    std::size_t stopped = 0;
    for (int step = 0; step < 8; ++step) {
        const Targets targets =
            targets_of(mesh, [](const Point3& p) { return Point3(p + Point3(p.x() < 0.5 ? 0.02 : -0.02, 0, 0)); });
        const StepReport report = deformer.step(targets);
        for (const auto& unfinished : report.unfinished) {
            const Point3 target = *targets[unfinished.vertex.index()];
            REQUIRE((mesh.position(unfinished.vertex) + unfinished.remaining - target).norm() < 1e-15);
        }
        CHECK(report.is_complete == report.unfinished.empty());
        stopped += report.unfinished.size();
        REQUIRE(validate(mesh).empty());
        REQUIRE(components_of_label(mesh.complex(), 1) == 2);
        REQUIRE(components_of_label(mesh.complex(), 0) == 1);
    }
    CHECK(stopped > 0);
    CHECK(interface_triangles(mesh.complex()) == triangles);
    CHECK(volume_of_label(mesh, 0) + volume_of_label(mesh, 1) == Approx(1).epsilon(1e-12));
}

TEST_CASE("random motion leaves a valid mesh, also towards the boundary of the domain and far beyond it") {
    Mesh mesh = box_with(ball, 0.15);
    Deformer deformer(mesh, {.edge_length = 0.12});
    core::Random random(seed(1));
    for (int step = 0; step < 15; ++step) {
        const double reach = step % 5 == 4 ? 3 : 0.03;
        const Targets targets = targets_of(mesh, [&](const Point3& p) {
            const double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach),
                         z = random.uniform(-reach, reach);
            return Point3(p + Point3(x, y, z));
        });
        deformer.step(targets);
        REQUIRE(validate(mesh).empty());
        REQUIRE(volume_of_label(mesh, 0) + volume_of_label(mesh, 1) == Approx(1).epsilon(1e-12));
    }
}

TEST_CASE("a step says what is wrong with a target, and a deformer with a parameter") {
    Mesh mesh = box_with(ball, 0.2);
    CHECK_THROWS_AS(Deformer(mesh, {.edge_length = 0}), core::UsageError);
    CHECK_THROWS_AS(Deformer(mesh, {.edge_length = 0.1, .approach = 1}), core::UsageError);
    Deformer deformer(mesh, {.edge_length = 0.1});
    for (std::uint32_t i = 0; i < mesh.complex().vertex_capacity(); ++i) {
        const VertexId v(i);
        Targets targets(mesh.complex().vertex_capacity());
        targets[i] = mesh.position(v);
        if (!mesh.complex().is_interface(v)) REQUIRE_THROWS_AS(deformer.step(targets), core::UsageError);
        targets[i]->x() = std::numeric_limits<double>::quiet_NaN();
        REQUIRE_THROWS_AS(deformer.step(targets), core::UsageError);
    }
}
