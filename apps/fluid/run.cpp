// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/fluid/run.h"

#include <fmt/core.h>

#include <algorithm>
#include <memory>

#include "core/errors.h"
#include "core/stopwatch.h"

namespace dsc::fluid_app {

namespace {

constexpr double least_steps = 20;  // of a run whose steps have no other limit

class EventList final : public dsc3d::Listener {
public:
    void on_event(const dsc3d::Event& event) override { events.push_back(event); }
    std::vector<dsc3d::Event> events;
};

class Run {
public:
    Run(const TrackedState& start, const TrackedParameters& parameters, const RunParameters& run, Series& series,
        Checkpoints* checkpoints, RunResult& result)
        : parameters_(parameters), run_(run), series_(series), checkpoints_(checkpoints), result_(result) {
        const bool goes_on = checkpoints && checkpoints->state();
        make(goes_on ? checkpoints->state()->fluid : start, goes_on ? checkpoints->state()->step : 0);
        if (goes_on) return;
        result_.steps.push_back(step_record(*fluid_, 0, 0));
        series_.add(*fluid_, 0);
    }

    const StepRecord& last() const { return result_.steps.back(); }
    bool is_over() const {
        return last().time >= run_.until || (run_.steps && last().step >= *run_.steps) || last().cells == 0;
    }

    void take_step() {
        if (checkpoints_ && checkpoints_->is_due(last().step)) renew();
        double dt = std::min(run_.until - last().time, run_.dt.value_or(run_.until));
        if (!run_.dt) dt = fluid_->longest_step(std::min(dt, run_.until / least_steps));
        TrackedReport report;
        for (int halvings = 0;; ++halvings, dt /= 2) {
            try {
                report = fluid_->step(dt);
                break;
            } catch (const core::RunError&) {
                if (halvings == run_.halvings) throw;
            }
        }
        const double time = run_.until - last().time <= dt ? run_.until : last().time + dt;
        const core::Stopwatch watch;
        StepRecord record = step_record(*fluid_, last().step + 1, time);
        record.dt = dt;
        record.max_divergence = report.flow.max_divergence;
        record.solver_iterations = report.flow.solve.iterations;
        record.transferred = report.transferred;
        record.unfinished = report.deform.unfinished.size();
        record.milliseconds = std::move(report.milliseconds);
        record.milliseconds.emplace_back("measure", 1e3 * watch.seconds());
        for (const dsc3d::Event& event : events_.events)
            result_.events.push_back({event.label == 0 ? "merge" : "split", record.step, time, event.place});
        events_.events.clear();
        if (record.volumes.size() != last().volumes.size())
            result_.events.push_back(
                {fmt::format("{} parts", record.volumes.size()), record.step, time, record.centre});
        result_.steps.push_back(std::move(record));
        series_.add(*fluid_, time);
    }

    geometry::TetData finish() {
        if (checkpoints_) checkpoints_->save(history());
        series_.add_last(*fluid_, last().time);
        return fluid_->mesh().data();
    }

private:
    Checkpoints::History history() const { return {result_.steps, result_.events, series_.frames()}; }

    void make(const TrackedState& state, int step) {
        TrackedParameters parameters = parameters_;
        parameters.deform.seed += static_cast<std::uint64_t>(step);  // not the same random numbers again
        fluid_.reset();
        fluid_ = std::make_unique<TrackedFluid>(state, parameters, events_);
    }
    // As a run that goes on from the checkpoint has it.
    void renew() {
        checkpoints_->take({.step = last().step,
                            .time = last().time,
                            .seconds = result_.seconds + watch_.seconds(),
                            .edge_length = parameters_.deform.edge_length,
                            .fluid = fluid_->state()},
                           history());
        make(checkpoints_->state()->fluid, last().step);
    }

    TrackedParameters parameters_;
    RunParameters run_;
    Series& series_;
    Checkpoints* checkpoints_;
    RunResult& result_;
    core::Stopwatch watch_;
    EventList events_;
    std::unique_ptr<TrackedFluid> fluid_;
};

}  // namespace

geometry::TetData run_fluid(const TrackedState& start, const TrackedParameters& parameters, const RunParameters& run,
                            Series& series, Checkpoints* checkpoints, core::Observer& observer, RunResult& result) {
    const core::Stopwatch watch;
    Run steps(start, parameters, run, series, checkpoints, result);
    try {
        while (!steps.is_over()) {
            observer.check_cancelled();
            steps.take_step();
            const StepRecord& record = steps.last();
            observer.progress("flowing", record.time / run.until,
                              fmt::format("step {}, {} tetrahedra, {} parts, dt {:.3g}", record.step, record.tets,
                                          record.volumes.size(), record.dt));
        }
        if (steps.last().cells == 0) {
            result.end = RunEnd::vanished;
            result.reason = "the fluid has vanished";
        }
    } catch (const core::Cancelled&) {
        result.end = RunEnd::cancelled;
        result.reason = "stopped by the user";
    } catch (const core::RunError& error) {
        result.end = RunEnd::stopped;
        result.reason = error.what();
    }
    result.seconds += watch.seconds();
    return steps.finish();
}

}  // namespace dsc::fluid_app
