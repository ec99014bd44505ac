// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/flow.h"

#include <algorithm>
#include <cmath>

#include "core/errors.h"
#include "fluid/time_step.h"

namespace dsc::fluid {

template <int Dimension>
void FlowParameters<Dimension>::validate() const {
    fluid.validate();
    tensions.validate(fluid.phases.size());
    if (!(compensation >= 0 && compensation <= 1)) throw core::UsageError("compensation: has to be in [0, 1]");
    if (!(capillary_share > 0) || !std::isfinite(capillary_share))
        throw core::UsageError("capillary_share: has to be positive");
    if (!(gravity_share > 0 && gravity_share <= 1)) throw core::UsageError("gravity_share: has to be in (0, 1]");
    if (!(deformation_share > 0 && deformation_share < 1))
        throw core::UsageError("deformation_share: has to be in (0, 1)");
}

template <int Dimension>
Flow<Dimension>::Flow(const FlowParameters<Dimension>& parameters)
    : parameters_(parameters), solver_(parameters.fluid) {
    parameters.validate();
    for (const Phase& phase : parameters.fluid.phases) densities_.push_back(phase.density);
}

template <int Dimension>
FlowState<Dimension> Flow<Dimension>::at_rest(SimplexMesh<Dimension> mesh) const {
    FlowState<Dimension> state;
    const Elements<Dimension> elements(mesh);
    const auto facets = fluid::facets(mesh);
    state.velocities.assign(mesh.positions.size(), Vector<Dimension>::Zero());
    state.masses = lumped_masses(mesh, elements, densities());
    state.pressures.assign(mesh.cells.size(), 0.0);
    state.kept_volumes = parts<Dimension>(mesh, elements, facets).volumes;
    state.mesh = std::move(mesh);
    return state;
}

template <int Dimension>
double Flow<Dimension>::longest_step(const FlowState<Dimension>& state,
                                     std::span<const WallContact<Dimension>> contacts, double longest) const {
    const auto surface = surface_elements<Dimension>(state.mesh, facets(state.mesh), contacts, parameters_.tensions);
    const double lightest = *std::min_element(densities_.begin(), densities_.end());
    if (const auto limit = capillary_limit<Dimension>(state.mesh.positions, surface, lightest))
        longest = std::min(longest, parameters_.capillary_share * *limit);
    if (!contacts.empty())  // nothing that falls freely has waves of gravity
        if (const auto limit = gravity_limit<Dimension>(state.mesh, parameters_.fluid.gravity))
            longest = std::min(longest, parameters_.gravity_share * *limit);
    if (const auto limit = deformation_limit<Dimension>(state.mesh, state.velocities))
        longest = std::min(longest, parameters_.deformation_share * *limit);
    return longest;
}

template <int Dimension>
FlowReport Flow<Dimension>::update_velocities(FlowState<Dimension>& state,
                                              std::span<const WallContact<Dimension>> contacts, double dt) {
    const SimplexMesh<Dimension>& mesh = state.mesh;
    const Elements<Dimension> elements(mesh);
    const auto facets = fluid::facets(mesh);
    const auto surface = surface_elements<Dimension>(mesh, facets, contacts, parameters_.tensions);
    const Parts parts = fluid::parts<Dimension>(mesh, elements, facets);
    const std::vector<double> growth =
        compensating_growth(elements.volumes, parts, state.kept_volumes, parameters_.compensation, dt);
    FlowReport report;
    report.solve = solver_.advance({.mesh = mesh,
                                    .elements = elements,
                                    .facets = facets,
                                    .surface = surface,
                                    .contacts = contacts,
                                    .growth = growth,
                                    .dt = dt},
                                   state.masses, state.velocities, state.pressures);
    if (!report.solve.is_converged)
        throw core::RunError("the pressure could not be found: the residual stays at " +
                             std::to_string(report.solve.residual) + " after " +
                             std::to_string(report.solve.iterations) + " iterations");
    double fastest = 0;
    for (const auto& velocity : state.velocities) fastest = std::max(fastest, velocity.norm());
    for (std::size_t j = 0; j < mesh.cells.size() && fastest > 0; ++j) {
        double rate = 0;
        for (int i = 0; i <= Dimension; ++i)
            rate +=
                elements.volume_gradients[j].col(i).dot(state.velocities[mesh.cells[j][static_cast<std::size_t>(i)]]);
        const double size = std::pow(elements.volumes[j], 1.0 / Dimension);
        report.max_divergence =
            std::max(report.max_divergence, std::abs(rate) * size / (elements.volumes[j] * fastest));
    }
    return report;
}

template <int Dimension>
FlowReport Flow<Dimension>::step(FlowState<Dimension>& state, std::span<const WallContact<Dimension>> contacts,
                                 double dt) {
    const FlowReport report = update_velocities(state, contacts, dt);
    advect(state, dt);
    return report;
}

template <int Dimension>
FlowEnergies Flow<Dimension>::energies(const FlowState<Dimension>& state,
                                       std::span<const WallContact<Dimension>> contacts) const {
    const auto surface = surface_elements<Dimension>(state.mesh, facets(state.mesh), contacts, parameters_.tensions);
    return {.kinetic = kinetic_energy<Dimension>(state.masses, state.velocities),
            .surface = surface_energy<Dimension>(state.mesh.positions, surface),
            .potential = potential_energy<Dimension>(state.mesh.positions, state.masses, parameters_.fluid.gravity)};
}

template struct FlowParameters<2>;
template struct FlowParameters<3>;
template class Flow<2>;
template class Flow<3>;

}  // namespace dsc::fluid
