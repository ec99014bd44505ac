// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "dsc3d/improve/angle_range.h"
#include "dsc3d/improve/escapes.h"
#include "dsc3d/improve/schedule.h"

namespace dsc::dsc3d {

namespace {

using geometry::QualityMeasure;

// The tetrahedra in the order of their quality, the worst first, as far as they are poor.
std::vector<TetId> poor_tets(const RatedMesh& mesh, double worst, double poor, std::size_t most) {
    std::vector<std::pair<double, TetId>> found;
    for (std::uint32_t i = 0; i < mesh.complex().tet_capacity(); ++i) {
        const TetId t(i);
        if (!mesh.complex().is_deleted(t) && mesh.quality(t) <= poor * worst) found.emplace_back(mesh.quality(t), t);
    }
    std::sort(found.begin(), found.end());
    found.resize(std::min(found.size(), most));
    std::vector<TetId> tets;
    for (const auto& [quality, t] : found) tets.push_back(t);
    return tets;
}

double worst_quality(const RatedMesh& mesh) {
    double worst = 1;
    for (std::uint32_t i = 0; i < mesh.complex().tet_capacity(); ++i)
        if (!mesh.complex().is_deleted(TetId(i))) worst = std::min(worst, mesh.quality(TetId(i)));
    return worst;
}

bool is_made_of_sines(QualityMeasure measure) {
    return measure == QualityMeasure::minimum_sine || measure == QualityMeasure::minimum_biased_sine;
}

// The bias with which the sines of the smallest and of the largest angle weigh the same. Whatever does not make the
// worst quality by this measure worse makes neither angle worse.
double balancing_bias(const Mesh& mesh) {
    const AngleRange range(mesh);
    return std::sin(range.min) / std::sin(range.max);
}

}  // namespace

struct BestSchedule::Progress {
    std::size_t tried = 0;
    std::size_t kept = 0;
};

// Passes over the whole mesh, then rounds of escapes around its poor tetrahedra.
BestSchedule::Progress BestSchedule::escape(ImproveRun& run, std::uint64_t seed, std::size_t attempts) const {
    const ImproveParameters& wanted = run.parameters;
    const bool thins = wanted.uses_thinning && !wanted.keeps_vertices;
    Passes passes(run.mesh,
                  {.uses_multi_face_retriangulation = wanted.uses_multi_face_retriangulation,
                   .removes_surface_vertices = true,
                   .smoothing = {.least_gain = parameters_.fine_gain}},
                  &run.stop);
    passes.smooth_all_vertices();
    passes.topological_pass();
    if (thins) passes.thinning_pass();

    Escapes escapes(run.mesh, passes, {.removes_vertices = thins}, seed);
    Progress progress;
    for (int round = 0; round < parameters_.rounds && progress.tried < attempts; ++round) {
        if (!run.goes_on("escaping")) break;
        const double worst = worst_quality(run.mesh);
        for (const TetId t : poor_tets(run.mesh, worst, parameters_.poor, parameters_.targets)) {
            if (run.mesh.complex().is_deleted(t)) continue;
            if (progress.tried++ >= attempts || run.stop.is_due()) break;
            if (escapes.attempt(t, worst)) ++progress.kept;
        }
    }
    run.add(passes.counts());
    run.report.escapes += progress.kept;
    return progress;
}

void BestSchedule::run(ImproveRun& run) {
    ThesisSchedule({}).run(run);
    core::Random seeds(run.parameters.seed);
    std::size_t left = parameters_.max_attempts;
    bool is_balanced = false;
    while (left > 0 && run.goes_on("escaping")) {
        const Progress progress = escape(run, seeds.below(~std::uint64_t{0}), left);
        left -= std::min(left, progress.tried);
        const bool is_stuck =
            static_cast<double>(progress.kept) < parameters_.least_kept * static_cast<double>(progress.tried);
        // Half of the attempts go to the measure asked for, unless they are in vain.
        if (!is_balanced && !is_stuck && left > parameters_.max_attempts / 2) continue;
        if (is_balanced && is_stuck) break;
        if (!is_made_of_sines(run.parameters.measure)) {
            if (is_stuck) break;
            continue;
        }
        is_balanced = true;
        run.mesh.set_measure(QualityMeasure::minimum_biased_sine, balancing_bias(run.mesh.mesh()));
    }
}

}  // namespace dsc::dsc3d
