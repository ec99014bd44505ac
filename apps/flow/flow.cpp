// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/flow.h"

#include <fmt/core.h>

#include <utility>

#include "apps/flow/run_steps.h"
#include "core/errors.h"
#include "core/stopwatch.h"
#include "io/number.h"

namespace dsc::flow {

namespace {

void require_places(const dsc3d::Mesh& mesh, const std::vector<std::optional<Point3>>& targets, double time) {
    for (std::uint32_t i = 0; i < targets.size(); ++i) {
        if (!targets[i] || targets[i]->allFinite()) continue;
        const Point3& p = mesh.position(dsc3d::VertexId(i));
        throw core::RunError(fmt::format("the motion of vertex {} at ({:.6g}, {:.6g}, {:.6g}) is not finite at time {}",
                                         i, p.x(), p.y(), p.z(), io::number_text(time, 6)));
    }
}

class EventList final : public dsc3d::Listener {
public:
    void on_event(const dsc3d::Event& event) override { events_.push_back(event); }
    std::vector<dsc3d::Event> taken() { return std::exchange(events_, {}); }

private:
    std::vector<dsc3d::Event> events_;
};

class Run {
public:
    Run(dsc3d::Mesh& mesh, const dsc3d::DeformParameters& parameters, const Targets& targets, Snapshots& snapshots,
        FlowResult& result, Checkpoints* checkpoints)
        : mesh_(mesh),
          parameters_(parameters),
          targets_(targets),
          snapshots_(snapshots),
          result_(result),
          checkpoints_(checkpoints) {
        if (checkpoints_ && checkpoints_->state()) {
            equip(*checkpoints_->state());
        } else {
            deformer_.emplace(mesh_, parameters_, events_);
            unchanged_.emplace(mesh_);
            components_.emplace(mesh_);
            result_.steps.push_back(step_record(mesh_, 0, 0, *unchanged_));
            keep(result_.steps.back());
        }
    }

    // Throws core::RunError, before anything has moved, when there are no targets.
    void take_step() {
        std::vector<std::pair<std::string, double>> milliseconds;
        core::Stopwatch watch;
        if (checkpoints_ && checkpoints_->is_due(result_.steps.back().step)) {
            renew();
            milliseconds.emplace_back("checkpoint", 1e3 * watch.seconds());
        }
        const int step = result_.steps.back().step + 1;
        const double start = result_.time.time(step - 1), time = result_.time.time(step);
        watch = {};
        const StepMotion wanted = targets_(mesh_, start, time - start);
        require_places(mesh_, wanted.targets, start);
        milliseconds.emplace_back("targets", 1e3 * watch.seconds());
        watch = {};
        deformer_->set_edge_lengths(wanted.edge_lengths);
        const dsc3d::StepReport report = deformer_->step(wanted.targets, wanted.path);
        milliseconds.emplace_back("deform", 1e3 * watch.seconds());
        watch = {};
        StepRecord record = step_record(mesh_, step, time, *unchanged_);
        add_step(record, report);
        add_events(report, step, time);
        milliseconds.emplace_back("measure", 1e3 * watch.seconds());
        record.milliseconds = std::move(milliseconds);
        result_.steps.push_back(std::move(record));
    }

    void keep(const StepRecord& record) { snapshots_.add(mesh_, record.step, record.time); }
    bool is_empty(const StepRecord& record) const { return record.interface_faces == 0; }
    std::string describe(const StepRecord& record) const {
        return fmt::format("step {}, {} tetrahedra, smallest angle {:.1f}", record.step, record.tets,
                           record.min_dihedral);
    }

    void save() {
        if (checkpoints_) checkpoints_->save(result_, snapshots_);
    }

private:
    RunState state() const {
        return {.step = result_.steps.back().step,
                .seconds = result_.seconds + watch_.seconds(),
                .tets = mesh_.data(),
                .edge_lengths = deformer_->edge_lengths(),
                .unchanged = unchanged_->state(mesh_)};
    }

    // The mesh and all that looks at it from what a checkpoint holds, as a run that goes on from it has them.
    void renew() {
        checkpoints_->take(state(), result_, snapshots_);
        deformer_.reset();
        unchanged_.reset();
        components_.reset();
        mesh_ = dsc3d::Mesh(checkpoints_->state()->tets);
        equip(*checkpoints_->state());
    }

    void equip(const RunState& state) {
        dsc3d::DeformParameters parameters = parameters_;
        parameters.seed += static_cast<std::uint64_t>(state.step);  // not the same random numbers again
        deformer_.emplace(mesh_, parameters, events_);
        deformer_->restore_edge_lengths(state.edge_lengths);
        unchanged_.emplace(mesh_, state.unchanged);
        components_.emplace(mesh_);
    }

    void add_events(const dsc3d::StepReport& report, int step, double time) {
        const auto add = [&](const char* kind, const Point3& place, int label) {
            result_.events.push_back({.kind = kind, .step = step, .time = time, .place = place, .label = label});
        };
        for (const dsc3d::Event& event : events_.taken())
            add(event.label == parameters_.background_label ? "merge" : "split", event.place, event.label);
        for (const auto& contact : report.contacts) add("contact", contact.place, contact.label);
        for (const auto& [label, centroid] : components_->update(mesh_)) add("vanish", centroid, label);
    }

    dsc3d::Mesh& mesh_;
    dsc3d::DeformParameters parameters_;
    const Targets& targets_;
    Snapshots& snapshots_;
    FlowResult& result_;
    Checkpoints* checkpoints_;
    core::Stopwatch watch_;
    EventList events_;
    std::optional<dsc3d::Deformer> deformer_;
    std::optional<UnchangedTriangles> unchanged_;
    std::optional<ComponentTracker<Tets>> components_;
};

}  // namespace

void run_flow(dsc3d::Mesh& mesh, const dsc3d::DeformParameters& parameters, const Targets& targets,
              Snapshots& snapshots, core::Observer& observer, FlowResult& result, Checkpoints* checkpoints) {
    Run run(mesh, parameters, targets, snapshots, result, checkpoints);
    run_steps(result, run, observer);
    run.save();
    snapshots.add_last(mesh, result.steps.back().step, result.steps.back().time);
}

}  // namespace dsc::flow
