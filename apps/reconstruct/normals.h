// SPDX-License-Identifier: GPL-3.0-or-later
// Normals of a cloud, up to their sign, that don't mix the two sides of a sharp edge, and the noise.
// Source: planes by least squares (Hoppe et al. 1992); at edges each point takes the plane, among those of its
// neighbours, that fits best and on which it lies (the filter of Kuwahara et al. 1976), and planes are fitted again to
// those neighbours only that agree (bilateral: Tomasi, Manduchi 1998). Guarantee: unit vectors; the same bits on any
// number of threads. Cost: some 20 us per point.
#pragma once

#include "apps/reconstruct/cloud.h"

namespace dsc::reconstruct {

struct NormalParameters {
    double agreement = 30;           ///< planes of neighbours bent by more belong to different sides [degree]; (0, 90)
    int plane_points = 9;            ///< neighbours that make a plane where there is no noise; >= 4
    double noticeable_noise = 0.05;  ///< from here on planes are made of all neighbours [spacing]; >= 0
    int rounds = 3;                  ///< of fitting again; >= 0

    /// Throws core::UsageError naming the field.
    void validate() const;
};

/// Standard deviation of the points off the surface, in the cloud's scaled unit. On a clean surface the deviation from
/// planes grows with the square of their reach, that is, with the number of neighbours; what noise adds does not.
double estimated_noise(const Cloud& cloud);

/// Unit vectors of either sign.
std::vector<Vector3> cloud_axes(const Cloud& cloud, double noise, const NormalParameters& parameters);

}  // namespace dsc::reconstruct
