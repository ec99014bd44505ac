// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/flow.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "apps/flow/run_steps.h"
#include "core/errors.h"
#include "core/stopwatch.h"
#include "io/number.h"

namespace dsc::flow {

namespace {

// What is on a wall slides on it, wherever its target is, and what comes to one may touch it where the background may
// be squeezed away.
void require_places(const dsc3d::Mesh& mesh, const std::vector<std::optional<Point3>>& targets,
                    const Eigen::AlignedBox3d& domain, const dsc3d::DeformParameters& parameters, double time) {
    const bool may_touch =
        motion::allows_change(parameters.topology, parameters.background_label, parameters.background_label);
    for (std::uint32_t i = 0; i < targets.size(); ++i) {
        if (!targets[i]) continue;
        const bool is_finite = targets[i]->allFinite();
        if (is_finite && (may_touch || domain.contains(*targets[i]) || mesh.complex().is_boundary(dsc3d::VertexId(i))))
            continue;
        const Point3& p = mesh.position(dsc3d::VertexId(i));
        throw core::RunError(fmt::format("the motion of vertex {} at ({:.6g}, {:.6g}, {:.6g}) {} at time {}", i, p.x(),
                                         p.y(), p.z(), is_finite ? "leads out of the domain" : "is not finite",
                                         io::number_text(time, 6)));
    }
}

class EventList final : public dsc3d::Listener {
public:
    explicit EventList(const core::Observer& observer) : observer_(observer) {}
    void on_event(const dsc3d::Event& event) override { events_.push_back(event); }
    void on_substep(int substep, int wanted) override {
        share_ = std::min(1.0, static_cast<double>(substep) / wanted);
        observer_.check_cancelled();
    }
    /// Of the step, that has been made.
    double share() const { return share_; }
    std::vector<dsc3d::Event> taken() { return std::exchange(events_, {}); }

private:
    const core::Observer& observer_;
    std::vector<dsc3d::Event> events_;
    double share_ = 0;
};

class Run {
public:
    Run(dsc3d::Mesh& mesh, const dsc3d::DeformParameters& parameters, const Targets& targets, Snapshots& snapshots,
        const core::Observer& observer, FlowResult& result, Checkpoints* checkpoints, const dsc3d::Walls& walls)
        : mesh_(mesh),
          parameters_(parameters),
          walls_(walls),
          targets_(targets),
          snapshots_(snapshots),
          result_(result),
          checkpoints_(checkpoints),
          events_(observer) {
        if (checkpoints_ && checkpoints_->state()) {
            equip(*checkpoints_->state());
        } else {
            deformer_.emplace(mesh_, parameters_, events_, walls_);
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
        require_places(mesh_, wanted.targets, result_.domain, parameters_, start);
        milliseconds.emplace_back("targets", 1e3 * watch.seconds());
        watch = {};
        deformer_->set_edge_lengths(wanted.edge_lengths);
        dsc3d::StepReport report;
        try {
            report = deformer_->step(wanted.targets, wanted.path);
        } catch (const core::Cancelled&) {
            report.is_complete = false;
            if (events_.share() > 0) add_record(report, step, start + events_.share() * (time - start), milliseconds);
            throw;
        }
        milliseconds.emplace_back("deform", 1e3 * watch.seconds());
        add_record(report, step, time, milliseconds);
    }

    void keep(const StepRecord& record) { snapshots_.add(mesh_, record.step, record.time); }
    bool is_empty(const StepRecord& record) const { return record.interface_faces == 0; }
    std::string describe(const StepRecord& record) const {
        return fmt::format("step {}, {} tetrahedra, smallest angle {:.1f}", record.step, record.tets,
                           record.min_dihedral);
    }

    void save() {
        if (checkpoints_) checkpoints_->save(history());
    }

private:
    Checkpoints::History history() const { return {result_.steps, result_.events, snapshots_.frames()}; }

    RunState state() const {
        return {.step = result_.steps.back().step,
                .seconds = result_.seconds + watch_.seconds(),
                .domain = result_.domain,
                .edge_length = result_.edge_length,
                .tets = mesh_.data(),
                .edge_lengths = deformer_->edge_lengths(),
                .unchanged = unchanged_->state(mesh_)};
    }

    // The mesh and all that looks at it from what a checkpoint holds, as a run that goes on from it has them.
    void renew() {
        checkpoints_->take(state(), history());
        deformer_.reset();
        unchanged_.reset();
        components_.reset();
        mesh_ = dsc3d::Mesh(checkpoints_->state()->tets);
        equip(*checkpoints_->state());
    }

    void equip(const RunState& state) {
        dsc3d::DeformParameters parameters = parameters_;
        parameters.seed += static_cast<std::uint64_t>(state.step);  // not the same random numbers again
        deformer_.emplace(mesh_, parameters, events_, walls_);
        deformer_->restore_edge_lengths(state.edge_lengths);
        unchanged_.emplace(mesh_, state.unchanged);
        components_.emplace(mesh_);
    }

    void add_record(const dsc3d::StepReport& report, int step, double time,
                    std::vector<std::pair<std::string, double>>& milliseconds) {
        const core::Stopwatch watch;
        StepRecord record = step_record(mesh_, step, time, *unchanged_);
        add_step(record, report);
        add_events(report, step, time);
        milliseconds.emplace_back("measure", 1e3 * watch.seconds());
        record.milliseconds = std::move(milliseconds);
        result_.steps.push_back(std::move(record));
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
    dsc3d::Walls walls_;
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
              Snapshots& snapshots, core::Observer& observer, FlowResult& result, Checkpoints* checkpoints,
              const dsc3d::Walls& walls) {
    Run run(mesh, parameters, targets, snapshots, observer, result, checkpoints, walls);
    run_steps(result, run, observer);
    run.save();
    snapshots.add_last(mesh, result.steps.back().step, result.steps.back().time);
}

}  // namespace dsc::flow
