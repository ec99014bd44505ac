// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/fluid/step_record.h"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "dsc3d/improve/angle_range.h"

namespace dsc::fluid_app {

StepRecord step_record(const TrackedFluid& fluid, int step, double time) {
    const fluid::FlowState<3>& state = fluid.fluid();
    StepRecord record{.step = step, .time = time};
    record.vertices = state.mesh.positions.size();
    record.cells = state.mesh.cells.size();
    record.tets = fluid.mesh().complex().tet_count();
    const auto facets = fluid::facets(state.mesh);
    const fluid::Parts parts = fluid::parts<3>(state.mesh, fluid::Elements<3>(state.mesh), facets);
    record.surface_faces = static_cast<std::size_t>(
        std::count_if(facets.begin(), facets.end(), [](const auto& facet) { return !facet.opposite; }));
    std::vector<std::size_t> order(parts.volumes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return parts.volumes[a] > parts.volumes[b]; });
    for (const std::size_t part : order) {
        record.volumes.push_back(parts.volumes[part]);
        record.kept_volumes.push_back(state.kept_volumes[part]);
    }
    const auto motion = fluid::motion_of<3>(state.mesh.positions, state.masses, state.velocities);
    record.centre = motion.centre;
    record.momentum = motion.momentum;
    record.angular_momentum = motion.angular_momentum;
    const fluid::FlowEnergies energies = fluid.flow().energies(state, fluid.contacts());
    record.kinetic_energy = energies.kinetic;
    record.surface_energy = energies.surface;
    record.potential_energy = energies.potential;
    for (const Point3& velocity : state.velocities) record.max_speed = std::max(record.max_speed, velocity.norm());
    record.min_dihedral = dsc3d::AngleRange(fluid.mesh()).min * 180 / std::numbers::pi;
    return record;
}

}  // namespace dsc::fluid_app
