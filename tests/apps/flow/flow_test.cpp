// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/flow.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>

#include "apps/flow/initial_mesh.h"
#include "apps/flow/sizing.h"
#include "apps/flow/targets.h"
#include "core/errors.h"
#include "dsc3d/generate/fit.h"
#include "dsc3d/generate/lattice.h"
#include "dsc3d/interface.h"
#include "tests/apps/flow/stop_after.h"
#include "tests/support/temporary_folder.h"

using namespace dsc;
using namespace dsc::flow;

namespace {

/// A small ball in the unit box, and a run of it.
struct Run {
    explicit Run(int steps) {
        core::Observer observer;
        const InitialMesh initial = initial_mesh({.shape = Shape::sphere, .radius = 0.2, .edge_length = 0.1}, observer);
        mesh.emplace(initial.data);
        result.domain = initial.domain;
        result.edge_length = initial.edge_length;
        result.time = time_steps({.steps = steps}, {});
    }
    void go(const Targets& targets, core::Observer& observer,
            motion::TopologyPolicy policy = motion::TopologyPolicy::adaptive) {
        Snapshots snapshots(folder.path(), result.time.count, 2);
        run_flow(*mesh, {.edge_length = result.edge_length, .topology = policy}, targets, snapshots, observer, result);
    }

    tests::TemporaryFolder folder;
    std::optional<dsc3d::Mesh> mesh;
    FlowResult result;
};

}  // namespace

TEST_CASE("a ball that is turned by 90 degrees is the ball turned by 90 degrees") {
    Run run(9);
    std::vector<Point3> before;
    for (const Point3& p : dsc3d::Interface(*run.mesh).data.surface.vertices) before.push_back(p);
    core::Observer observer;
    MotionOptions motion;
    motion.angle = 90;
    run.go(motion_targets(motion, run.result.domain, run.result.time.until), observer);
    CHECK(run.result.end == FlowEnd::done);
    REQUIRE(run.result.steps.size() == 10);
    CHECK(validate(*run.mesh).empty());
    for (const StepRecord& step : run.result.steps) {
        CHECK(step.inverted == 0);
        CHECK(step.is_complete);
        CHECK(step.unchanged_share == 1);
        CHECK(step.labels[1].volume == Approx(run.result.steps.front().labels[1].volume).epsilon(1e-12));
    }
    const std::vector<Point3> after = dsc3d::Interface(*run.mesh).data.surface.vertices;
    REQUIRE(after.size() == before.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
        const Point3 d = before[i] - Point3(0.5, 0.5, 0.5);
        CHECK((after[i] - Point3(0.5 - d.y(), 0.5 + d.x(), 0.5 + d.z())).norm() < 1e-13);
    }
}

TEST_CASE("balls that meet are one event, in the step and at the place where they do") {
    for (const auto policy : {motion::TopologyPolicy::adaptive, motion::TopologyPolicy::preserved}) {
        dsc3d::Mesh mesh(dsc3d::lattice({Point3(0, 0, 0), Point3(1, 1, 1)}, 0.12));
        fit(mesh, [](const Point3& p) {
            return std::min((p - Point3(0.3, 0.5, 0.5)).norm(), (p - Point3(0.7, 0.5, 0.5)).norm()) - 0.14;
        });
        Run run(8);
        run.mesh.emplace(mesh.data());
        core::Observer observer;
        const Targets together = [](const dsc3d::Mesh& now, double, double) -> StepMotion {
            StepMotion wanted{std::vector<std::optional<Point3>>(now.complex().vertex_capacity()), nullptr};
            for (const dsc3d::VertexId v : dsc3d::Interface(now).vertices)
                wanted.targets[v.index()] = now.position(v) + Point3(now.position(v).x() < 0.5 ? 0.02 : -0.02, 0, 0);
            return wanted;
        };
        run.go(together, observer, policy);
        std::map<std::string, int> kinds;
        for (const auto& event : run.result.events) {
            ++kinds[event.kind];
            CHECK(event.step >= 1);
            CHECK(event.step <= 8);
            CHECK(event.time == run.result.time.time(event.step));
            CHECK(event.label == 0);
            CHECK((event.place - Point3(0.5, 0.5, 0.5)).norm() < 0.15);
        }
        const bool may_merge = policy == motion::TopologyPolicy::adaptive;
        CHECK(kinds["merge"] == (may_merge ? 1 : 0));
        CHECK(kinds["vanish"] == 0);  // what has merged is still there
        CHECK((kinds["contact"] > 0) == !may_merge);
        CHECK(kinds["split"] == 0);
        CHECK(run.result.steps.front().labels[1].components == 2);
        CHECK(run.result.steps.back().labels[1].components == (may_merge ? 1 : 2));
        std::size_t changes = 0;
        for (const StepRecord& step : run.result.steps) changes += step.counts.topology_changes;
        CHECK(changes == (may_merge ? 1 : 0));
    }
}

TEST_CASE("a run that is stopped keeps the steps made, and one whose targets are no numbers says where") {
    {
        Run run(20);
        tests::StopAfter observer(3);
        run.go(motion_targets({}, run.result.domain, 1), observer);
        CHECK(run.result.end == FlowEnd::cancelled);
        CHECK(run.result.steps.size() == 4);
        CHECK(validate(*run.mesh).empty());
    }
    Run run(20);
    core::Observer observer;
    const Targets bad = [](const dsc3d::Mesh& mesh, double time, double) -> StepMotion {
        std::vector<std::optional<Point3>> targets(mesh.complex().vertex_capacity());
        const dsc3d::VertexId v = dsc3d::Interface(mesh).vertices[5];
        targets[v.index()] = time < 0.1 ? mesh.position(v) : Point3(std::nan(""), 0, 0);
        return {targets, nullptr};
    };
    run.go(bad, observer);
    CHECK(run.result.end == FlowEnd::stopped);
    CHECK_THAT(run.result.reason, Catch::Contains("vertex") && Catch::Contains("not finite"));
    CHECK(run.result.steps.size() == 3);
    CHECK(run.folder.content().size() == 3);
}

TEST_CASE("a motion out of the domain, and a size that stops being one, end a run in its last good state") {
    core::Observer observer;
    {
        Run run(10);
        const MotionOptions motion{.motion = Motion::translate, .velocity = Point3(1, 0, 0)};
        run.go(motion_targets(motion, run.result.domain, 1), observer, motion::TopologyPolicy::preserved);
        CHECK(run.result.end == FlowEnd::stopped);
        CHECK_THAT(run.result.reason, Catch::Contains("vertex") && Catch::Contains("out of the domain"));
        CHECK(run.result.steps.back().labels[1].volume ==
              Approx(run.result.steps.front().labels[1].volume).epsilon(0.01));
    }
    {
        // Where it may touch the wall, it goes into it.
        Run run(10);
        const MotionOptions motion{.motion = Motion::translate, .velocity = Point3(1, 0, 0)};
        run.go(motion_targets(motion, run.result.domain, 1), observer);
        CHECK(run.result.end == FlowEnd::vanished);
    }
    Run run(10);
    const MotionOptions motion{.motion = Motion::translate, .velocity = Point3(0.2, 0, 0)};
    const Targets targets = motion_targets(motion, run.result.domain, 1);
    CHECK_THROWS_AS(run.go(with_sizing(targets, "0", 0.1), observer), core::UsageError);
    Run later(10);
    later.go(with_sizing(targets, "0.35 - t", 0.1), observer);
    CHECK(later.result.end == FlowEnd::stopped);
    CHECK_THAT(later.result.reason, Catch::Contains("--sizing") && Catch::Contains("at time 0.4"));
    CHECK(later.result.steps.size() == 5);
    CHECK(validate(*later.mesh).empty());
}

TEST_CASE("an interface is refined where shorter edges are wanted, towards the ball that its triangles suggest") {
    core::Observer observer;
    Run run(6);
    const MotionOptions motion{.motion = Motion::translate, .velocity = Point3(0.1, 0, 0)};
    const Targets targets = motion_targets(motion, run.result.domain, 1);
    const std::size_t before = dsc3d::Interface(*run.mesh).data.surface.triangles.size();
    run.go(with_sizing(targets, "x < 0.55 ? 0.1 : 0.04", run.result.edge_length), observer);
    REQUIRE(run.result.end == FlowEnd::done);
    CHECK(run.result.steps.back().interface_faces > before + before / 2);
    const double ball = 4 * std::numbers::pi / 3 * std::pow(0.2, 3);
    const double start = run.result.steps.front().labels[1].volume, end = run.result.steps.back().labels[1].volume;
    CHECK(end < ball);
    CHECK(ball - end < (ball - start) / 2);
}

TEST_CASE("a run whose targets can't be computed ends in its last good state") {
    Run run(20);
    core::Observer observer;
    const Targets failing = [](const dsc3d::Mesh& mesh, double time, double) -> StepMotion {
        if (time >= 0.1) throw core::RunError("no solution");
        return {std::vector<std::optional<Point3>>(mesh.complex().vertex_capacity()), nullptr};
    };
    run.go(failing, observer);
    CHECK(run.result.end == FlowEnd::stopped);
    CHECK(run.result.reason == "no solution");
    CHECK(run.result.steps.size() == 3);
    CHECK(validate(*run.mesh).empty());
}
