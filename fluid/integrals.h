// SPDX-License-Identifier: GPL-3.0-or-later
// What a fluid has in all: momentum, angular momentum and energy, with the masses of the vertices.
// Cost: linear.
#pragma once

#include <span>
#include <vector>

#include "fluid/simplex_mesh.h"

namespace dsc::fluid {

/// Angular momentum and what belongs to it: a vector in space, a number in the plane.
template <int Dimension>
using Rotation = Eigen::Matrix<double, Dimension == 3 ? 3 : 1, 1>;

/// arm x vector.
template <int Dimension>
Rotation<Dimension> moment(const Vector<Dimension>& arm, const Vector<Dimension>& vector);

/// The velocity at `arm` of a rotation about the origin.
template <int Dimension>
Vector<Dimension> rotational_velocity(const Rotation<Dimension>& rotation, const Vector<Dimension>& arm);

/// Of some vertices of a fluid.
template <int Dimension>
struct Motion {
    double mass = 0;
    Vector<Dimension> centre = Vector<Dimension>::Zero();  ///< of mass
    Vector<Dimension> momentum = Vector<Dimension>::Zero();
    Rotation<Dimension> angular_momentum = Rotation<Dimension>::Zero();  ///< about the origin
};

template <int Dimension>
Motion<Dimension> motion_of(std::span<const Vector<Dimension>> positions, std::span<const double> masses,
                            std::span<const Vector<Dimension>> velocities);

template <int Dimension>
double kinetic_energy(std::span<const double> masses, std::span<const Vector<Dimension>> velocities);

/// Zero at the origin.
template <int Dimension>
double potential_energy(std::span<const Vector<Dimension>> positions, std::span<const double> masses,
                        const Vector<Dimension>& gravity);

/// The rigid motion that, added to the velocities, gives these vertices the momentum and angular momentum of `wanted`.
/// Of all changes that do so it is the one of least kinetic energy. Where the vertices are too few or on a line, what
/// has no inertia is left as it is.
template <int Dimension>
void correct_motion(std::span<const Vector<Dimension>> positions, std::span<const double> masses,
                    const Motion<Dimension>& wanted, std::span<Vector<Dimension>> velocities);

}  // namespace dsc::fluid
