// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/advance.h"

#include <algorithm>
#include <cmath>

#include "core/sort_unique.h"

namespace dsc::dsc3d {

Advance::Advance(const Mesh& mesh)
    : place_(mesh.complex().vertex_attributes(), 0u), tet_place_(mesh.complex().tet_attributes(), 0u) {}

void Advance::run(RatedMesh& mesh, std::span<const VertexId> vertices, const core::Attribute<VertexId, Point3>& target,
                  const AdvanceParameters& parameters) {
    gather(mesh, vertices, parameters);
    for (std::size_t i = 0; i < targeted_; ++i) step_[i] = target[movers_[i]] - mesh.position(movers_[i]);
    spread(mesh, parameters.sweeps);
    goal_.resize(movers_.size());
    for (std::size_t i = 0; i < movers_.size(); ++i)
        goal_[i] = i < targeted_ ? target[movers_[i]]
                                 : mesh.surface().settled(movers_[i], mesh.position(movers_[i]) + step_[i]);
    hold_back(mesh, parameters);
    apply(mesh);
    for (const VertexId v : movers_) place_[v] = 0;
    for (const TetId t : tets_) tet_place_[t] = 0;
}

// The vertices that move, ring by ring, and the tetrahedra at them.
void Advance::gather(RatedMesh& mesh, std::span<const VertexId> vertices, const AdvanceParameters& parameters) {
    const Complex& complex = mesh.complex();
    movers_.assign(vertices.begin(), vertices.end());
    targeted_ = movers_.size();
    for (std::size_t i = 0; i < movers_.size(); ++i) place_[movers_[i]] = static_cast<std::uint32_t>(i + 1);
    tets_.clear();
    std::size_t begin = 0;
    for (int ring = 0; ring <= parameters.carried_rings; ++ring) {
        const std::size_t end = movers_.size();
        for (std::size_t i = begin; i < end; ++i) {
            for (const TetId t : mesh.walker().star(movers_[i])) {
                if (tet_place_[t] != 0) continue;
                tets_.push_back(t);
                tet_place_[t] = static_cast<std::uint32_t>(tets_.size());
                if (ring == parameters.carried_rings) continue;
                for (const VertexId v : complex.vertices(t)) {
                    if (place_[v] != 0 || mesh.surface().motion(v) == VertexMotion::fixed) continue;
                    movers_.push_back(v);
                    place_[v] = static_cast<std::uint32_t>(movers_.size());
                }
            }
        }
        begin = end;
    }
    step_.assign(movers_.size(), Point3::Zero());
    share_.assign(movers_.size(), 1.0);
}

// Harmonic in the graph of the edges: the ways of carried vertices are means of those of their neighbours.
void Advance::spread(const RatedMesh& mesh, int sweeps) {
    const Complex& complex = mesh.complex();
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        sum_.assign(movers_.size() - targeted_, Point3::Zero());
        count_.assign(movers_.size() - targeted_, 0.0);
        for (const TetId t : tets_) {
            Point3 total = Point3::Zero();
            std::array<std::uint32_t, 4> places;
            for (std::size_t i = 0; i < 4; ++i) {
                places[i] = place_[complex.vertices(t)[i]];
                if (places[i] != 0) total += step_[places[i] - 1];
            }
            for (const std::uint32_t place : places) {
                if (place <= targeted_) continue;
                sum_[place - 1 - targeted_] += total - step_[place - 1];
                count_[place - 1 - targeted_] += 3;
            }
        }
        for (std::size_t i = 0; i < sum_.size(); ++i)
            step_[targeted_ + i] = mesh.surface().allowed(movers_[targeted_ + i], sum_[i] / count_[i]);
    }
}

double Advance::rate(const RatedMesh& mesh, TetId t, bool& is_positive) const {
    std::array<Point3, 4> p;
    for (std::size_t i = 0; i < 4; ++i) p[i] = there(mesh, mesh.complex().vertices(t)[i]);
    is_positive = geometry::is_positive(p[0], p[1], p[2], p[3]);
    return is_positive ? geometry::quality(mesh.measure(), p[0], p[1], p[2], p[3], mesh.bias()) : 0;
}

// Halves the ways of vertices at tetrahedra that would be spoilt, carried ones first, until there are none.
void Advance::hold_back(RatedMesh& mesh, const AdvanceParameters& parameters) {
    const Complex& complex = mesh.complex();
    const double least_share = std::pow(0.5, parameters.halvings);
    quality_.resize(tets_.size());
    std::vector<TetId> waiting, next;
    const auto judge = [&](TetId t) {
        bool is_positive = false;
        double& quality = quality_[tet_place_[t] - 1];
        quality = rate(mesh, t, is_positive);
        return is_positive && quality >= std::min(parameters.least_quality, mesh.quality(t));
    };
    for (const TetId t : tets_)
        if (!judge(t)) waiting.push_back(t);
    while (!waiting.empty()) {
        next.clear();
        for (const TetId t : waiting) {
            if (judge(t)) continue;
            const auto may_be_held = [&](VertexId v, bool targeted) {
                return is_mover(v) && is_targeted(v) == targeted && share_[place_[v] - 1] > 0;
            };
            bool has_carried = false;
            for (const VertexId v : complex.vertices(t)) has_carried = has_carried || may_be_held(v, false);
            for (const VertexId v : complex.vertices(t)) {
                if (!may_be_held(v, !has_carried)) continue;
                double& share = share_[place_[v] - 1];
                share = share > least_share ? 0.5 * share : 0;
                for (const TetId s : mesh.walker().star(v))
                    if (!judge(s)) next.push_back(s);
            }
        }
        core::sort_unique(next);
        waiting.swap(next);
    }
}

void Advance::apply(RatedMesh& mesh) {
    for (std::size_t i = 0; i < movers_.size(); ++i) goal_[i] = there(mesh, movers_[i]);
    mesh.move_together(movers_, goal_, tets_, quality_);
}

}  // namespace dsc::dsc3d
