// SPDX-License-Identifier: GPL-3.0-or-later
// Points of a noisy cloud taken to the surface, each along its normal to the patch of least squares of the points on
// its side of creases, which is as wide as the shape of the surface allows: wide where it is flat, narrow where it
// isn't. Source: Goldenshluger, Nemirovski (1997), "On spatially adaptive estimation of nonparametric regression", the
// intersection of confidence intervals: patches widen for as long as one height agrees with all narrower ones to within
// their standard errors. Guarantee: a point moves along its normal only; the same bits on any number of threads. Cost:
// some 0.2 ms per point and round.
#pragma once

#include "apps/reconstruct/cloud.h"

namespace dsc::reconstruct {

struct DenoisingParameters {
    double noticeable_noise = 0.1;  ///< less is left as it is [spacing]; >= 0
    int least_points = 24;          ///< of the narrowest patch; >= 9
    int most_points = 400;          ///< of the widest one; >= least_points
    double growth = 1.6;            ///< of the number of points from one patch to the next; > 1
    double confidence = 1;          ///< half of an interval [standard errors]; > 0
    double side_angle = 35;         ///< normals of one side differ by less [degree]; (0, 90)
    int rounds = 2;                 ///< each with the normals of the one before; >= 0
    double share_left = 0.3;        ///< of the noise, about, afterwards; in [0, 1)

    /// Throws core::UsageError naming the field.
    void validate() const;
};

/// Moves the points and turns the unit normals; the noise that is left. `noise`: standard deviation of the points off
/// the surface.
double denoise(Cloud& cloud, std::vector<Vector3>& normals, double noise, const DenoisingParameters& parameters);

}  // namespace dsc::reconstruct
