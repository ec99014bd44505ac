// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/flow.h"

#include <fmt/core.h>

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

void add_contacts(const dsc3d::StepReport& report, int step, double time, FlowResult& result) {
    for (const auto& contact : report.contacts)
        result.events.push_back(
            {.kind = "contact", .step = step, .time = time, .place = contact.place, .label = contact.label});
}

class Run {
public:
    Run(dsc3d::Mesh& mesh, dsc3d::Deformer& deformer, const Targets& targets, Snapshots& snapshots, FlowResult& result)
        : mesh_(mesh),
          deformer_(deformer),
          targets_(targets),
          snapshots_(snapshots),
          result_(result),
          unchanged_(mesh) {}

    void begin() {
        result_.steps.push_back(step_record(mesh_, 0, 0, unchanged_));
        keep(result_.steps.back());
    }

    // Throws core::RunError, before anything has moved, when there are no targets.
    void take_step() {
        const int step = result_.steps.back().step + 1;
        const double start = result_.time.time(step - 1), time = result_.time.time(step);
        core::Stopwatch watch;
        const std::vector<std::optional<Point3>> wanted = targets_(mesh_, start, time - start);
        require_places(mesh_, wanted, start);
        const double targets_ms = 1e3 * watch.seconds();
        watch = {};
        const dsc3d::StepReport report = deformer_.step(wanted);
        const double deform_ms = 1e3 * watch.seconds();
        watch = {};
        StepRecord record = step_record(mesh_, step, time, unchanged_);
        add_step(record, report);
        add_contacts(report, step, time, result_);
        record.milliseconds = {{"targets", targets_ms}, {"deform", deform_ms}, {"measure", 1e3 * watch.seconds()}};
        result_.steps.push_back(std::move(record));
    }

    void keep(const StepRecord& record) { snapshots_.add(mesh_, record.step, record.time); }
    bool is_empty(const StepRecord& record) const { return record.interface_faces == 0; }
    std::string describe(const StepRecord& record) const {
        return fmt::format("step {}, {} tetrahedra, smallest angle {:.1f}", record.step, record.tets,
                           record.min_dihedral);
    }

private:
    dsc3d::Mesh& mesh_;
    dsc3d::Deformer& deformer_;
    const Targets& targets_;
    Snapshots& snapshots_;
    FlowResult& result_;
    UnchangedTriangles unchanged_;
};

}  // namespace

void run_flow(dsc3d::Mesh& mesh, dsc3d::Deformer& deformer, const Targets& targets, Snapshots& snapshots,
              core::Observer& observer, FlowResult& result) {
    Run run(mesh, deformer, targets, snapshots, result);
    if (result.steps.empty()) run.begin();
    run_steps(result, run, observer);
    snapshots.add_last(mesh, result.steps.back().step, result.steps.back().time);
}

}  // namespace dsc::flow
