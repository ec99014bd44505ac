// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/velocity_step.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"
#include "core/disjoint_sets.h"
#include "core/errors.h"
#include "fluid/stabilization.h"
#include "fluid/tensions.h"
#include "fluid/viscosity.h"

namespace dsc::fluid {

namespace {

using Matrix = Eigen::SparseMatrix<double>;

template <int Dimension>
Eigen::VectorXd flat(std::span<const Vector<Dimension>> vectors) {
    Eigen::VectorXd result(static_cast<Eigen::Index>(vectors.size()) * Dimension);
    for (std::size_t i = 0; i < vectors.size(); ++i)
        result.template segment<Dimension>(Dimension * static_cast<Eigen::Index>(i)) = vectors[i];
    return result;
}

// rho g . x in each cell of a body of fluid that a solid carries. One that touches none falls freely, without that
// pressure: its deviation from it would set the fluid in motion.
template <int Dimension>
Eigen::VectorXd hydrostatic_pressures(const VelocityStep<Dimension>& step, const Vector<Dimension>& gravity,
                                      std::span<const double> densities) {
    const SimplexMesh<Dimension>& mesh = step.mesh;
    core::DisjointSets bodies(mesh.cells.size());
    for (const auto& facet : step.facets)
        if (facet.opposite) bodies.unite(facet.cell, *facet.opposite);
    std::vector<char> touches(mesh.positions.size(), 0), is_carried(mesh.cells.size(), 0);
    for (const auto& contact : step.contacts) touches[contact.vertex] = 1;
    for (std::uint32_t j = 0; j < mesh.cells.size(); ++j)
        for (const std::uint32_t v : mesh.cells[j])
            if (touches[v] != 0) is_carried[bodies.find(j)] = 1;
    Eigen::VectorXd pressures = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.cells.size()));
    for (std::uint32_t j = 0; j < mesh.cells.size(); ++j)
        if (is_carried[bodies.find(j)] != 0)
            pressures[j] = densities[static_cast<std::size_t>(mesh.phases[j])] * gravity.dot(centroid(mesh, j));
    return pressures;
}

}  // namespace

template <int Dimension>
void FluidParameters<Dimension>::validate() const {
    if (phases.empty()) throw core::UsageError("phases: at least one is needed");
    for (const Phase& phase : phases) {
        if (!(phase.density > 0) || !std::isfinite(phase.density))
            throw core::UsageError("density: has to be positive");
        if (!(phase.viscosity >= 0) || !std::isfinite(phase.viscosity))
            throw core::UsageError("viscosity: can't be negative");
    }
    if (!gravity.allFinite()) throw core::UsageError("gravity: has to be finite");
    if (!(stabilization >= 0) || !std::isfinite(stabilization))
        throw core::UsageError("stabilization: can't be negative");
    solver.validate();
}

template <int Dimension>
VelocitySolver<Dimension>::VelocitySolver(const FluidParameters<Dimension>& parameters)
    : parameters_(parameters), solver_(parameters.solver) {
    parameters.validate();
    for (const Phase& phase : parameters.phases) {
        densities_.push_back(phase.density);
        viscosities_.push_back(phase.viscosity);
    }
}

// M + dt K + dt^2 H in the free coordinates; what it makes of the constrained ones goes into the force.
template <int Dimension>
EffectiveMass VelocitySolver<Dimension>::effective_mass(const VelocityStep<Dimension>& step,
                                                        const Eigen::VectorXd& masses,
                                                        const FreeCoordinates& coordinates,
                                                        Eigen::VectorXd& force) const {
    std::vector<Eigen::Triplet<double, int>> entries;
    add_viscosity_matrix(step.mesh, step.elements, viscosities_, step.dt, entries);
    if (parameters_.has_second_order_tension)
        add_surface_energy_hessian(step.mesh.positions, step.surface, HessianPart::positive, step.dt * step.dt,
                                   entries);
    Eigen::VectorXd diagonal(coordinates.basis.cols());
    for (Eigen::Index k = 0; k < diagonal.size(); ++k)
        diagonal[k] = masses[Dimension * coordinates.vertex[static_cast<std::size_t>(k)]];
    if (entries.empty()) return EffectiveMass(std::move(diagonal));
    for (Eigen::Index k = 0; k < masses.size(); ++k)
        entries.emplace_back(static_cast<int>(k), static_cast<int>(k), masses[k]);
    Matrix mass(masses.size(), masses.size());
    mass.setFromTriplets(entries.begin(), entries.end());
    force -= mass * coordinates.constrained;
    const Matrix free_mass = coordinates.basis.transpose() * mass * coordinates.basis;
    return {std::move(diagonal), free_mass};
}

template <int Dimension>
SolveReport VelocitySolver<Dimension>::advance(const VelocityStep<Dimension>& step, std::span<const double> masses,
                                               std::vector<Vector<Dimension>>& velocities,
                                               std::vector<double>& pressures) {
    const std::size_t vertices = step.mesh.positions.size(), cells = step.mesh.cells.size();
    DSC_ASSERT(step.dt > 0 && masses.size() == vertices && velocities.size() == vertices && pressures.size() == cells);
    Eigen::VectorXd mass(static_cast<Eigen::Index>(vertices) * Dimension);
    Eigen::VectorXd acceleration(mass.size());
    for (std::size_t i = 0; i < vertices; ++i) {
        const auto at = Dimension * static_cast<Eigen::Index>(i);
        mass.template segment<Dimension>(at).setConstant(masses[i]);
        acceleration.template segment<Dimension>(at) = parameters_.gravity;
        if (!step.accelerations.empty()) acceleration.template segment<Dimension>(at) += step.accelerations[i];
    }
    Eigen::VectorXd force = mass.cwiseProduct(flat<Dimension>(velocities) + step.dt * acceleration);
    force -= step.dt * surface_energy_gradient(step.mesh.positions, step.surface);

    const FreeCoordinates coordinates = free_coordinates(vertices, step.contacts);
    const EffectiveMass free_mass = effective_mass(step, mass, coordinates, force);
    const Eigen::VectorXd free_force = coordinates.basis.transpose() * force;
    const SparseRows divergence = divergence_matrix(step.mesh, step.elements);
    const SparseRows free_divergence = divergence * coordinates.basis;

    Eigen::VectorXd growth = -(divergence * coordinates.constrained);
    for (std::size_t j = 0; j < step.growth.size(); ++j) growth[static_cast<Eigen::Index>(j)] += step.growth[j];
    const Matrix stabilization = parameters_.stabilization * stabilization_matrix(step.mesh, step.facets, densities_);
    growth += step.dt * (stabilization * hydrostatic_pressures<Dimension>(step, parameters_.gravity, densities_));

    const Matrix laplacian =
        pressure_laplacian(step.mesh, step.facets, densities_, held_facets<Dimension>(step.facets, step.contacts));
    Eigen::VectorXd free_velocity;
    Eigen::VectorXd impulse = step.dt * Eigen::Map<const Eigen::VectorXd>(pressures.data(), growth.size());
    const SolveReport report = solver_.solve({free_divergence, free_mass, stabilization, laplacian, free_force, growth},
                                             free_velocity, impulse);
    if (!report.is_converged) return report;
    const Eigen::VectorXd velocity = coordinates.basis * free_velocity + coordinates.constrained;
    for (std::size_t i = 0; i < vertices; ++i)
        velocities[i] = velocity.template segment<Dimension>(Dimension * static_cast<Eigen::Index>(i));
    Eigen::Map<Eigen::VectorXd>(pressures.data(), growth.size()) = impulse / step.dt;
    return report;
}

template struct FluidParameters<2>;
template struct FluidParameters<3>;
template class VelocitySolver<2>;
template class VelocitySolver<3>;

}  // namespace dsc::fluid
