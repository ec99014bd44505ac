// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/deformer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <string>

#include "core/errors.h"
#include "dsc3d/operations/split.h"

namespace dsc::dsc3d {

namespace {

double signed_volume(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    return (b - a).dot((c - a).cross(d - a)) / 6;
}

template <class Value>
void sort_unique(std::vector<Value>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace

Deformer::Deformer(Mesh& mesh, const DeformParameters& parameters)
    : mesh_(mesh),
      parameters_(parameters),
      rated_(mesh, geometry::QualityMeasure::volume_length, FlatSurface::rigid(mesh)),
      passes_(rated_, {}),
      target_(mesh.complex().vertex_attributes(), Point3(Point3::Zero())) {
    parameters_.validate();
}

// Algorithm 4, one time step.
StepReport Deformer::step(std::span<const std::optional<Point3>> targets) {
    StepReport report;
    set_targets(targets);
    bool is_complete = moving_.empty();
    while (!is_complete && report.substeps < parameters_.max_substeps) {
        is_complete = move_vertices_step(report);
        improve(report);
        ++report.substeps;
    }
    report_unfinished(report);
    return report;
}

void Deformer::set_targets(std::span<const std::optional<Point3>> targets) {
    const Complex& complex = mesh_.complex();
    if (targets.size() > complex.vertex_capacity()) throw core::UsageError("step: more targets than vertices");
    moving_.clear();
    for (std::uint32_t i = 0; i < targets.size(); ++i) {
        if (!targets[i]) continue;
        const VertexId v(i);
        const auto refuse = [&](const char* why) {
            throw core::UsageError("step: vertex " + std::to_string(i) + " can't have a target: " + why);
        };
        if (complex.is_deleted(v)) refuse("it is deleted");
        if (complex.is_boundary(v)) refuse("it lies on the domain's boundary");
        if (!complex.is_interface(v)) refuse("it lies off the interface");
        if (!targets[i]->allFinite()) refuse("it is not finite");
        target_[v] = *targets[i];
        moving_.push_back(v);
    }
}

// Algorithm 5. True when every vertex is at its target.
bool Deformer::move_vertices_step(StepReport& report) {
    active_.clear();
    std::size_t left = 0;
    for (const VertexId v : std::vector<VertexId>(moving_))
        if (!move_one(v, report)) moving_[left++] = v;
    moving_.resize(left);
    return left == 0;
}

// The share of the way to its target at which v meets the plane of a face of its link, or more than 1.
double Deformer::share_to_link(std::span<const TetId> star, VertexId v, const Point3& target) const {
    double share = std::numeric_limits<double>::infinity();
    for (const TetId t : star) {
        const FaceVertices face = mesh_.complex().oriented_face(t, mesh_.complex().index_of(t, v));
        const Point3 &b = mesh_.position(face[0]), &c = mesh_.position(face[1]), &d = mesh_.position(face[2]);
        const double here = signed_volume(mesh_.position(v), b, c, d), there = signed_volume(target, b, c, d);
        if (there < here) share = std::min(share, here / (here - there));
    }
    return share;
}

// True when v is at its target.
bool Deformer::move_one(VertexId v, StepReport& report) {
    const std::span<const TetId> star = rated_.walker().star(v);
    const Point3 start = mesh_.position(v), target = target_[v];
    const double least = std::min(rated_.worst_quality(star), parameters_.stopping_quality);
    const auto try_share = [&](double share) {
        const Point3 place = share == 1 ? target : Point3(start + share * (target - start));
        return rated_.move(v, place, star, least);
    };
    const double to_link = share_to_link(star, v, target);
    bool is_moved = to_link > 1 && try_share(1);
    if (is_moved) {
        ++report.counts.moves;
        active_.push_back(v);
        return true;
    }
    ++report.counts.blocked_moves;
    for (double share = parameters_.approach * std::min(to_link, 1.0); !is_moved && share > 0.01; share *= 0.5)
        is_moved = try_share(share);
    active_.push_back(v);
    return false;
}

// Algorithm 4, step 10.
void Deformer::improve(StepReport& report) {
    gather_region();
    split_bridges(report);
    raise_quality(report);
    remove_degeneracies(report);
    collapse_short_edges(report);
}

void Deformer::gather_region() {
    const Complex& complex = mesh_.complex();
    tets_.clear();
    for (const VertexId v : active_) {
        if (complex.is_deleted(v)) continue;
        const std::span<const TetId> star = rated_.walker().star(v);
        tets_.insert(tets_.end(), star.begin(), star.end());
    }
    sort_unique(tets_);
    vertices_.clear();
    for (const TetId t : tets_)
        for (const VertexId v : complex.vertices(t)) vertices_.push_back(v);
    sort_unique(vertices_);
}

// The edges of the region that are off the surface.
std::vector<EdgeId> Deformer::inner_edges() const {
    std::vector<EdgeId> edges;
    for (const TetId t : tets_)
        for (const EdgeId e : mesh_.complex().edges(t))
            if (!mesh_.complex().is_surface(e)) edges.push_back(e);
    sort_unique(edges);
    return edges;
}

void Deformer::raise_quality(StepReport& report) {
    const Complex& complex = mesh_.complex();
    const PassCounts before = passes_.counts();
    for (const VertexId v : vertices_) {
        if (complex.is_deleted(v) || complex.is_surface(v)) continue;
        if (rated_.worst_quality(rated_.walker().star(v)) < parameters_.poor_quality) passes_.smooth(v);
    }
    // What smoothing has not helped goes; what comes may want smoothing.
    for (const TetId t : tets_)
        if (!complex.is_deleted(t) && rated_.quality(t) < parameters_.poor_quality) passes_.remove_tet(t);
    for (const VertexId v : vertices_) {
        if (complex.is_deleted(v) || complex.is_surface(v)) continue;
        if (rated_.worst_quality(rated_.walker().star(v)) < parameters_.poor_quality) passes_.smooth(v);
    }
    const PassCounts& after = passes_.counts();
    report.counts.smoothings += after.smoothings - before.smoothings;
    report.counts.flips += after.edge_removals + after.multi_face_removals + after.multi_face_retriangulations -
                           before.edge_removals - before.multi_face_removals - before.multi_face_retriangulations;
}

void Deformer::remove_degeneracies(StepReport& report) {
    gather_region();
    for (const TetId t : tets_) {
        if (mesh_.complex().is_deleted(t) || rated_.quality(t) >= parameters_.degenerate_quality) continue;
        report.counts.collapses += remove_degenerate(t) ? 1 : 0;
    }
}

// By the collapse of an edge off the interface, the shortest first.
bool Deformer::remove_degenerate(TetId t) {
    const Complex& complex = mesh_.complex();
    std::array<std::pair<double, EdgeId>, 6> edges;
    for (std::size_t i = 0; i < 6; ++i) {
        const EdgeId e = complex.edges(t)[i];
        const auto [a, b] = complex.vertices(e);
        edges[i] = {(mesh_.position(a) - mesh_.position(b)).squaredNorm(), e};
    }
    std::sort(edges.begin(), edges.end());
    for (const auto& [length, e] : edges)
        for (const VertexId kept : complex.vertices(e))
            if (collapse_.propose(rated_, e, kept, 1, proposal_) && rated_.apply(proposal_)) return true;
    return false;
}

void Deformer::collapse_short_edges(StepReport& report) {
    const Complex& complex = mesh_.complex();
    const double shortest = parameters_.min_edge * parameters_.edge_length;
    gather_region();
    for (const EdgeId e : inner_edges()) {
        if (complex.is_deleted(e)) continue;
        const auto [a, b] = complex.vertices(e);
        if ((mesh_.position(a) - mesh_.position(b)).norm() >= shortest) continue;
        for (const VertexId kept : {a, b}) {
            if (!collapse_.propose(rated_, e, kept, parameters_.collapse_quality, proposal_)) continue;
            if (!rated_.apply(proposal_)) continue;
            ++report.counts.collapses;
            break;
        }
    }
}

// Edges that join the interface directly to itself or to the boundary leave it no room to move.
void Deformer::split_bridges(StepReport& report) {
    const Complex& complex = mesh_.complex();
    const double longest = parameters_.max_bridge * parameters_.edge_length;
    for (const EdgeId e : inner_edges()) {
        if (complex.is_deleted(e)) continue;
        const auto [a, b] = complex.vertices(e);
        if (!complex.is_surface(a) || !complex.is_surface(b)) continue;
        if ((mesh_.position(a) - mesh_.position(b)).norm() <= longest) continue;
        if (rated_.split(e, 0.5 * (mesh_.position(a) + mesh_.position(b)))) ++report.counts.edge_splits;
    }
    gather_region();
}

void Deformer::report_unfinished(StepReport& report) {
    for (const VertexId v : moving_) {
        report.unfinished.push_back({v, target_[v] - mesh_.position(v), false});
        report.is_complete = false;
    }
    moving_.clear();
}

StepReport Deformer::improve_everywhere() {
    StepReport report;
    active_.clear();
    for (std::uint32_t i = 0; i < mesh_.complex().vertex_capacity(); ++i)
        if (!mesh_.complex().is_deleted(VertexId(i))) active_.push_back(VertexId(i));
    improve(report);
    return report;
}

}  // namespace dsc::dsc3d
