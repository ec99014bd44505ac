// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/flow.h"

#include <fmt/core.h>

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

// Throws core::RunError, before anything has moved, when there are no targets.
void take_step(dsc3d::Mesh& mesh, dsc3d::Deformer& deformer, const Targets& targets,
               const UnchangedTriangles& unchanged, FlowResult& result) {
    const int step = result.steps.back().step + 1;
    const double start = result.time.time(step - 1), time = result.time.time(step);
    core::Stopwatch watch;
    const std::vector<std::optional<Point3>> wanted = targets(mesh, start, time - start);
    require_places(mesh, wanted, start);
    const double targets_ms = 1e3 * watch.seconds();
    watch = {};
    const dsc3d::StepReport report = deformer.step(wanted);
    const double deform_ms = 1e3 * watch.seconds();
    watch = {};
    StepRecord record = step_record(mesh, step, time, unchanged);
    add_step(record, report);
    add_contacts(report, step, time, result);
    record.milliseconds = {{"targets", targets_ms}, {"deform", deform_ms}, {"measure", 1e3 * watch.seconds()}};
    result.steps.push_back(std::move(record));
}

}  // namespace

void run_flow(dsc3d::Mesh& mesh, dsc3d::Deformer& deformer, const Targets& targets, Snapshots& snapshots,
              core::Observer& observer, FlowResult& result) {
    const core::Stopwatch whole;
    const UnchangedTriangles unchanged(mesh);
    if (result.steps.empty()) {
        result.steps.push_back(step_record(mesh, 0, 0, unchanged));
        snapshots.add(mesh, 0, 0);
    }
    result.end = FlowEnd::done;
    result.reason = "done";
    while (result.steps.back().step < result.time.count) {
        if (observer.is_cancelled()) {
            result.end = FlowEnd::cancelled;
            result.reason = "stopped by the user";
            break;
        }
        try {
            take_step(mesh, deformer, targets, unchanged, result);
        } catch (const core::RunError& error) {
            result.end = FlowEnd::stopped;
            result.reason = error.what();
            break;
        }
        const StepRecord& record = result.steps.back();
        snapshots.add(mesh, record.step, record.time);
        observer.progress("flowing", static_cast<double>(record.step) / result.time.count,
                          fmt::format("step {}, {} tetrahedra, smallest angle {:.1f}", record.step, record.tets,
                                      record.min_dihedral));
        if (result.steps.back().interface_faces == 0) {
            result.end = FlowEnd::vanished;
            result.reason = "the interface has vanished";
            break;
        }
    }
    snapshots.add_last(mesh, result.steps.back().step, result.steps.back().time);
    result.seconds += whole.seconds();
}

}  // namespace dsc::flow
