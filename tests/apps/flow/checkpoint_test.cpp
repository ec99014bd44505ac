// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/checkpoint.h"

#include <catch2/catch.hpp>
#include <optional>

#include "apps/flow/flow.h"
#include "apps/flow/initial_mesh.h"
#include "apps/flow/targets.h"
#include "core/errors.h"
#include "io/atomic_file.h"
#include "tests/support/temporary_folder.h"

using namespace dsc;
using namespace dsc::flow;

namespace {

constexpr int steps = 10, interval = 3;

class StopAfter final : public core::Observer {
public:
    explicit StopAfter(int count) : left_(count) {}
    void progress(std::string_view, double, std::string_view) override { --left_; }
    bool is_cancelled() const override { return left_ <= 0; }

private:
    int left_;
};

/// A small ball that shrinks, from its start or from the checkpoint in its folder.
struct Run {
    Run(const std::filesystem::path& folder, bool is_resumed)
        : path(checkpoint_path(folder)), checkpoints(path, io::Json::object(), interval), snapshots(folder, steps, 4) {
        if (is_resumed) {
            SavedRun saved = read_checkpoint(path);
            result = std::move(saved.result);
            mesh.emplace(saved.state.tets);
            checkpoints.restore(std::move(saved.state));
            for (Snapshots::Frame& frame : saved.frames) snapshots.restore(std::move(frame));
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
    Run undisturbed(one.path(), false);
    undisturbed.go(observer);
    REQUIRE(undisturbed.result.end == FlowEnd::done);

    StopAfter stop(8);
    Run interrupted(other.path(), false);
    interrupted.go(stop);
    REQUIRE(interrupted.result.end == FlowEnd::cancelled);
    REQUIRE(interrupted.result.steps.back().step == 8);

    Run resumed(other.path(), true);
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

TEST_CASE("a checkpoint has everything of a run up to its step and nothing later") {
    const tests::TemporaryFolder folder;
    core::Observer observer;
    Run run(folder.path(), false);
    run.result.events.push_back({.kind = "split", .step = 2, .time = 0.1, .place = Point3(1, 2, 3), .label = 7});
    run.result.events.push_back({.kind = "merge", .step = 9, .time = 0.2, .place = Point3(4, 5, 6), .label = 0});
    run.go(observer);
    RunState state{.step = 4, .seconds = 1.5, .tets = run.mesh->data()};
    state.edge_lengths.assign(state.tets.vertices.size(), 0.1);
    state.unchanged = {std::vector<std::uint32_t>(state.tets.vertices.size(), 3), {{1, 2, 3}, {2, 3, 4}}};
    const io::Json options = io::Json::object({{"SHAPE", "sphere"}, {"--quiet", true}});
    write_checkpoint(run.path, options, state, run.result, run.snapshots);
    const SavedRun saved = read_checkpoint(run.path);
    CHECK(saved.options == options);
    CHECK(saved.state.step == 4);
    CHECK(saved.state.seconds == 1.5);
    CHECK(saved.state.tets.vertices == state.tets.vertices);
    CHECK(saved.state.tets.tets == state.tets.tets);
    CHECK(saved.state.tets.labels == state.tets.labels);
    CHECK(saved.state.edge_lengths == state.edge_lengths);
    CHECK(saved.state.unchanged.numbers == state.unchanged.numbers);
    CHECK(saved.state.unchanged.first == state.unchanged.first);
    CHECK(saved.result.domain.isApprox(run.result.domain, 0));
    CHECK(saved.result.edge_length == run.result.edge_length);

    FlowResult expected = run.result;
    expected.steps.resize(5);
    expected.events.resize(1);
    FlowResult found = saved.result;
    expected.end = found.end, expected.reason = found.reason, expected.time = found.time;
    expected.seconds = found.seconds;
    CHECK(report_json(found, {}) == report_json(expected, {}));
    REQUIRE(saved.frames.size() == 2);
    for (std::size_t i = 0; i < saved.frames.size(); ++i) {
        const Snapshots::Frame &kept = run.snapshots.frames()[i], &read = saved.frames[i];
        CHECK(read.step == kept.step);
        CHECK(read.time == kept.time);
        CHECK(read.interface.surface.vertices == kept.interface.surface.vertices);
        CHECK(read.interface.surface.triangles == kept.interface.surface.triangles);
        CHECK(read.interface.sides == kept.interface.sides);
    }
}
