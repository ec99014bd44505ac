// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/improve/escapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dsc::dsc3d {

Escapes::Escapes(RatedMesh& mesh, Passes& passes, const EscapeParameters& parameters, std::uint64_t seed)
    : mesh_(mesh), passes_(passes), parameters_(parameters), random_(seed) {}

Escapes::Attempt Escapes::attempt(TetId t, double worst) {
    constexpr std::size_t search_cost = 10;
    const PassCounts counts = passes_.counts();
    mesh_.begin();
    // Mostly one change, seldom several.
    int kicks = 1;
    while (kicks < parameters_.longest_kick && random_.below(3) == 0) ++kicks;
    bool is_changed = kick(t);
    for (int i = 1; i < kicks; ++i) {
        const std::span<const TetId> touched = mesh_.transaction().touched();
        if (touched.empty()) break;
        is_changed = kick(touched[random_.below(touched.size())]) || is_changed;
    }
    if (is_changed) settle();
    const std::size_t changed = mesh_.transaction().touched().size() + mesh_.transaction().qualities_before().size();
    const bool is_kept = is_changed && is_better(worst);
    if (is_kept) {
        const std::span<const TetId> touched = mesh_.transaction().touched();
        changed_.assign(touched.begin(), touched.end());
        mesh_.commit();
    } else {
        mesh_.roll_back();
        passes_.set_counts(counts);
    }
    return {is_kept, search_cost + changed};
}

TetId Escapes::random_neighbour(TetId t) {
    const TetId next = mesh_.complex().neighbour(t, static_cast<int>(random_.below(4)));
    return next.is_valid() ? next : t;
}

bool Escapes::kick(TetId t) {
    if (random_.below(3) == 0) t = random_neighbour(t);
    const EdgeId e = mesh_.complex().edges(t)[random_.below(6)];
    const std::uint64_t kind = random_.below(12);
    if (kind < 4) return kick_edge(e);
    if (kind < 6) return kick_face(mesh_.complex().faces(t)[random_.below(4)]);
    if (kind < 7 && parameters_.removes_vertices)
        return kick_collapse(e, mesh_.complex().vertices(e)[random_.below(2)]);
    if (kind < 9 && parameters_.relocates_vertices) return kick_relocation(t);
    return kick_vertex(mesh_.complex().vertices(t)[random_.below(4)]);
}

bool Escapes::kick_edge(EdgeId e) { return edge_removal_.propose(mesh_, e, proposal_, 0.0) && mesh_.apply(proposal_); }

bool Escapes::kick_face(FaceId f) {
    multi_face_.gather(mesh_, f);
    return multi_face_.propose_removal(mesh_, proposal_, 0.0) && mesh_.apply(proposal_);
}

bool Escapes::kick_collapse(EdgeId e, VertexId kept) {
    return collapse_.propose(mesh_, e, kept, 0.0, proposal_) && mesh_.apply(proposal_);
}

bool Escapes::kick_vertex(VertexId v) {
    if (mesh_.surface().motion(v) == VertexMotion::fixed) return false;
    const std::span<const TetId> star = mesh_.walker().star(v);
    double length = 0;
    for (const TetId t : star)
        for (const VertexId u : mesh_.complex().vertices(t)) length += (mesh_.position(u) - mesh_.position(v)).norm();
    length /= 3 * static_cast<double>(star.size());
    const double x = random_.uniform(-1, 1), y = random_.uniform(-1, 1), z = random_.uniform(-1, 1);
    Eigen::Vector3d step = parameters_.longest_push * length * mesh_.surface().allowed(v, Eigen::Vector3d(x, y, z));
    for (int halving = 0; halving < 4; ++halving, step *= 0.5) {
        const Point3 place = mesh_.surface().settled(v, mesh_.position(v) + step);
        if (mesh_.surface().has_room(v, place) && mesh_.move(v, place, star)) return true;
    }
    return false;
}

// To an edge of t, which may be its only one inside a region, from a vertex that a random walk comes across.
bool Escapes::kick_relocation(TetId t) {
    std::array<EdgeId, 6> inside;
    std::size_t count = 0;
    for (const EdgeId e : mesh_.complex().edges(t))
        if (!mesh_.complex().is_surface(e)) inside[count++] = e;
    if (count == 0) return false;
    const EdgeId e = inside[random_.below(count)];
    for (int i = 0; i < parameters_.longest_walk; ++i) {
        t = random_neighbour(t);
        const VertexId v = mesh_.complex().vertices(t)[random_.below(4)];
        if (!relocation_.propose(mesh_, v, e, proposal_) || !mesh_.apply(proposal_)) continue;
        passes_.smooth(v);
        return true;
    }
    return false;
}

void Escapes::settle() {
    for (int round = 0; round < parameters_.settling_rounds; ++round) {
        const std::span<const TetId> touched = mesh_.transaction().touched();
        tets_.assign(touched.begin(), touched.end());
        region_.clear();
        for (const TetId t : tets_)
            for (const VertexId v : mesh_.complex().vertices(t)) region_.push_back(v);
        std::sort(region_.begin(), region_.end());
        region_.erase(std::unique(region_.begin(), region_.end()), region_.end());
        const std::uint32_t before = mesh_.time();
        for (const TetId t : tets_)
            if (!mesh_.complex().is_deleted(t)) passes_.remove_tet(t);
        for (const VertexId v : region_)
            if (!mesh_.complex().is_deleted(v)) passes_.smooth(v);
        if (mesh_.time() == before) break;
    }
}

bool Escapes::is_better(double worst) {
    Transaction& change = mesh_.transaction();
    double gain = 0, least_before = std::numeric_limits<double>::infinity(), least_after = least_before;
    for (const double q : change.qualities_before()) {
        gain += std::pow(worst / q, parameters_.power);
        least_before = std::min(least_before, q);
    }
    for (const TetId t : change.touched()) {
        gain -= std::pow(worst / mesh_.quality(t), parameters_.power);
        least_after = std::min(least_after, mesh_.quality(t));
    }
    return gain > parameters_.least_gain && least_after >= std::min(least_before, worst);
}

}  // namespace dsc::dsc3d
