// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/improve/improve.h"

#include <chrono>

#include "core/errors.h"
#include "dsc3d/improve/indicators.h"
#include "dsc3d/improve/passes.h"

namespace dsc::dsc3d {

ImproveReport improve(Mesh& mesh, const ImproveParameters& parameters, core::Observer& observer) {
    const auto start = std::chrono::steady_clock::now();
    RatedMesh rated(mesh, parameters.measure,
                    {.may_change = parameters.changes_boundary,
                     .tolerance = parameters.max_boundary_change,
                     .feature_angle = parameters.feature_angle});
    Passes passes(rated, {.uses_multi_face_retriangulation = parameters.uses_multi_face_retriangulation});
    (void)observer;
    int rounds = 0;
    passes.smooth_all_vertices();
    passes.topological_pass();
    int failed = 0;
    QualityIndicators before(rated);
    const auto improved = [&] {
        const QualityIndicators now(rated);
        const bool is_better = now.is_better_than(before, 1e-4);
        before = now;
        return is_better;
    };
    while (failed < 3) {
        ++rounds;
        passes.smooth_all_vertices();
        if (improved()) {
            failed = 0;
            continue;
        }
        passes.topological_pass();
        if (improved()) {
            failed = 0;
            continue;
        }
        if (parameters.uses_thinning && !parameters.keeps_vertices) passes.thinning_pass();
        failed = improved() ? 0 : failed + 1;
    }
    ImproveReport report;
    report.rounds = rounds;
    report.smoothings = passes.counts().smoothings;
    report.edge_removals = passes.counts().edge_removals;
    report.multi_face_removals = passes.counts().multi_face_removals;
    report.multi_face_retriangulations = passes.counts().multi_face_retriangulations;
    report.collapses = passes.counts().collapses;
    report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return report;
}

}  // namespace dsc::dsc3d
