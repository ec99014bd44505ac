// SPDX-License-Identifier: GPL-3.0-or-later
// Flows in the plane that are interrupted and go on, against undisturbed ones.
#include "apps/flow/planar/checkpoint.h"

#include <catch2/catch.hpp>
#include <optional>
#include <string>

#include "apps/flow/planar/flow.h"
#include "apps/flow/resume.h"
#include "dsc2d/validate.h"
#include "io/atomic_file.h"
#include "tests/apps/flow/stop_after.h"
#include "tests/support/temporary_folder.h"

using namespace dsc;
using namespace dsc::flow::planar;
using flow::FlowEnd;
using motion::TopologyPolicy;

namespace {

struct Case {
    ShapeOptions shape;
    MotionOptions motion;
    TopologyPolicy topology = TopologyPolicy::preserved;
    int steps = 12;
};

/// From its start, or from the checkpoint in its folder.
struct SavedFlow {
    SavedFlow(const Case& given, const std::filesystem::path& folder, bool is_resumed, int interval = 5)
        : path(apps::checkpoint_path(folder)),
          checkpoints(path, flow::checkpoint_kind, io::Json::object(), interval),
          snapshots(folder, given.steps, 5),
          motion(given.motion) {
        EdgeLimits edges;
        if (is_resumed) {
            auto saved = apps::CheckpointFile(path, flow::checkpoint_kind).run<SavedRun>();
            edges = saved.state.edges;
            result.domain = saved.state.domain;
            complex.emplace(domain_of(result.domain, given.shape.is_torus), saved.state.complex);
            held = saved.state.contacts.size();
            flow::take_over(std::move(saved), result, snapshots, checkpoints);
        } else {
            InitialComplex initial = initial_complex(given.shape);
            edges = edge_limits(initial);
            result.domain = initial.domain;
            complex.emplace(std::move(initial.complex));
        }
        parameters = deformation(edges, given.topology);
        result.edge_length = edges.edge_length;
        result.is_torus = given.shape.is_torus;
        result.time = {1.0 / given.steps, 1, given.steps};
    }

    void go(core::Observer& observer) {
        run_flow(*complex, parameters, motion_targets(motion, result.domain, result.edge_length, result.time.until),
                 snapshots, observer, result, &checkpoints);
        CHECK(validate(*complex).empty());
    }
    std::string timeless_report() const {
        io::Json report = report_json(result, {});
        report["seconds"] = 0;
        for (std::size_t i = 0; i < report["steps"].size(); ++i) report["steps"][i]["ms"] = 0;
        return report.dump();
    }

    std::filesystem::path path;
    Checkpoints checkpoints;
    Snapshots snapshots;
    MotionOptions motion;
    std::optional<dsc2d::Complex> complex;
    dsc2d::Parameters parameters;
    FlowResult result;
    std::size_t held = 0;  ///< contacts in the checkpoint
};

void check_same(const dsc2d::ComplexArrays& a, const dsc2d::ComplexArrays& b) {
    CHECK(a.positions == b.positions);
    CHECK(a.ends == b.ends);
    CHECK(a.next == b.next);
    CHECK(a.offsets == b.offsets);
    CHECK(a.labels == b.labels);
    CHECK(a.is_locked == b.is_locked);
}

// The number of contacts that were held when the run went on.
std::size_t check_goes_on(const Case& given) {
    const tests::TemporaryFolder one, other;
    core::Observer observer;
    SavedFlow undisturbed(given, one.path(), false);
    undisturbed.go(observer);
    REQUIRE(undisturbed.result.end == FlowEnd::done);

    tests::StopAfter stop(given.steps - 3);
    SavedFlow interrupted(given, other.path(), false);
    interrupted.go(stop);
    REQUIRE(interrupted.result.end == FlowEnd::cancelled);

    SavedFlow resumed(given, other.path(), true);
    const int step = resumed.result.steps.back().step;
    CHECK(step == (given.steps - 3) / 5 * 5);
    const auto number = static_cast<std::size_t>(step);
    CHECK(resumed.result.steps[number].milliseconds == interrupted.result.steps[number].milliseconds);
    resumed.go(observer);
    check_same(resumed.complex->arrays(), undisturbed.complex->arrays());
    CHECK(resumed.timeless_report() == undisturbed.timeless_report());
    CHECK(other.content() == one.content());
    for (const std::string& name : one.content())
        if (name != "checkpoint") CHECK(io::read_file(one / name) == io::read_file(other / name));
    return resumed.held;
}

}  // namespace

TEST_CASE("a disc that turns goes on from a checkpoint bit for bit") {
    check_goes_on({.shape = {.shape = Shape::disc, .centre = Point2(0.5, 0.6), .radius = 0.2}});
}

TEST_CASE("... two discs that grow into one") {
    check_goes_on({.shape = {.shape = Shape::two_discs},
                   .motion = {.motion = Motion::offset, .distance = 0.03},
                   .topology = TopologyPolicy::adaptive});
}

TEST_CASE("... a slotted disc across the seam of a torus, that is taken back by periods") {
    ShapeOptions shape{.shape = Shape::slotted_disc, .radius = 0.2};
    shape.is_torus = true;
    check_goes_on({.shape = shape, .motion = {.motion = Motion::translate, .velocity = Point2(7.3, -0.6)}});
}

TEST_CASE("... two discs that are pressed against each other, with the contacts that hold them") {
    const std::size_t held = check_goes_on(
        {.shape = {.shape = Shape::two_discs}, .motion = {.motion = Motion::offset, .distance = 0.03}, .steps = 15});
    CHECK(held > 0);
}

TEST_CASE("... through steps in which much is removed and the arrays are compacted") {
    check_goes_on({.shape = {.shape = Shape::labelled_block},
                   .motion = {.motion = Motion::curl_noise, .speed = 0.4},
                   .topology = TopologyPolicy::adaptive,
                   .steps = 29});
}

TEST_CASE("checkpoints leave the steps of a flow in the plane what they are without") {
    const Case given{.shape = {.shape = Shape::disc}, .motion = {.motion = Motion::curl_noise, .speed = 0.2}};
    std::vector<dsc2d::ComplexArrays> ends;
    for (const int interval : {0, 1, 4}) {
        const tests::TemporaryFolder folder;
        core::Observer observer;
        SavedFlow run(given, folder.path(), false, interval);
        run.go(observer);
        ends.push_back(run.complex->arrays());
        CHECK(std::filesystem::exists(run.path) == (interval > 0));
    }
    check_same(ends[0], ends[1]);
    check_same(ends[0], ends[2]);
}
