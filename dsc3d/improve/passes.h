// SPDX-License-Identifier: GPL-3.0-or-later
// The three passes of mesh improvement: smoothing, topological pass (algorithm 2), thinning pass (algorithm 3).
// Source: thesis 3.4. Guarantee: an operation is done only if it makes the worst tetrahedron it touches better
// (thinning: or leaves it above `enough` and above the worst one of the mesh). A pass looks only at what has changed
// since the same attempt failed there.
#pragma once

#include "core/attribute.h"
#include "dsc3d/improve/stop.h"
#include "dsc3d/operations/edge_collapse.h"
#include "dsc3d/operations/edge_removal.h"
#include "dsc3d/operations/multi_face.h"
#include "dsc3d/operations/rated_mesh.h"
#include "dsc3d/operations/smoothing.h"

namespace dsc::dsc3d {

struct PassParameters {
    bool uses_multi_face_retriangulation = true;
    bool removes_surface_vertices = false;  ///< thinning collapses edges of the surface too, where it is flat
    /// Thinning: quality below which a collapse has to be an improvement; the worst of the mesh, where that is better.
    double enough = 0.5;
    SmoothingParameters smoothing = {};
};

struct PassCounts {
    std::size_t smoothings = 0;
    std::size_t edge_removals = 0;
    std::size_t multi_face_removals = 0;
    std::size_t multi_face_retriangulations = 0;
    std::size_t collapses = 0;
};

class Passes {
public:
    /// A pass ends early when `stop`, if there is one, is due.
    Passes(RatedMesh& mesh, const PassParameters& parameters, const StopCondition* stop = nullptr);

    void smooth_all_vertices();
    void topological_pass();
    void thinning_pass();

    /// Algorithm 2, for one tetrahedron; true when it is gone.
    bool remove_tet(TetId t);
    bool remove_edge(EdgeId e);
    bool remove_face(FaceId f);
    /// Algorithm 3, for one edge; true when it is gone.
    bool collapse_edge(EdgeId e);
    bool smooth(VertexId v);

    const PassCounts& counts() const { return counts_; }
    /// After changes were taken back.
    void set_counts(const PassCounts& counts) { counts_ = counts; }

private:
    bool collapse_edge(EdgeId e, VertexId kept);
    /// Asked once per simplex; the clock is looked at now and then.
    bool is_stopped(std::uint32_t i) const { return stop_ != nullptr && i % 256 == 0 && stop_->is_due(); }

    RatedMesh& mesh_;
    PassParameters parameters_;
    const StopCondition* stop_;
    double enough_;  ///< not below the worst quality that the mesh had when thinning began
    EdgeRemoval edge_removal_;
    MultiFace multi_face_;
    EdgeCollapse collapse_;
    Smoothing smoothing_;
    Proposal proposal_;
    PassCounts counts_;
    core::Attribute<VertexId, std::uint32_t> smoothed_;
    core::Attribute<EdgeId, std::uint32_t> removal_tried_;
    core::Attribute<FaceId, std::uint32_t> face_tried_;
    core::Attribute<EdgeId, std::uint32_t> collapse_tried_;
};

}  // namespace dsc::dsc3d
