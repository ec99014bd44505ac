// SPDX-License-Identifier: GPL-3.0-or-later
// The complex while its interface is fitted: the operations of the engine that keep every tetrahedron positive, on one
// rated mesh. Source: thesis 4.3, algorithm 5 (motion), 4.3.2.1 (quality of what has moved). Guarantee: after every
// operation the complex is valid and its interface has the same topology. Cost: linear in the stars of what changes.
#pragma once

#include <span>
#include <vector>

#include "dsc3d/deform/advance.h"
#include "dsc3d/deform/pass_context.h"
#include "dsc3d/deform/upkeep.h"
#include "dsc3d/operations/edge_collapse.h"
#include "dsc3d/operations/edge_removal.h"

namespace dsc::reconstruct {

using dsc3d::EdgeId;
using dsc3d::Point3;
using dsc3d::VertexId;

struct WorkbenchParameters {
    double least_quality =
        0.03;                   ///< least sine of a dihedral angle that an operation leaves, or what there was; (0, 1)
    double poor_quality = 0.2;  ///< tetrahedra below this are improved after they have changed; (0, 1)
};

class Workbench {
public:
    Workbench(dsc3d::Mesh& mesh, double edge_length, const WorkbenchParameters& parameters);

    const dsc3d::Complex& complex() const { return mesh_.complex(); }
    const Point3& position(VertexId v) const { return mesh_.position(v); }
    std::vector<VertexId> interface_vertices() const;
    /// Edges between two triangles of the interface.
    std::vector<EdgeId> interface_edges() const;
    /// The neighbours of v on the interface, and its triangles there as outward pairs.
    void gather_ring(VertexId v, std::vector<std::array<VertexId, 2>>& triangles);
    /// The vertices opposite to e in its two interface triangles (a, b, first) and (b, a, second), seen from outside;
    /// false when e is no such edge.
    bool opposite(EdgeId e, std::array<VertexId, 2>& ends, std::array<VertexId, 2>& others);

    /// Moves vertices towards their targets, as far as the complex allows; how many arrived.
    std::size_t move(std::span<const VertexId> vertices, const core::Attribute<VertexId, Point3>& target);
    /// Invalid when the parts would not be positive.
    VertexId split(EdgeId e, const Point3& place);
    bool collapse(EdgeId e, VertexId kept, const Point3& place);
    bool flip(EdgeId e);
    /// Improves poor tetrahedra that have changed since the last time.
    void keep_up();

private:
    dsc3d::PassContext context() { return {rated_, parameters_, length_, way_, pull_, region_, listener_, report_}; }

    dsc3d::Mesh& mesh_;
    WorkbenchParameters own_;
    dsc3d::DeformParameters parameters_;
    dsc3d::RatedMesh rated_;
    dsc3d::LocalLength length_;
    dsc3d::Region region_;
    dsc3d::Listener listener_;
    dsc3d::StepReport report_;
    core::Attribute<VertexId, Point3> way_, pull_;  ///< none: there are no steps, and no walls
    dsc3d::Advance advance_;
    dsc3d::Upkeep upkeep_;
    dsc3d::EdgeCollapse collapse_;
    dsc3d::EdgeRemoval removal_;
    dsc3d::Proposal proposal_;
    dsc3d::EdgeRing ring_;
};

}  // namespace dsc::reconstruct
