// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/checkpoint.h"

#include <catch2/catch.hpp>
#include <optional>

#include "apps/flow/flow.h"
#include "apps/flow/initial_mesh.h"
#include "apps/flow/resume.h"
#include "apps/flow/targets.h"
#include "io/atomic_file.h"
#include "tests/apps/flow/stop_after.h"
#include "tests/support/temporary_folder.h"

using namespace dsc;
using namespace dsc::flow;

namespace {

constexpr int steps = 10, interval = 3;

/// A small ball that shrinks, from its start or from the checkpoint in its folder.
struct SavedFlow {
    SavedFlow(const std::filesystem::path& folder, bool is_resumed)
        : path(apps::checkpoint_path(folder)),
          checkpoints(path, checkpoint_kind, io::Json::object(), interval),
          snapshots(folder, steps, 4) {
        if (is_resumed) {
            auto saved = apps::CheckpointFile(path, checkpoint_kind).run<SavedRun>();
            mesh.emplace(saved.state.tets);
            result.domain = saved.state.domain;
            result.edge_length = saved.state.edge_length;
            take_over(std::move(saved), result, snapshots, checkpoints);
        } else {
            core::Observer observer;
            const InitialMesh initial =
                initial_mesh({.shape = Shape::sphere, .radius = 0.2, .edge_length = 0.1}, observer);
            mesh.emplace(initial.data);
            result.domain = initial.domain;
            result.edge_length = initial.edge_length;
        }
        result.time = time_steps({.until = 0.01, .steps = steps}, {});
    }
    void go(core::Observer& observer) {
        MotionOptions motion;
        motion.motion = Motion::curvature;
        run_flow(*mesh, {.edge_length = result.edge_length}, motion_targets(motion, result.domain, result.time.until),
                 snapshots, observer, result, &checkpoints);
    }
    io::Json timeless_report() const {
        io::Json report = report_json(result, {});
        report["seconds"] = 0;
        for (std::size_t i = 0; i < report["steps"].size(); ++i) report["steps"][i]["ms"] = 0;
        return report;
    }

    std::filesystem::path path;
    Checkpoints checkpoints;
    Snapshots snapshots;
    std::optional<dsc3d::Mesh> mesh;
    FlowResult result;
};

}  // namespace

TEST_CASE("a run that is interrupted goes on from the checkpoint before, and becomes the same run") {
    const tests::TemporaryFolder one, other;
    core::Observer observer;
    SavedFlow undisturbed(one.path(), false);
    undisturbed.go(observer);
    REQUIRE(undisturbed.result.end == FlowEnd::done);

    tests::StopAfter stop(8);
    SavedFlow interrupted(other.path(), false);
    interrupted.go(stop);
    REQUIRE(interrupted.result.end == FlowEnd::cancelled);
    REQUIRE(interrupted.result.steps.back().step == 8);

    SavedFlow resumed(other.path(), true);
    CHECK(resumed.result.steps.back().step == 6);
    CHECK(resumed.result.seconds > 0);
    CHECK(resumed.result.steps[5].milliseconds == interrupted.result.steps[5].milliseconds);
    resumed.go(observer);
    CHECK(resumed.mesh->data().vertices == undisturbed.mesh->data().vertices);
    CHECK(resumed.mesh->data().tets == undisturbed.mesh->data().tets);
    CHECK(resumed.mesh->data().labels == undisturbed.mesh->data().labels);
    CHECK(resumed.timeless_report() == undisturbed.timeless_report());
    CHECK(other.content() == one.content());
    for (const std::string& name : one.content())
        if (name != "checkpoint") CHECK(io::read_file(one / name) == io::read_file(other / name));
}
