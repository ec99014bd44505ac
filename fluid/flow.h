// SPDX-License-Identifier: GPL-3.0-or-later
// A fluid whose mesh moves with it: the state of a flow and its steps, as long as the mesh stays the same.
// Source: thesis 6.4, the steps of a fractional step method. Each vertex carries its velocity and its mass while it
// moves: that is the advection, and nothing of u . grad u is lost. Guarantee: with free boundaries linear and angular
// momentum change by rounding and the tolerance of the solver alone. Cost: one solve per step.
//
//     fluid::Flow<3> flow({.fluid = {}, .tensions = {.free_surface = {1}}});
//     fluid::FlowState<3> state = flow.at_rest(mesh);
//     for (int i = 0; i < 100; ++i) flow.step(state, {}, flow.longest_step(state, {}));
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "fluid/integrals.h"
#include "fluid/parts.h"
#include "fluid/tensions.h"
#include "fluid/velocity_step.h"

namespace dsc::fluid {

template <int Dimension>
struct FlowParameters {
    FluidParameters<Dimension> fluid = {};
    Tensions tensions = {};
    /// tau: the share of a part's missing volume that a step brings back. In [0, 1].
    double compensation = 0.5;
    /// The longest step, in the limits of time_step.h. > 0 (beyond 1, with tension to second order only), in (0, 1], in
    /// (0, 1).
    double capillary_share = 0.5;
    double gravity_share = 0.5;
    double deformation_share = 0.25;

    /// Throws core::UsageError that names the first field out of its range.
    void validate() const;
};

template <int Dimension>
struct FlowState {
    SimplexMesh<Dimension> mesh;
    std::vector<Vector<Dimension>> velocities;  ///< of the vertices
    std::vector<double> masses;                 ///< of the vertices
    std::vector<double> pressures;              ///< of the cells, in the last step
    std::vector<double> kept_volumes;           ///< of the parts (parts.h)
};

struct FlowReport {
    SolveReport solve;
    double max_divergence = 0;  ///< of a cell, max |D u| h / (V |u|), h its size
};

struct FlowEnergies {
    double kinetic = 0, surface = 0, potential = 0;
    double sum() const { return kinetic + surface + potential; }
};

template <int Dimension>
class Flow {
public:
    /// Throws core::UsageError for invalid parameters.
    explicit Flow(const FlowParameters<Dimension>& parameters);

    const FlowParameters<Dimension>& parameters() const { return parameters_; }
    std::span<const double> densities() const { return densities_; }

    /// Precondition: cells are positive, phases are those of the parameters.
    FlowState<Dimension> at_rest(SimplexMesh<Dimension> mesh) const;

    /// The largest step that the shares allow; `longest` when nothing limits it.
    double longest_step(const FlowState<Dimension>& state, std::span<const WallContact<Dimension>> contacts,
                        double longest = std::numeric_limits<double>::infinity()) const;

    /// The velocities and pressures at the end of a step. Throws core::RunError, with the state as it was, when a
    /// velocity is not finite or the solver does not converge.
    FlowReport update_velocities(FlowState<Dimension>& state, std::span<const WallContact<Dimension>> contacts,
                                 double dt);

    /// The same, and the vertices where they are then.
    FlowReport step(FlowState<Dimension>& state, std::span<const WallContact<Dimension>> contacts, double dt);

    FlowEnergies energies(const FlowState<Dimension>& state, std::span<const WallContact<Dimension>> contacts) const;

private:
    FlowParameters<Dimension> parameters_;
    std::vector<double> densities_;
    VelocitySolver<Dimension> solver_;
};

/// Moves the vertices of the mesh with their velocities.
template <int Dimension>
void advect(FlowState<Dimension>& state, double dt) {
    for (std::size_t i = 0; i < state.velocities.size(); ++i) state.mesh.positions[i] += dt * state.velocities[i];
}

}  // namespace dsc::fluid
