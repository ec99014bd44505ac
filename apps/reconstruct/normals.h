// SPDX-License-Identifier: GPL-3.0-or-later
// Normals of a cloud, up to their sign, that don't mix the two sides of a sharp edge, and the noise.
// Source: planes by least squares (Hoppe et al. 1992); at edges each point takes the plane, among those of its
// neighbours, that fits best and on which it lies (the filter of Kuwahara et al. 1976), and planes are fitted again to
// those neighbours only that agree (bilateral: Tomasi, Manduchi 1998). Guarantee: unit vectors; the same bits on any
// number of threads. Cost: some 20 us per point.
#pragma once

#include <optional>

#include "apps/reconstruct/cloud.h"

namespace dsc::reconstruct {

struct NormalParameters {
    double agreement = 30;  ///< planes of neighbours bent by more belong to different sides [degree]; (0, 90)
    int rounds = 3;         ///< of fitting again; >= 0

    /// Throws core::UsageError naming the field.
    void validate() const;
};

struct CloudNormals {
    std::vector<Vector3> axes;  ///< unit, of either sign
    double noise = 0;           ///< standard deviation off the surface, in the cloud's scaled unit
};

/// `noise`, when it is known, takes the place of the estimate.
CloudNormals cloud_normals(const Cloud& cloud, const NormalParameters& parameters,
                           std::optional<double> noise = std::nullopt);

}  // namespace dsc::reconstruct
