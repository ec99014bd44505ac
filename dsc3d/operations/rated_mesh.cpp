// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/rated_mesh.h"

#include <algorithm>
#include <limits>

namespace dsc::dsc3d {

RatedMesh::RatedMesh(Mesh& mesh, geometry::QualityMeasure measure, const FlatSurfaceParameters& parameters)
    : mesh_(&mesh),
      measure_(measure),
      surface_(mesh, parameters),
      quality_(mesh.complex().tet_attributes(), 0.0),
      changed_(mesh.complex().vertex_attributes(), 1u),
      walker_(mesh.complex()) {
    set_measure(measure);
}

void RatedMesh::set_measure(geometry::QualityMeasure measure) {
    measure_ = measure;
    for (std::uint32_t i = 0; i < complex().tet_capacity(); ++i)
        if (!complex().is_deleted(TetId(i))) quality_[TetId(i)] = rate(complex().vertices(TetId(i)));
}

double RatedMesh::worst_quality(std::span<const TetId> tets) const {
    double worst = std::numeric_limits<double>::infinity();
    for (const TetId t : tets) worst = std::min(worst, quality_[t]);
    return worst;
}

bool RatedMesh::apply(const Proposal& proposal) {
    for (const NewTet& tet : proposal.added)
        if (!mesh_->is_positive(tet.vertices)) return false;
    ++time_;
    for (const TetId t : proposal.removed)
        for (const VertexId v : complex().vertices(t)) changed_[v] = time_;
    const Complex::Change& change = mesh_->complex().replace(proposal.removed, proposal.added);
    for (std::size_t i = 0; i < proposal.added.size(); ++i) {
        quality_[change.added_tets[i]] = rate(proposal.added[i].vertices);
        for (const VertexId v : proposal.added[i].vertices) changed_[v] = time_;
    }
    for (const FaceId f : change.added_faces) {
        if (!complex().is_surface(f)) continue;
        const FaceVertices corners = complex().vertices(f);
        const auto known = std::find_if(proposal.surface.begin(), proposal.surface.end(), [&](const auto& face) {
            return std::is_permutation(corners.begin(), corners.end(), face.first.begin());
        });
        DSC_ASSERT(known != proposal.surface.end());
        surface_.set_patch(f, known->second);
    }
    return true;
}

bool RatedMesh::move(VertexId v, const Point3& position, std::span<const TetId> star) {
    const Point3 before = mesh_->position(v);
    mesh_->set_position(v, position);
    for (const TetId t : star) {
        if (mesh_->is_positive(complex().vertices(t))) continue;
        mesh_->set_position(v, before);
        return false;
    }
    ++time_;
    for (const TetId t : star) {
        quality_[t] = rate(complex().vertices(t));
        for (const VertexId u : complex().vertices(t)) changed_[u] = time_;
    }
    return true;
}

}  // namespace dsc::dsc3d
