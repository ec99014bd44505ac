// SPDX-License-Identifier: GPL-3.0-or-later
// The 2D deformation step: moves vertices to their targets through valid complexes only.
// Source: thesis 4.3.1, algorithms 4 and 5; 5.2.2 (preserved topology). Guarantee: after a step, and between its
// passes, every face is strictly counterclockwise by exact predicate; motion that was not made is reported. Same input,
// same bits. Cost: linear in the vertices that move and their rings, not in the complex; no allocation in inner loops.
//
//     Deformer deformer(complex, {.edge_length = 0.05});
//     std::vector<std::optional<Point2>> targets(complex.vertex_capacity());
//     for (core::VertexId v : front) targets[v.index()] = complex.position(v) + velocity(v) * dt;
//     StepReport report = deformer.step(targets);
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "dsc2d/complex.h"
#include "dsc2d/deform/listener.h"
#include "dsc2d/deform/parameters.h"
#include "dsc2d/deform/pass_context.h"
#include "dsc2d/improve/delaunay.h"
#include "dsc2d/operations/move_together.h"

namespace dsc::dsc2d {

class Deformer {
public:
    /// Throws core::UsageError for invalid parameters. The complex and the listener must outlive the deformer.
    Deformer(Complex& complex, const Parameters& parameters, Listener& listener);
    Deformer(Complex& complex, const Parameters& parameters);

    const Parameters& parameters() const { return parameters_; }

    /// Moves every vertex that has a target (cover coordinates; indexed by vertex, missing entries mean none) towards
    /// it. Locked vertices stay and are reported as unfinished. Vertices that split the interface during the step get
    /// the mean of the motion left at the two ends. Throws core::UsageError when a vertex of the domain's boundary or a
    /// deleted vertex has a target, or a target lies out of the domain's reach.
    StepReport step(std::span<const std::optional<Point2>> targets);

    /// Halves an interface edge between steps (refinement of a front): the mesh is kept up, the listener is not called.
    /// Nothing when the edge is too short for the grid.
    std::optional<VertexId> split_interface_edge(HalfedgeId h, double s = 0.5);

    /// Merges from(h) into to(h) between steps, where the interface has no other branch (coarsening of a front): the
    /// mesh is kept up, the listener is not called. False when that would turn a face over or change the topology.
    bool merge_interface_edge(HalfedgeId h);

    /// Mesh improvement of the whole complex: Delaunay flips, smoothing, detail control. Moves no interface vertex.
    StepReport improve_everywhere();

private:
    class TargetKeeper;

    void set_targets(std::span<const std::optional<Point2>> targets);
    bool move_vertices_step(PassContext& context);
    bool move_one(PassContext& context, VertexId v);
    bool flip_out_of_the_way(PassContext& context, VertexId v, HalfedgeId blocking);
    void activate_star(PassContext& context, VertexId v);
    void improve(PassContext& context);
    void finish(PassContext& context);
    void flip(PassContext& context);
    void restore_delaunay_at(VertexId v);
    void report_unfinished(StepReport& report);
    void forget_handles();

    Complex& complex_;
    Parameters parameters_;
    Listener& listener_;
    DelaunayPass delaunay_;
    MoveTogether move_together_;
    ActiveSet active_;       // of the substep
    ActiveSet step_active_;  // of the step
    core::Attribute<VertexId, Point2> target_;
    core::Attribute<VertexId, std::uint8_t> has_target_;
    core::Attribute<VertexId, std::uint8_t> blocked_substeps_;
    std::vector<VertexId> moving_;  // have a target they have not reached
    std::vector<VertexId> touched_;
};

}  // namespace dsc::dsc2d
