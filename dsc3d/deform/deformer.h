// SPDX-License-Identifier: GPL-3.0-or-later
// The 3D deformation step: moves vertices of the interface to their targets through valid complexes only.
// Source: thesis 4.3, algorithms 4 and 5; 4.3.2. Guarantee: after every single operation all tetrahedra are positive by
// exact predicate; the outer boundary keeps its shape; motion that was not made is reported. Where parts of the
// interface meet, they merge, split or are stopped, as the topology policy says; the walls of the domain are met,
// followed and left by the same rules. Same input, same bits. Cost: linear in the stars of what moves, not in the mesh.
//
//     dsc3d::Deformer deformer(mesh, {.edge_length = 0.05});
//     std::vector<std::optional<Point3>> targets(mesh.complex().vertex_capacity());
//     for (VertexId v : interface) targets[v.index()] = mesh.position(v) + velocity(v) * dt;
//     dsc3d::StepReport report = deformer.step(targets);
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/attribute.h"
#include "dsc3d/deform/advance.h"
#include "dsc3d/deform/contact_line.h"
#include "dsc3d/deform/contacts.h"
#include "dsc3d/deform/detail.h"
#include "dsc3d/deform/interface_control.h"
#include "dsc3d/deform/rim_control.h"
#include "dsc3d/deform/upkeep.h"

namespace dsc::dsc3d {

class Deformer {
public:
    /// Where a vertex that started at `start` is at a share of the step, from 0 to 1.
    using Path = std::function<Point3(const Point3& start, double share)>;

    /// `walls`: the curved ones among the sides of the domain; flat ones are found. Throws core::UsageError for invalid
    /// parameters. The mesh and the listener must outlive the deformer.
    Deformer(Mesh& mesh, const DeformParameters& parameters, Listener& listener, Walls walls = {});
    Deformer(Mesh& mesh, const DeformParameters& parameters);

    const DeformParameters& parameters() const { return parameters_; }

    /// The wanted edge length at vertices of the interface, instead of the same one everywhere; missing ones stay as
    /// they are. Throws core::UsageError for a length that is not positive.
    void set_edge_lengths(std::span<const std::optional<double>> lengths);
    /// The wanted edge lengths of all vertices, on the interface and off it, in the order of Mesh::data().
    std::vector<double> edge_lengths() const;
    /// The same lengths in a mesh made again from its data.
    void restore_edge_lengths(std::span<const double> lengths);

    /// Moves every vertex that has a target (indexed by vertex, missing entries mean none) straight to it; one on the
    /// boundary goes along it, to the place nearest to its target and as far beyond as its sheets take it there
    /// (contact_line.h), and is reported as held where that is its own place.
    /// Throws core::UsageError when a deleted vertex or one off the interface has a target, or a target is not finite,
    /// and core::RunError when a way would take too many substeps; nothing has moved then.
    StepReport step(std::span<const std::optional<Point3>> targets);
    /// ... along a path, which ends at the targets: substeps follow it, so that a turning body is never squeezed.
    StepReport step(std::span<const std::optional<Point3>> targets, const Path& path);

    /// Improvement of the whole complex and interface where they need it.
    StepReport improve_everywhere();
    /// Collapses edges off the interface that are shorter than wanted, all over the mesh: steps do so only where
    /// something moves, and would work their way through a mesh that is too fine one ring after another.
    /// Cost: some 15 microseconds per tetrahedron.
    StepReport coarsen_everywhere();

private:
    void take_whole_mesh();
    void set_targets(std::span<const std::optional<Point3>> targets);
    Point3 at_wall(VertexId v, const Point3& target) const { return rated_.on_boundary(v, target); }
    Point3 wanted_place(VertexId v, double share, const Path& path) const;
    double followed_share(double share, double end, const Path& path);
    Eigen::Vector3d way_off_wall(VertexId v, double share, const Path& path) const;
    void aim_at_wall(VertexId v, double share, const Path& path);
    int wanted_substeps(const Path& path) const;
    void aim(double share, const Path& path);
    double way_left() const;
    double length_of_way(VertexId v, const Path& path) const;
    void take_substep(PassContext& context, int substep, int wanted);
    void wait_for_late_ones(PassContext& context, int substep, int wanted);
    void release_resting_ones(const Path& path);
    void release(VertexId v);
    void move_vertices_step(StepReport& report);

    PassContext context(StepReport& report);
    void maintain(PassContext& context);
    void finish(PassContext& context);
    void treat_contacts(PassContext& context, int substep, double distance);
    void open_leftovers(PassContext& context);
    void end_motion_at_contacts(PassContext& context);
    void report_unfinished(PassContext& context);
    bool is_held(PassContext& context, VertexId v);

    Mesh& mesh_;
    DeformParameters parameters_;
    Listener& listener_;
    RatedMesh rated_;
    LocalLength wanted_length_;
    Region region_;
    Advance advance_;
    DetailControl detail_;
    Upkeep upkeep_;
    Contacts contacts_;
    InterfaceControl interface_control_;
    RimControl rim_control_;
    InterfaceRing ring_;
    core::Attribute<VertexId, Point3> start_;
    core::Attribute<VertexId, Point3> goal_;
    core::Attribute<VertexId, Point3> wanted_;  ///< the goal of a vertex on a wall, which need not lie on it
    core::Attribute<VertexId, Point3> slip_;    ///< along its wall so far, because of what leads off the wall
    core::Attribute<VertexId, Point3> off_;     ///< from its wall, of where it was wanted last
    core::Attribute<VertexId, Point3> pull_;    ///< ... and how far that has got in this substep
    core::Attribute<VertexId, Point3> target_;  ///< of the substep
    core::Attribute<VertexId, Point3> way_;     ///< to it, from where the vertex was at the start of the substep
    core::Attribute<VertexId, std::uint8_t> is_moving_;
    std::vector<VertexId> moving_;                           ///< have a goal they have not reached
    std::vector<std::pair<VertexId, Point3>> held_at_wall_;  ///< with their targets, which lie off the wall
    std::vector<VertexId> stopped_;                          ///< by a contact
};

}  // namespace dsc::dsc3d
