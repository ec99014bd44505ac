// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/improve/passes.h"

#include <algorithm>
#include <limits>

namespace dsc::dsc3d {

Passes::Passes(RatedMesh& mesh, const PassParameters& parameters, const StopCondition* stop)
    : mesh_(mesh),
      parameters_(parameters),
      stop_(stop),
      enough_(parameters.enough),
      smoothing_(parameters.smoothing),
      smoothed_(mesh.complex().vertex_attributes(), 0u),
      removal_tried_(mesh.complex().edge_attributes(), 0u),
      face_tried_(mesh.complex().face_attributes(), 0u),
      collapse_tried_(mesh.complex().edge_attributes(), 0u) {}

void Passes::smooth_all_vertices() {
    for (std::uint32_t i = 0; i < mesh_.complex().vertex_capacity() && !is_stopped(i); ++i)
        if (!mesh_.complex().is_deleted(VertexId(i))) smooth(VertexId(i));
}

bool Passes::smooth(VertexId v) {
    if (mesh_.changed(v) <= smoothed_[v]) return false;
    const bool is_moved = smoothing_.smooth(mesh_, v);
    smoothed_[v] = mesh_.time();
    counts_.smoothings += is_moved ? 1 : 0;
    return is_moved;
}

void Passes::topological_pass() {
    std::vector<TetId> list;
    list.reserve(mesh_.complex().tet_count());
    for (std::uint32_t i = 0; i < mesh_.complex().tet_capacity(); ++i)
        if (!mesh_.complex().is_deleted(TetId(i))) list.push_back(TetId(i));
    for (std::uint32_t i = 0; i < list.size() && !is_stopped(i); ++i)
        if (!mesh_.complex().is_deleted(list[i])) remove_tet(list[i]);
}

bool Passes::remove_tet(TetId t) {
    for (const EdgeId e : mesh_.complex().edges(t))
        if (remove_edge(e)) return true;
    for (const FaceId f : mesh_.complex().faces(t))
        if (remove_face(f)) return true;
    return false;
}

// Everything that decides about an edge is in the star of its ends; about a face, in the stars of the two vertices
// opposite to it.
bool Passes::remove_edge(EdgeId e) {
    const auto [a, b] = mesh_.complex().vertices(e);
    if (std::max(mesh_.changed(a), mesh_.changed(b)) <= removal_tried_[e]) return false;
    removal_tried_[e] = mesh_.time();
    if (!edge_removal_.propose(mesh_, e, proposal_) || !mesh_.apply(proposal_)) return false;
    ++counts_.edge_removals;
    return true;
}

bool Passes::remove_face(FaceId f) {
    const Complex& complex = mesh_.complex();
    std::uint32_t changed = 0;
    for (const TetId t : complex.tets(f)) {
        if (!t.is_valid()) continue;
        const int apex = complex.index_of(t, f);
        changed = std::max(changed, mesh_.changed(complex.vertices(t)[static_cast<std::size_t>(apex)]));
    }
    if (changed <= face_tried_[f]) return false;
    face_tried_[f] = mesh_.time();
    multi_face_.gather(mesh_, f);
    if (parameters_.uses_multi_face_retriangulation && multi_face_.propose_retriangulation(mesh_, proposal_) &&
        mesh_.apply(proposal_)) {
        ++counts_.multi_face_retriangulations;
        return true;
    }
    if (!multi_face_.propose_removal(mesh_, proposal_) || !mesh_.apply(proposal_)) return false;
    ++counts_.multi_face_removals;
    return true;
}

void Passes::thinning_pass() {
    double worst = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < mesh_.complex().tet_capacity(); ++i)
        if (!mesh_.complex().is_deleted(TetId(i))) worst = std::min(worst, mesh_.quality(TetId(i)));
    enough_ = std::max(parameters_.enough, worst);
    for (std::uint32_t i = 0; i < mesh_.complex().edge_capacity() && !is_stopped(i); ++i)
        if (!mesh_.complex().is_deleted(EdgeId(i))) collapse_edge(EdgeId(i));
}

bool Passes::collapse_edge(EdgeId e) {
    const auto [a, b] = mesh_.complex().vertices(e);
    if (std::max(mesh_.changed(a), mesh_.changed(b)) <= collapse_tried_[e]) return false;
    collapse_tried_[e] = mesh_.time();
    return collapse_edge(e, a) || collapse_edge(e, b);
}

bool Passes::collapse_edge(EdgeId e, VertexId kept) {
    const Complex& complex = mesh_.complex();
    const auto [a, b] = complex.vertices(e);
    const VertexId gone = a == kept ? b : a;
    if (complex.is_surface(gone) && !parameters_.removes_surface_vertices) return false;
    if (!collapse_.propose(mesh_, e, kept, enough_, proposal_) || !mesh_.apply(proposal_)) return false;
    ++counts_.collapses;
    smooth(kept);
    return true;
}

}  // namespace dsc::dsc3d
