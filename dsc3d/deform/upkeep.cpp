// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/upkeep.h"

#include <algorithm>
#include <array>
#include <limits>

#include "dsc3d/operations/split.h"

namespace dsc::dsc3d {

namespace {

// What has failed before is tried half as often each time, as long as the tetrahedron stays.
constexpr std::uint8_t most_failures = 10;

// A collapse has to be an improvement, however good what it leaves.
constexpr double always_improve = std::numeric_limits<double>::infinity();

void add_difference(const PassCounts& before, const PassCounts& after, motion::StepCounts& counts) {
    counts.smoothings += after.smoothings - before.smoothings;
    counts.flips += after.edge_removals + after.multi_face_removals + after.multi_face_retriangulations -
                    before.edge_removals - before.multi_face_removals - before.multi_face_retriangulations;
    counts.collapses += after.collapses - before.collapses;
}

// What has all its vertices fixed is as thin as the surface makes it.
bool is_bound(const RatedMesh& mesh, TetId t) {
    const TetVertices& v = mesh.complex().vertices(t);
    return std::all_of(v.begin(), v.end(),
                       [&](VertexId corner) { return mesh.surface().motion(corner) == VertexMotion::fixed; });
}

}  // namespace

Upkeep::Upkeep(RatedMesh& mesh, std::uint64_t seed)
    : passes_(mesh, {.removes_surface_vertices = true, .enough = always_improve}),
      escapes_(mesh, passes_, {}, seed),
      failures_(mesh.complex().tet_attributes(), std::uint8_t{0}) {}

void Upkeep::run(PassContext& context) {
    const PassCounts before = passes_.counts();
    climb(context);
    add_difference(before, passes_.counts(), context.report.counts);
}

void Upkeep::smooth(PassContext& context) {
    const PassCounts before = passes_.counts();
    for (const VertexId v : context.region.vertices(context.complex()))
        if (context.mesh.surface().motion(v) != VertexMotion::fixed) passes_.smooth(v);
    add_difference(before, passes_.counts(), context.report.counts);
}

void Upkeep::rescue(PassContext& context) {
    const PassCounts before = passes_.counts();
    escape(context);
    insert_vertices(context);
    add_difference(before, passes_.counts(), context.report.counts);
}

// Of `tets`, some of which may be deleted, the worst first.
void Upkeep::gather(const RatedMesh& mesh, std::span<const TetId> tets, double below) {
    poor_.clear();
    for (const TetId t : tets)
        if (!mesh.complex().is_deleted(t) && mesh.quality(t) < below) poor_.push_back(t);
    std::sort(poor_.begin(), poor_.end(), [&](TetId a, TetId b) {
        return mesh.quality(a) < mesh.quality(b) || (mesh.quality(a) == mesh.quality(b) && a < b);
    });
}

void Upkeep::climb(PassContext& context) {
    const Complex& complex = context.complex();
    around_.assign(context.region.tets());
    for (int round = 0; round < context.parameters.upkeep_rounds; ++round) {
        gather(context.mesh, around_.tets(), context.parameters.poor_quality);
        around_.assign(poor_);
        const std::vector<VertexId> vertices = around_.vertices(complex);
        bool has_changed = false;
        for (const TetId t : poor_)
            if (!complex.is_deleted(t) && mend(context, t)) has_changed = true;
        if (!has_changed) break;
        around_.clear();
        for (const VertexId v : vertices)
            if (!complex.is_deleted(v)) around_.add_star(context.mesh, v);
        around_.settle(complex);
        context.region.add(around_.tets());
    }
    context.region.settle(complex);
}

bool Upkeep::mend(const PassContext& context, TetId t) {
    const RatedMesh& mesh = context.mesh;
    const Complex& complex = context.complex();
    bool has_changed = false;
    for (const VertexId v : TetVertices(complex.vertices(t))) {
        if (!context.parameters.smooths) break;
        if (mesh.surface().motion(v) == VertexMotion::fixed) continue;
        has_changed = passes_.smooth(v) || has_changed;
        if (mesh.quality(t) >= context.parameters.poor_quality) return has_changed;
    }
    if (context.parameters.flips && passes_.remove_tet(t)) return true;
    if (!context.parameters.thins) return has_changed;
    for (const EdgeId e : complex.edges(t))
        if (!complex.is_interface(e) && passes_.collapse_edge(e)) return true;
    return has_changed;
}

void Upkeep::escape(PassContext& context) {
    const Complex& complex = context.complex();
    bool has_changed = true;
    int left = context.parameters.least_escapes +
               static_cast<int>(context.parameters.escape_share * static_cast<double>(context.region.tets().size()));
    for (int round = 0; has_changed && left > 0 && round < context.parameters.upkeep_rounds; ++round) {
        has_changed = false;
        gather(context.mesh, context.region.tets(), context.parameters.bad_quality);
        for (const TetId t : poor_) {
            if (complex.is_deleted(t) || is_bound(context.mesh, t)) continue;
            const int attempts = std::max(1, context.parameters.escape_attempts >> failures_[t]);
            for (int i = 0; i < attempts && left > 0; ++i, --left) {
                if (complex.is_deleted(t) || context.mesh.quality(t) >= context.parameters.bad_quality) break;
                if (!escapes_.attempt(t, context.mesh.quality(t)).is_kept) continue;
                context.region.add(escapes_.changed());
                has_changed = true;
            }
            if (!complex.is_deleted(t) && context.mesh.quality(t) < context.parameters.bad_quality &&
                failures_[t] < most_failures)
                ++failures_[t];
        }
        context.region.settle(complex);
    }
}

void Upkeep::insert_vertices(PassContext& context) {
    gather(context.mesh, context.region.tets(), context.parameters.bad_quality);
    for (const TetId t : poor_) {
        if (context.complex().is_deleted(t) || context.mesh.quality(t) >= context.parameters.bad_quality) continue;
        context.report.counts.edge_splits += insert_vertex(context, t) ? 1 : 0;
    }
    context.region.settle(context.complex());
}

// On an edge of t off the surface, the longest first, if that makes the worst tetrahedron better.
bool Upkeep::insert_vertex(PassContext& context, TetId t) {
    RatedMesh& mesh = context.mesh;
    std::array<std::pair<double, EdgeId>, 6> edges;
    for (std::size_t i = 0; i < 6; ++i) {
        const EdgeId e = mesh.complex().edges(t)[i];
        edges[i] = {-context.relative_length(e), e};
    }
    std::sort(edges.begin(), edges.end());
    for (const auto& [length, e] : edges) {
        if (-length < context.parameters.insertion_edge) break;
        if (mesh.complex().is_interface(e)) continue;
        const Point3 middle = context.middle(e);
        if (!can_split(mesh.mesh(), e, middle)) continue;
        mesh.begin();
        const VertexId m = mesh.split(e, middle);
        double before = 1;
        for (const double quality : mesh.transaction().qualities_before()) before = std::min(before, quality);
        passes_.smooth(m);
        const std::span<const TetId> star = mesh.walker().star(m);
        if (mesh.worst_quality(star) > context.parameters.insertion_gain * before) {
            mesh.commit();
            context.region.add(star);
            return true;
        }
        mesh.roll_back();
    }
    return false;
}

}  // namespace dsc::dsc3d
