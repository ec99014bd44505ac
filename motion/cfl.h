// SPDX-License-Identifier: GPL-3.0-or-later
// The longest step in which no vertex moves by more than a share of its edge length. Source: thesis 4.3.1 (steps in
// units of the edge length). Cost: linear.
//
//     const double dt = motion::cfl_step<3>(velocities, lengths, 0.5, until - t);
#pragma once

#include <span>

#include "core/assert.h"
#include "motion/velocity.h"

namespace dsc::motion {

/// The largest dt <= longest with |velocities[i]| dt <= share * lengths[i] for every i. Preconditions: as many lengths
/// as velocities, or one for all of them; velocities are finite.
template <int Dimension>
double cfl_step(std::span<const Vector<Dimension>> velocities, std::span<const double> lengths, double share,
                double longest) {
    DSC_ASSERT(lengths.size() == velocities.size() || lengths.size() == 1);
    double dt = longest;
    for (std::size_t i = 0; i < velocities.size(); ++i) {
        const double limit = share * (lengths.size() == 1 ? lengths[0] : lengths[i]);
        const double speed = velocities[i].norm();
        DSC_ASSERT(speed - speed == 0);
        if (speed * dt > limit) dt = limit / speed;
    }
    return dt;
}

}  // namespace dsc::motion
