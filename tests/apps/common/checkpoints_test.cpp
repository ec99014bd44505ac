// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/common/checkpoints.h"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "core/errors.h"
#include "io/atomic_file.h"
#include "tests/support/temporary_folder.h"

using namespace dsc;

namespace {

struct State {
    int step = 0;
    double value = 0;
};

template <class Visitor, core::ConstOrNot<State> Value>
void fields(Visitor& visitor, Value& state) {
    auto& [step, value] = state;
    visitor(step, value);
}

using SavedRun = apps::SavedRun<State, int, std::string, double>;
using Checkpoints = apps::Checkpoints<SavedRun>;

constexpr apps::CheckpointKind kind{"test", 1};

/// A run that has left behind as many records, events and frames as steps.
struct Run {
    std::vector<int> records;
    std::vector<std::string> events;
    std::vector<double> frames;

    void take_step() {
        const auto step = static_cast<int>(records.size());
        records.push_back(step);
        events.push_back("event " + std::to_string(step));
        frames.push_back(0.1 * step);
    }
    Checkpoints::History history() const { return {records, events, frames}; }
};

}  // namespace

TEST_CASE("checkpoints are due at multiples of their interval, but not where the run goes on") {
    Checkpoints checkpoints("", kind, io::Json::object(), 4);
    for (const int step : {0, 4, 8}) CHECK(checkpoints.is_due(step));
    for (const int step : {1, 2, 3, 5}) CHECK_FALSE(checkpoints.is_due(step));
    checkpoints.restore({.step = 4});
    CHECK_FALSE(checkpoints.is_due(4));
    CHECK(checkpoints.is_due(8));
    CHECK_FALSE(Checkpoints("", kind, io::Json::object(), 0).is_due(0));
}

TEST_CASE("a checkpoint has everything of a run up to its step, and nothing later") {
    const tests::TemporaryFolder folder;
    const auto path = apps::checkpoint_path(folder.path());
    const io::Json options = io::Json::object({{"SHAPE", "sphere"}, {"--quiet", true}});
    Checkpoints checkpoints(path, kind, options, 2);
    Run run;
    run.take_step();
    checkpoints.take({.step = 0, .value = 0.1}, run.history());
    {
        apps::CheckpointFile first(path, kind);
        CHECK(first.options() == options);
        const auto saved = first.run<SavedRun>();
        CHECK(saved.state.value == 0.1);
        CHECK(saved.steps == run.records);
    }
    run.take_step();
    run.take_step();
    const Run then = run;
    checkpoints.take({.step = 2, .value = 0.2}, run.history());
    run.take_step();
    checkpoints.save(run.history());
    const auto saved = apps::CheckpointFile(path, kind).run<SavedRun>();
    CHECK(saved.state.step == 2);
    CHECK(saved.state.value == 0.2);
    CHECK(saved.steps == then.records);
    CHECK(saved.events == then.events);
    CHECK(saved.frames == then.frames);
}

TEST_CASE("a checkpoint that is absent, damaged, foreign or of other fields is refused") {
    const tests::TemporaryFolder folder;
    const auto path = apps::checkpoint_path(folder.path());
    const auto check_refused = [&](const apps::CheckpointKind& wanted, const std::string& words) {
        CHECK_THROWS_WITH(apps::CheckpointFile(path, wanted).run<SavedRun>(), Catch::Contains(words));
    };
    check_refused(kind, "there is no checkpoint");
    Run run;
    run.take_step();
    Checkpoints(path, kind, io::Json::object(), 1).take({}, run.history());
    CHECK_NOTHROW(apps::CheckpointFile(path, kind).run<SavedRun>());
    check_refused({"other", 1}, "is a checkpoint of 'test'");
    check_refused({"test", 2}, "has version 1 where 2 is read");
    using OtherRun = apps::SavedRun<double, int, std::string, double>;
    CHECK_THROWS_AS(apps::CheckpointFile(path, kind).run<OtherRun>(), core::InputError);
    std::string bytes = io::read_file(path);
    io::write_file(path, bytes.substr(0, bytes.size() / 2));
    check_refused(kind, "damaged or cut off");
    bytes[bytes.size() / 3] ^= 1;
    io::write_file(path, bytes);
    check_refused(kind, "damaged or cut off");
}
