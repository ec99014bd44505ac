// SPDX-License-Identifier: GPL-3.0-or-later
// The velocity fields that interface trackers are compared by. All of them are free of divergence.
// Sources: LeVeque (1996), "High-resolution conservative algorithms for advection in incompressible flow"; Enright,
// Fedkiw, Ferziger, Mitchell (2002), "A hybrid particle level set method for improved interface capturing".
// Guarantee: with a period T the velocity is multiplied by cos(pi t / T): everything is back where it was at time T.
// In the unit box, no flow crosses its walls. Cost: a few sines.
#pragma once

#include <optional>

#include "motion/velocity.h"

namespace dsc::motion {

/// LeVeque's deformation of the unit cube, by which Enright et al. stretch a ball of radius 0.15 at (.35, .35, .35) to
/// a thin sheet and back:
///   (2 sin^2(pi x) sin(2 pi y) sin(2 pi z), -sin(2 pi x) sin^2(pi y) sin(2 pi z), -sin(2 pi x) sin(2 pi y) sin^2(pi
///   z)).
/// Throws core::UsageError for a period that is not positive, as do the others.
VelocityField<3> enright_deformation(std::optional<double> period);

/// The single vortex in the unit square: the stream function sin^2(pi x) sin^2(pi y) / pi, counterclockwise.
VelocityField<2> vortex_in_square(std::optional<double> period);
/// The same in every plane of constant z.
VelocityField<3> vortex_in_cube(std::optional<double> period);

template <int Dimension>
VelocityField<Dimension> translation_field(const Vector<Dimension>& velocity) {
    return [velocity](const Vector<Dimension>&, double) { return velocity; };
}

/// Velocity `direction` times (gradient · (x - about)), with `direction` perpendicular to `gradient`. Throws
/// core::UsageError otherwise.
VelocityField<2> shear_field(const Vector<2>& direction, const Vector<2>& gradient,
                             const Vector<2>& about = Vector<2>::Zero());
VelocityField<3> shear_field(const Vector<3>& direction, const Vector<3>& gradient,
                             const Vector<3>& about = Vector<3>::Zero());

}  // namespace dsc::motion
