// SPDX-License-Identifier: GPL-3.0-or-later
// In which order a mesh is improved, and when that ends: the policy, apart from the passes and operations it uses.
// Source: thesis algorithm 1 (ThesisSchedule), 3.6 (BestSchedule).
#pragma once

#include <memory>
#include <vector>

#include "dsc3d/improve/improve.h"
#include "dsc3d/improve/passes.h"
#include "dsc3d/improve/stop.h"

namespace dsc::dsc3d {

/// What a schedule works on.
struct ImproveRun {
    Mesh& target;
    const ImproveParameters& parameters;
    core::Observer& observer;
    const StopCondition& stop;
    std::unique_ptr<RatedMesh> rated;
    ImproveReport report = {};

    ImproveRun(Mesh& mesh, const ImproveParameters& wanted, core::Observer& watching, const StopCondition& stopping);
    RatedMesh& mesh() { return *rated; }
    /// Puts the mesh of another run, on a copy of this one's input, in the place of this one's.
    void adopt(ImproveRun& other);

    /// Reports the state of the mesh and decides whether to go on; fills report.end when not.
    bool goes_on(const char* stage);
    /// Adds what passes have done to the report.
    void add(const PassCounts& counts);
};

class SchedulePolicy {
public:
    virtual ~SchedulePolicy() = default;
    virtual void run(ImproveRun& run) = 0;
};

/// Algorithm 1. Hill climbing: smoothing, topological pass and thinning pass until neither improves the mesh.
class ThesisSchedule final : public SchedulePolicy {
public:
    struct Parameters {
        /// Of an indicator, above the highest value it has had, that counts as an improvement (thesis 3.4).
        double least_gain = 1e-4;
        int failures = 3;  ///< fruitless rounds in a row that end it
        /// From here on a mesh is too large for the cache of a core, and is worked on in an order of its own.
        std::uint32_t many_vertices = 10'000;
    };
    explicit ThesisSchedule(const Parameters& parameters) : parameters_(parameters) {}
    void run(ImproveRun& run) override;

private:
    Parameters parameters_;
};

/// Algorithm 1 from several starts: from the input, and from where it leads by another measure; the best goes on. Then
/// escapes around the worst tetrahedra: first by the measure asked for; then, for the measures made
/// of sines, by one whose bias lets the smallest and the largest angle weigh the same, so that both ends go on
/// improving when one has come to its limit.
class BestSchedule final : public SchedulePolicy {
public:
    struct Parameters {
        std::size_t budget = 4'000'000;  ///< of escapes: tetrahedra changed on the way, taken back or not
        double poor = 1.25;              ///< a tetrahedron is poor below this multiple of the worst quality
        std::size_t least_targets = 30;  ///< tetrahedra tried in one round, the worst ones, poor or not
        std::size_t most_targets = 200;
        std::size_t round = 100;    ///< attempts between two looks at the whole mesh, at least
        int rounds = 20;            ///< of escapes between two passes over the whole mesh
        double least_kept = 0.005;  ///< share of attempts that have to succeed; with less, the search is stuck
        double patience = 0.25;     ///< share of the budget after which a search that is stuck ends
        /// A collapse makes no edge longer than this multiple of the mean edge length that algorithm 1 has left there.
        double edge_growth = 1.7;
        double fine_gain = 0.002;  ///< of a smoothing step, relative; finer than that of algorithm 1
    };
    explicit BestSchedule(const Parameters& parameters) : parameters_(parameters) {}
    void run(ImproveRun& run) override;

private:
    struct Progress;
    void climb(ImproveRun& run) const;
    Progress escape(ImproveRun& run, std::uint64_t seed, std::size_t budget) const;
    std::vector<TetId> targets(const RatedMesh& mesh) const;

    Parameters parameters_;
};

std::unique_ptr<SchedulePolicy> make_schedule(Schedule schedule);

}  // namespace dsc::dsc3d
