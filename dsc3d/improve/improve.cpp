// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/improve/improve.h"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "core/require.h"
#include "dsc3d/improve/angle_range.h"
#include "dsc3d/improve/schedule.h"

namespace dsc::dsc3d {

namespace {

constexpr double degrees = 180 / std::numbers::pi;

}  // namespace

void ImproveParameters::validate() const {
    core::require(max_boundary_change >= 0 && max_boundary_change <= 1e-2, "max_boundary_change", "in [0, 0.01]");
    core::require(feature_angle > 0 && feature_angle <= 180, "feature_angle", "in (0, 180]");
    core::require(!time_limit || *time_limit > 0, "time_limit", "positive");
    core::require(!target_angle || (*target_angle > 0 && *target_angle <= 70.5), "target_angle", "in (0, 70.5]");
    core::require(threads >= 0, "threads", "at least 0");
}

ImproveRun::ImproveRun(Mesh& mesh, const ImproveParameters& wanted, core::Observer& watching,
                       const StopCondition& stopping)
    : target(mesh), parameters(wanted), observer(watching), stop(stopping) {
    const FlatSurfaceParameters flat = {.may_change = wanted.changes_boundary,
                                        .tolerance = wanted.max_boundary_change,
                                        .feature_angle = wanted.feature_angle};
    rated = std::make_unique<RatedMesh>(mesh, wanted.measure, flat);
}

void ImproveRun::adopt(ImproveRun& other) {
    const geometry::QualityMeasure measure = other.rated->measure();
    FlatSurface surface = other.rated->surface();
    rated.reset();
    other.rated.reset();
    target = std::move(other.target);
    rated = std::make_unique<RatedMesh>(target, measure, std::move(surface));
    report = other.report;
}

bool ImproveRun::goes_on(const char* stage) {
    const AngleRange range(target);
    char figure[80];
    std::snprintf(figure, sizeof figure, "angles %.2f to %.2f, %u tetrahedra", range.min * degrees, range.max * degrees,
                  target.complex().tet_count());
    observer.progress(stage, -1, figure);
    const double wanted = parameters.target_angle.value_or(180) / degrees;
    if (stop.is_cancelled()) {
        report.end = ImproveEnd::cancelled;
    } else if (stop.is_out_of_time()) {
        report.end = ImproveEnd::reached_time_limit;
    } else if (range.min >= wanted && range.max <= std::numbers::pi - wanted) {
        report.end = ImproveEnd::reached_target_angle;
    } else {
        return true;
    }
    return false;
}

void ImproveRun::add(const PassCounts& counts) {
    report.smoothings += counts.smoothings;
    report.edge_removals += counts.edge_removals;
    report.multi_face_removals += counts.multi_face_removals;
    report.multi_face_retriangulations += counts.multi_face_retriangulations;
    report.collapses += counts.collapses;
}

std::unique_ptr<SchedulePolicy> make_schedule(Schedule schedule) {
    if (schedule == Schedule::best) return std::make_unique<BestSchedule>(BestSchedule::Parameters{});
    return std::make_unique<ThesisSchedule>(ThesisSchedule::Parameters{});
}

ImproveReport improve(Mesh& mesh, const ImproveParameters& parameters, core::Observer& observer) {
    parameters.validate();
    const StopCondition stop(observer, parameters.time_limit);
    ImproveRun run(mesh, parameters, observer, stop);
    if (run.goes_on("improving")) make_schedule(parameters.schedule)->run(run);
    run.report.seconds = stop.seconds();
    return run.report;
}

}  // namespace dsc::dsc3d
