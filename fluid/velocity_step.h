// SPDX-License-Identifier: GPL-3.0-or-later
// The new velocities of one time step: gravity, surface tension, viscosity, walls and incompressibility as one
// quadratic program. Source: thesis 6.4.2 to 6.4.4, equations (6.7) to (6.11).
//
//     minimize    (u - u~)^T M (u - u~) / 2 + dt u^T K u / 2 + U(x + u dt)
//     subject to  D u + S (p - p_h) = c,     u . n = u_solid . n
//
// with u~ the carried velocities and gravity, K the viscosity, U the energy of the surface to first or second order in
// dt, S the stabilization, p_h = rho g . x the hydrostatic pressure where a solid carries the fluid (a drop in free
// fall has none), and c the growth that is wanted. Guarantee: forces of pressure and tension change neither linear nor
// angular momentum; what S lets through does not change the volume of the fluid. Cost: one solve (saddle_point.h); what
// it assembles is linear.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fluid/facets.h"
#include "fluid/free_coordinates.h"
#include "fluid/saddle_point.h"
#include "fluid/surface_energy.h"

namespace dsc::fluid {

struct Phase {
    double density = 1;    ///< > 0
    double viscosity = 0;  ///< dynamic; >= 0
};

template <int Dimension>
struct FluidParameters {
    std::vector<Phase> phases = {Phase{}};  ///< by the number that cells have
    Vector<Dimension> gravity = Vector<Dimension>::Zero();
    /// beta of S. >= 0; 0 lets the elements lock.
    double stabilization = 0.1;
    /// The energy of the surface with its second derivative: for steps beyond the capillary limit.
    bool has_second_order_tension = false;
    SolverParameters solver = {};

    /// Throws core::UsageError that names the first field out of its range.
    void validate() const;
};

/// What a step is about; the spans have to live as long.
template <int Dimension>
struct VelocityStep {
    const SimplexMesh<Dimension>& mesh;
    const Elements<Dimension>& elements;
    std::span<const Facet<Dimension>> facets;
    std::span<const SurfaceElement<Dimension>> surface = {};
    std::span<const WallContact<Dimension>> contacts = {};
    std::span<const double> growth = {};                    ///< of each cell [volume / time]; empty: none
    std::span<const Vector<Dimension>> accelerations = {};  ///< of each vertex, beside gravity; empty: none
    double dt = 0;                                          ///< > 0
};

template <int Dimension>
class VelocitySolver {
public:
    /// Throws core::UsageError for invalid parameters.
    explicit VelocitySolver(const FluidParameters<Dimension>& parameters);

    const FluidParameters<Dimension>& parameters() const { return parameters_; }

    /// Velocities at the vertices before and after; pressures of the cells: a guess, and the answer. When the report
    /// says that it did not converge, both are as they were. `masses` are those of the vertices, > 0.
    SolveReport advance(const VelocityStep<Dimension>& step, std::span<const double> masses,
                        std::vector<Vector<Dimension>>& velocities, std::vector<double>& pressures);

private:
    EffectiveMass effective_mass(const VelocityStep<Dimension>& step, const Eigen::VectorXd& masses,
                                 const FreeCoordinates& coordinates, Eigen::VectorXd& force) const;

    FluidParameters<Dimension> parameters_;
    std::vector<double> densities_, viscosities_;
    SaddlePointSolver solver_;
};

}  // namespace dsc::fluid
