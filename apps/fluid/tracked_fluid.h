// SPDX-License-Identifier: GPL-3.0-or-later
// A fluid whose surface is tracked by the deformable simplicial complex: a step of velocities (fluid/flow.h), then one
// of deformation (dsc3d/deform/deformer.h), then what mesh improvement has made or moved gets its velocity. Source:
// thesis 6.3, 6.4. Vertices that arrive where the flow carries them keep their velocity; all others have it from the
// advected mesh at their new place (fluid/interpolation.h). What this transfer and new masses change of the momentum
// and the angular momentum of a free body is given back as a rigid motion, the least change in energy that does so.
// Guarantee: after every step the complex is valid; a step that fails leaves the state before. The same bits for the
// same input. Cost: one solve, one deformation of the surface, and a linear rest.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "apps/fluid/container.h"
#include "core/attribute.h"
#include "dsc3d/deform/deformer.h"
#include "dsc3d/mesh.h"
#include "fluid/flow.h"

namespace dsc::fluid_app {

/// How fast wanted edges grow off the surface, per distance: the interior of the fluid has to be fine enough for its
/// flow.
inline constexpr double tracked_growth = 0.15;

/// Cells of label 1 are fluid, others void.
struct TrackedParameters {
    Container container;
    fluid::FlowParameters<3> flow = {};
    dsc3d::DeformParameters deform = {};
    bool conserves_momentum = true;  ///< gives back what the transfer changes
};

/// All that a step depends on; vertices in the order of the data.
struct TrackedState {
    geometry::TetData tets;
    std::vector<Point3> velocities;
    std::vector<double> pressures;     ///< means at the vertices: where the solver begins
    std::vector<std::int32_t> parts;   ///< fluid::no_part off the fluid
    std::vector<double> kept_volumes;  ///< of the parts
    std::vector<double> edge_lengths;  ///< wanted; empty at the start
};

struct TrackedReport {
    fluid::FlowReport flow;
    dsc3d::StepReport deform;
    std::size_t transferred = 0;  ///< vertices that got their velocity by interpolation
    std::vector<std::pair<std::string, double>> milliseconds;
};

class TrackedFluid {
public:
    /// Precondition: `state.tets` is a mesh of the container. Parts and volumes may be missing: then they are those of
    /// the mesh. The listener has to live as long.
    TrackedFluid(const TrackedState& state, const TrackedParameters& parameters, dsc3d::Listener& listener);

    const dsc3d::Mesh& mesh() const { return mesh_; }
    const fluid::FlowState<3>& fluid() const { return fluid_; }
    const std::vector<core::VertexId>& vertices() const { return vertices_; }  ///< of the fluid, in the mesh
    const fluid::Flow<3>& flow() const { return flow_; }
    /// Of vertices of the fluid with the walls they are on.
    std::vector<fluid::WallContact<3>> contacts() const;
    TrackedState state() const;

    double longest_step(double longest) const { return flow_.longest_step(fluid_, contacts(), longest); }

    /// Throws core::RunError before anything has moved, when velocities can't be found, or fluid would leave the
    /// container.
    TrackedReport step(double dt);

private:
    void extract();
    void add_arrivals(std::span<const Point3> velocities, double dt,
                      std::vector<fluid::WallContact<3>>& contacts) const;
    fluid::FlowReport update_velocities(double dt);
    std::size_t transfer(const fluid::SimplexMesh<3>& advected, const std::vector<Point3>& velocities);
    void give_back_momentum(const std::vector<fluid::Motion<3>>& before, const std::vector<std::int32_t>& body_before);

    TrackedParameters parameters_;
    dsc3d::Mesh mesh_;
    dsc3d::Deformer deformer_;
    fluid::Flow<3> flow_;
    core::Attribute<core::VertexId, Point3> velocity_;
    core::Attribute<core::VertexId, Point3> carried_to_;  ///< not finite for vertices that are not carried
    core::Attribute<core::VertexId, double> pressure_;
    core::Attribute<core::VertexId, std::int32_t> part_, body_;
    fluid::FlowState<3> fluid_;
    std::vector<core::VertexId> vertices_;
};

}  // namespace dsc::fluid_app
