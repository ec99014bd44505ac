// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/parallel.h"
#include "dsc3d/improve/angle_range.h"
#include "dsc3d/improve/escapes.h"
#include "dsc3d/improve/indicators.h"
#include "dsc3d/improve/schedule.h"

namespace dsc::dsc3d {

namespace {

using geometry::QualityMeasure;

// Lets cancellation through; the progress of runs side by side would only confuse.
class Forwarder final : public core::Observer {
public:
    explicit Forwarder(const core::Observer& observer) : observer_(observer) {}
    bool is_cancelled() const override { return observer_.is_cancelled(); }

private:
    const core::Observer& observer_;
};

struct Start {
    Mesh mesh;
    ImproveRun run;

    Start(const geometry::TetData& input, const ImproveRun& of, core::Observer& observer)
        : mesh(input), run(mesh, of.parameters, observer, of.stop) {}
};

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

// The poor tetrahedra, the worst first.
std::vector<TetId> BestSchedule::targets(const RatedMesh& mesh) const {
    std::vector<std::pair<double, TetId>> order;
    for (std::uint32_t i = 0; i < mesh.complex().tet_capacity(); ++i)
        if (!mesh.complex().is_deleted(TetId(i))) order.emplace_back(mesh.quality(TetId(i)), TetId(i));
    const std::size_t most = std::min(parameters_.most_targets, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(most), order.end());
    std::vector<TetId> tets;
    for (std::size_t i = 0; i < most; ++i) {
        if (i >= parameters_.least_targets && order[i].first > parameters_.poor * order[0].first) break;
        tets.push_back(order[i].second);
    }
    return tets;
}

struct BestSchedule::Progress {
    std::size_t tried = 0;
    std::size_t kept = 0;
    std::size_t cost = 0;
};

// Passes over the whole mesh, then rounds of escapes around its poor tetrahedra.
BestSchedule::Progress BestSchedule::escape(ImproveRun& run, std::uint64_t seed, std::size_t budget) const {
    const ImproveParameters& wanted = run.parameters;
    const bool thins = wanted.uses_thinning && !wanted.keeps_vertices;
    Passes passes(run.mesh(),
                  {.uses_multi_face_retriangulation = wanted.uses_multi_face_retriangulation,
                   .removes_surface_vertices = true,
                   .smoothing = {.least_gain = parameters_.fine_gain}},
                  &run.stop);
    passes.smooth_all_vertices();
    passes.topological_pass();
    if (thins) passes.thinning_pass();

    Escapes escapes(run.mesh(), passes, {.removes_vertices = thins, .relocates_vertices = !wanted.keeps_vertices},
                    seed);
    Progress progress;
    for (int round = 0; round < parameters_.rounds && progress.cost < budget; ++round) {
        if (!run.goes_on("escaping")) break;
        const double worst = worst_quality(run.mesh());
        const std::vector<TetId> poor = targets(run.mesh());
        for (std::size_t i = 0; i < std::max(poor.size(), parameters_.round); ++i) {
            const TetId t = poor[i % poor.size()];
            if (run.mesh().complex().is_deleted(t)) continue;
            if (progress.cost >= budget || run.stop.is_due()) break;
            const Escapes::Attempt attempt = escapes.attempt(t, worst);
            ++progress.tried;
            progress.cost += attempt.cost;
            progress.kept += attempt.is_kept ? 1 : 0;
        }
    }
    run.add(passes.counts());
    run.report.escapes += progress.kept;
    return progress;
}

void BestSchedule::climb(ImproveRun& run) const {
    // Hill climbing leads to another maximum from another side.
    std::vector<std::optional<QualityMeasure>> first = {std::nullopt};
    for (const QualityMeasure measure : {QualityMeasure::radius_ratio, QualityMeasure::volume_length})
        if (measure != run.parameters.measure) first.emplace_back(measure);

    Forwarder observer(run.observer);
    const geometry::TetData input = run.target.data();
    std::vector<std::unique_ptr<Start>> starts(first.size());
    core::parallel_for(first.size(), {.threads = run.parameters.threads, .grain = 1}, [&](std::size_t i) {
        starts[i] = std::make_unique<Start>(input, run, observer);
        ImproveRun& start = starts[i]->run;
        if (first[i]) {
            start.mesh().set_measure(*first[i]);
            ThesisSchedule({}).run(start);
            start.mesh().set_measure(run.parameters.measure);
        }
        ThesisSchedule({}).run(start);
    });
    std::size_t best = 0;
    std::vector<QualityIndicators> reached;
    for (const std::unique_ptr<Start>& start : starts) reached.emplace_back(start->run.mesh());
    for (std::size_t i = 1; i < starts.size(); ++i)
        if (reached[i].worst > reached[best].worst) best = i;
    run.adopt(starts[best]->run);
}

void BestSchedule::run(ImproveRun& run) {
    climb(run);
    run.mesh().limit_edges(parameters_.edge_growth);
    core::Random seeds(run.parameters.seed);
    std::size_t left = parameters_.budget;
    // Half of the attempts go to the measure asked for, unless they are in vain; then the two ends are balanced.
    bool is_balanced = !is_made_of_sines(run.parameters.measure);
    const std::size_t for_balance = is_balanced ? 0 : parameters_.budget / 2;
    const auto patience = static_cast<std::size_t>(parameters_.patience * static_cast<double>(parameters_.budget));
    std::size_t fruitless = 0;
    while (left > 0 && run.goes_on("escaping")) {
        const Progress progress = escape(run, seeds.below(~std::uint64_t{0}), left);
        left -= std::min(left, progress.cost);
        const bool is_stuck =
            static_cast<double>(progress.kept) < parameters_.least_kept * static_cast<double>(progress.tried);
        fruitless = is_stuck ? fruitless + progress.cost : 0;
        if (is_balanced && fruitless >= patience) break;
        if (!is_balanced && left > for_balance && fruitless < patience) continue;
        if (!is_balanced) fruitless = 0;
        is_balanced = true;
        if (for_balance > 0)
            run.mesh().set_measure(QualityMeasure::minimum_biased_sine, balancing_bias(run.mesh().mesh()));
    }
}

}  // namespace dsc::dsc3d
