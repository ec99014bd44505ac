// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/rated_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dsc3d/operations/split.h"

namespace dsc::dsc3d {

RatedMesh::RatedMesh(Mesh& mesh, geometry::QualityMeasure measure, const FlatSurfaceParameters& parameters)
    : RatedMesh(mesh, measure, FlatSurface(mesh, parameters)) {}

RatedMesh::RatedMesh(Mesh& mesh, geometry::QualityMeasure measure, FlatSurface surface)
    : mesh_(&mesh),
      measure_(measure),
      surface_(std::move(surface)),
      quality_(mesh.complex().tet_attributes(), 0.0),
      changed_(mesh.complex().vertex_attributes(), 1u),
      longest_edge_(mesh.complex().vertex_attributes(), std::numeric_limits<double>::infinity()),
      walker_(mesh.complex()),
      transaction_(mesh.complex()) {
    set_measure(measure);
}

void RatedMesh::set_measure(geometry::QualityMeasure measure, double bias) {
    measure_ = measure;
    bias_ = bias;
    for (std::uint32_t i = 0; i < complex().tet_capacity(); ++i)
        if (!complex().is_deleted(TetId(i))) quality_[TetId(i)] = rate(complex().vertices(TetId(i)));
}

void RatedMesh::limit_edges(double growth) {
    std::vector<std::pair<double, int>> at_vertex(complex().vertex_capacity());
    for (std::uint32_t i = 0; i < complex().edge_capacity(); ++i) {
        if (complex().is_deleted(EdgeId(i))) continue;
        const auto [a, b] = complex().vertices(EdgeId(i));
        for (const VertexId v : {a, b}) {
            at_vertex[v.index()].first += (position(a) - position(b)).norm();
            ++at_vertex[v.index()].second;
        }
    }
    for (std::uint32_t i = 0; i < complex().vertex_capacity(); ++i)
        if (!complex().is_deleted(VertexId(i)))
            longest_edge_[VertexId(i)] = growth * at_vertex[i].first / at_vertex[i].second;
}

double RatedMesh::worst_quality(std::span<const TetId> tets) const {
    double worst = std::numeric_limits<double>::infinity();
    for (const TetId t : tets) worst = std::min(worst, quality_[t]);
    return worst;
}

bool RatedMesh::apply(const Proposal& proposal) {
    const VertexId moved = proposal.moved;
    const Point3 before = moved.is_valid() ? position(moved) : Point3::Zero();
    if (moved.is_valid()) mesh_->set_position(moved, proposal.place);
    for (const NewTet& tet : proposal.added) {
        if (mesh_->is_positive(tet.vertices)) continue;
        if (moved.is_valid()) mesh_->set_position(moved, before);
        return false;
    }
    if (transaction_.is_open()) {
        if (moved.is_valid()) transaction_.note_move(moved, before);
        for (const TetId t : proposal.removed) transaction_.note_removal(*mesh_, surface_, t, quality_[t]);
        if (proposal.gone.is_valid())
            transaction_.note_vertex_removal(*mesh_, surface_, proposal.gone, longest_edge_[proposal.gone]);
    }
    exchange(proposal.removed, proposal.added, proposal.surface);
    return true;
}

bool RatedMesh::apply_with(const Proposal& proposal, VertexId v, const Point3& place, double least) {
    DSC_ASSERT(!transaction_.is_open());
    const Point3 before = mesh_->position(v);
    mesh_->set_position(v, place);
    const bool is_good = std::all_of(proposal.added.begin(), proposal.added.end(), [&](const NewTet& tet) {
        return mesh_->is_positive(tet.vertices) && rate(tet.vertices) >= least;
    });
    if (is_good) {
        exchange(proposal.removed, proposal.added, proposal.surface);
    } else {
        mesh_->set_position(v, before);
    }
    return is_good;
}

void RatedMesh::exchange(std::span<const TetId> removed, std::span<const NewTet> added,
                         std::span<const SurfaceFace> surface) {
    ++time_;
    for (const TetId t : removed)
        for (const VertexId v : complex().vertices(t)) changed_[v] = time_;
    const Complex::Change& change = mesh_->complex().replace(removed, added);
    for (std::size_t i = 0; i < added.size(); ++i) {
        quality_[change.added_tets[i]] = rate(added[i].vertices);
        for (const VertexId v : added[i].vertices) changed_[v] = time_;
        if (transaction_.is_open()) transaction_.note_new(change.added_tets[i]);
    }
    // Behind a curved wall a face inside may come to be one of the boundary, when a change is taken back.
    for (const TetId t : change.added_tets) {
        for (const FaceId f : complex().faces(t)) {
            if (!surface_.has_patch(complex(), f)) continue;
            const FaceVertices corners = complex().vertices(f);
            const auto known = std::find_if(surface.begin(), surface.end(), [&](const SurfaceFace& face) {
                return std::is_permutation(corners.begin(), corners.end(), face.vertices.begin());
            });
            if (known != surface.end()) surface_.set_patch(f, known->patch);
            DSC_ASSERT(surface_.patch(f) != FlatSurface::no_patch);
        }
    }
}

bool RatedMesh::move(VertexId v, const Point3& position, std::span<const TetId> star, double least) {
    const Point3 before = mesh_->position(v);
    mesh_->set_position(v, position);
    for (const TetId t : star) {
        const TetVertices& corners = complex().vertices(t);
        if (mesh_->is_positive(corners) && (std::isinf(least) || rate(corners) >= least)) continue;
        mesh_->set_position(v, before);
        return false;
    }
    ++time_;
    if (transaction_.is_open()) transaction_.note_move(v, before);
    for (const TetId t : star) {
        if (transaction_.is_open()) transaction_.note_change(t, quality_[t]);
        rate_again(t);
    }
    return true;
}

void RatedMesh::move_together(std::span<const VertexId> vertices, std::span<const Point3> positions,
                              std::span<const TetId> star, std::span<const double> qualities) {
    DSC_ASSERT(!transaction_.is_open());
    for (std::size_t i = 0; i < vertices.size(); ++i) mesh_->set_position(vertices[i], positions[i]);
    ++time_;
    for (std::size_t i = 0; i < star.size(); ++i) {
        DSC_ASSERT(mesh_->is_positive(complex().vertices(star[i])));
        quality_[star[i]] = qualities[i];
        for (const VertexId v : complex().vertices(star[i])) changed_[v] = time_;
    }
}

VertexId RatedMesh::split(EdgeId e, const Point3& position) {
    if (!can_split(*mesh_, e, position)) return {};
    EdgeRing ring;
    gather_ring(complex(), e, ring);
    const VertexId m = mesh_->complex().add_vertex();
    mesh_->set_position(m, position);
    Proposal parts{.removed = ring.tets};
    if (!ring.is_closed) add_boundary_parts(ring, m, parts);
    for (const TetId t : ring.tets) {
        for (const VertexId end : {ring.a, ring.b}) {
            NewTet part = {complex().vertices(t), complex().label(t)};
            part.vertices[static_cast<std::size_t>(complex().index_of(t, end))] = m;
            parts.added.push_back(part);
        }
    }
    [[maybe_unused]] const bool is_split = apply(parts);
    DSC_ASSERT(is_split);
    return m;
}

Point3 RatedMesh::middle(EdgeId e) const {
    const auto [a, b] = complex().vertices(e);
    const Point3 middle = 0.5 * (position(a) + position(b));
    if (!complex().is_boundary(e)) return middle;
    EdgeRing ring;
    gather_ring(complex(), e, ring);
    const auto [first, last] = boundary_patches(ring);
    return first == last ? surface_.on_patch(first, middle) : middle;
}

// Of the two boundary faces at the edge of an open ring.
std::array<std::int32_t, 2> RatedMesh::boundary_patches(const EdgeRing& ring) const {
    const auto patch = [&](TetId t, VertexId opposite) {
        const FaceId f = complex().faces(t)[static_cast<std::size_t>(complex().index_of(t, opposite))];
        return surface_.patch(f);
    };
    const std::size_t n = ring.tets.size();
    return {patch(ring.tets[0], ring.link[1]), patch(ring.tets[n - 1], ring.link[n - 1])};
}

// The boundary faces at the edge are divided too, and m moves as they allow.
void RatedMesh::add_boundary_parts(const EdgeRing& ring, VertexId m, Proposal& parts) {
    const auto [first, last] = boundary_patches(ring);
    const std::size_t n = ring.tets.size();
    for (const auto& [corner, of_face] : {std::pair(ring.link[0], first), std::pair(ring.link[n], last)})
        for (const VertexId end : {ring.a, ring.b}) parts.surface.push_back({{end, m, corner}, of_face});
    surface_.set_freedom(m,
                         surface_.freedom_between({position(ring.a), position(ring.b)},
                                                  {surface_.freedom(ring.a), surface_.freedom(ring.b)}, {first, last}));
}

void RatedMesh::set_label(TetId t, int label) {
    mesh_->complex().set_label(t, label);
    ++time_;
    for (const VertexId v : complex().vertices(t)) changed_[v] = time_;
}

void RatedMesh::rate_again(TetId t) {
    quality_[t] = rate(complex().vertices(t));
    for (const VertexId v : complex().vertices(t)) changed_[v] = time_;
}

void RatedMesh::roll_back() {
    Transaction& taken = transaction_;
    for (std::size_t i = taken.removed_vertices_.size(); i-- > 0;) {
        const Transaction::RemovedVertex& gone = taken.removed_vertices_[i];
        [[maybe_unused]] const VertexId v = mesh_->complex().add_vertex();
        DSC_ASSERT(v == gone.vertex);
        mesh_->set_position(gone.vertex, gone.position);
        surface_.set_freedom(gone.vertex, gone.freedom);
        longest_edge_[gone.vertex] = gone.longest_edge;
    }
    for (const auto& [v, position] : taken.moves_) mesh_->set_position(v, position);
    std::vector<TetId> added;
    ++time_;
    for (const TetId t : taken.touched()) {
        if (taken.is_added(t)) {
            added.push_back(t);
        } else {
            rate_again(t);
        }
    }
    taken.close();
    exchange(added, taken.originals_, taken.original_surface_);
}

}  // namespace dsc::dsc3d
