// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/improve/improve.h"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "core/errors.h"
#include "dsc3d/improve/angle_range.h"
#include "dsc3d/improve/schedule.h"

namespace dsc::dsc3d {

namespace {

constexpr double degrees = 180 / std::numbers::pi;

void require(bool condition, const char* field, const std::string& range) {
    if (!condition) throw core::UsageError(std::string(field) + ": has to be " + range);
}

}  // namespace

void ImproveParameters::validate() const {
    require(max_boundary_change >= 0 && max_boundary_change <= 1e-2, "max_boundary_change", "in [0, 0.01]");
    require(feature_angle > 0 && feature_angle <= 180, "feature_angle", "in (0, 180]");
    require(!time_limit || *time_limit > 0, "time_limit", "positive");
    require(!target_angle || (*target_angle > 0 && *target_angle <= 70.5), "target_angle", "in (0, 70.5]");
    require(threads >= 0, "threads", "at least 0");
}

bool ImproveRun::goes_on(const char* stage) {
    const AngleRange range(mesh.mesh());
    char figure[80];
    std::snprintf(figure, sizeof figure, "angles %.2f to %.2f, %u tetrahedra", range.min * degrees, range.max * degrees,
                  mesh.complex().tet_count());
    observer.progress(stage, -1, figure);
    const double target = parameters.target_angle.value_or(180) / degrees;
    if (stop.is_cancelled()) {
        report.end = ImproveEnd::cancelled;
    } else if (stop.is_out_of_time()) {
        report.end = ImproveEnd::reached_time_limit;
    } else if (range.min >= target && range.max <= std::numbers::pi - target) {
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
    RatedMesh rated(mesh, parameters.measure,
                    {.may_change = parameters.changes_boundary,
                     .tolerance = parameters.max_boundary_change,
                     .feature_angle = parameters.feature_angle});
    ImproveReport report;
    ImproveRun run{rated, parameters, observer, stop, report};
    if (run.goes_on("improving")) make_schedule(parameters.schedule)->run(run);
    report.seconds = stop.seconds();
    return report;
}

}  // namespace dsc::dsc3d
