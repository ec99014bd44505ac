// SPDX-License-Identifier: GPL-3.0-or-later
// The 3D deformation step: moves vertices of the interface to their targets through valid complexes only.
// Source: thesis 4.3, algorithms 4 and 5; 4.3.2.1. Guarantee: after every single operation all tetrahedra are positive
// by exact predicate; the outer boundary stays; labels, and with them the topology of every region, stay: parts of the
// interface that meet are stopped, and the motion that was not made is reported. Interface vertices are moved by their
// motion alone, and the interface keeps its triangles. Same input, same bits. Cost: linear in the stars of what moves.
//
//     dsc3d::Deformer deformer(mesh, {.edge_length = 0.05});
//     std::vector<std::optional<Point3>> targets(mesh.complex().vertex_capacity());
//     for (VertexId v : interface) targets[v.index()] = mesh.position(v) + velocity(v) * dt;
//     dsc3d::StepReport report = deformer.step(targets);
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/attribute.h"
#include "dsc3d/deform/parameters.h"
#include "dsc3d/improve/passes.h"
#include "motion/step_report.h"

namespace dsc::dsc3d {

using StepReport = motion::StepReport<3>;

class Deformer {
public:
    /// Throws core::UsageError for invalid parameters. The mesh must outlive the deformer.
    Deformer(Mesh& mesh, const DeformParameters& parameters);

    const DeformParameters& parameters() const { return parameters_; }

    /// Moves every vertex that has a target (indexed by vertex, missing entries mean none) towards it. Throws
    /// core::UsageError when a vertex on the boundary, a deleted one or one off the interface has a target, or a target
    /// is not finite.
    StepReport step(std::span<const std::optional<Point3>> targets);

    /// Mesh improvement of the whole complex; moves no vertex of the interface.
    StepReport improve_everywhere();

private:
    void set_targets(std::span<const std::optional<Point3>> targets);
    bool move_vertices_step(StepReport& report);
    bool move_one(VertexId v, StepReport& report);
    double share_to_link(std::span<const TetId> star, VertexId v, const Point3& target) const;

    void improve(StepReport& report);
    void gather_region();
    std::vector<EdgeId> inner_edges() const;
    void raise_quality(StepReport& report);
    void remove_degeneracies(StepReport& report);
    bool remove_degenerate(TetId t);
    void collapse_short_edges(StepReport& report);
    void split_bridges(StepReport& report);
    void report_unfinished(StepReport& report);

    Mesh& mesh_;
    DeformParameters parameters_;
    RatedMesh rated_;
    Passes passes_;
    EdgeCollapse collapse_;
    Proposal proposal_;
    core::Attribute<VertexId, Point3> target_;
    std::vector<VertexId> moving_;    ///< have a target they have not reached
    std::vector<VertexId> active_;    ///< have moved in this substep
    std::vector<TetId> tets_;         ///< the region of a substep: tetrahedra at active vertices,
    std::vector<VertexId> vertices_;  ///< and their vertices
};

}  // namespace dsc::dsc3d
