// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "dsc3d/improve/indicators.h"
#include "dsc3d/improve/schedule.h"
#include "dsc3d/improve/spatial_order.h"

namespace dsc::dsc3d {

void ThesisSchedule::run(ImproveRun& run) {
    const ImproveParameters& wanted = run.parameters;
    std::optional<SpatialOrder> order;
    if (run.target.complex().vertex_count() >= parameters_.many_vertices) order.emplace(run.target);
    Passes passes(run.mesh(), {.uses_multi_face_retriangulation = wanted.uses_multi_face_retriangulation}, &run.stop);
    const bool thins = wanted.uses_thinning && !wanted.keeps_vertices;

    passes.smooth_all_vertices();
    passes.topological_pass();
    // Smoothing lowers the higher means, which a topological pass raises again. Measured against the state just before,
    // the two would improve the mesh in turn without end; measured against the best so far, every improvement is one.
    QualityIndicators reached(run.mesh());
    const auto has_improved = [&] {
        const QualityIndicators now(run.mesh());
        const bool is_better = now.is_better_than(reached, parameters_.least_gain);
        reached.raise_to(now);
        return is_better;
    };
    int failed = 0;
    while (failed < parameters_.failures && run.goes_on("improving")) {
        ++run.report.rounds;
        passes.smooth_all_vertices();
        if (has_improved()) {
            failed = 0;
            continue;
        }
        passes.topological_pass();
        if (has_improved()) {
            failed = 0;
            continue;
        }
        if (thins) passes.thinning_pass();
        failed = has_improved() ? 0 : failed + 1;
    }
    run.add(passes.counts());
    if (order) order->restore();
}

}  // namespace dsc::dsc3d
