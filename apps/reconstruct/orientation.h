// SPDX-License-Identifier: GPL-3.0-or-later
// Which way normals point: outwards, everywhere on the cloud at once, so that the winding number of the oriented points
// is 1/2 at all of them and falls along each normal. That tells a narrow slot, which has two sides, from a hole in the
// sampling, which has none.
// Source: Lin, Shi, Liu (2024), "Fast and globally consistent normal orientation based on the winding number normal
// consistency": steps of steepest descent for the winding number, each followed by turning the moments to its gradient;
// on a thinned cloud, because only signs are needed; the axes are those of normals.h. Guarantee: unit vectors along the
// axes; the same bits on any number of threads. Cost: some 5 s for 30,000 points kept, and little for the others.
#pragma once

#include "apps/reconstruct/cloud.h"
#include "core/observer.h"

namespace dsc::reconstruct {

struct OrientationParameters {
    std::size_t most_points = 30000;  ///< that are oriented from nothing; the others follow them; >= 4
    double noise_distance = 4;        ///< least distance of these, in standard deviations of the noise; >= 0
    int rounds = 40;                  ///< of descent; >= 1
    int passes = 6;                   ///< of signs on the whole cloud; >= 1
    int repairs = 3;                  ///< of places where signs are mixed; >= 0
    double first_width = 4;           ///< of the kernel, in spacings of the thinned cloud, falling from here ...
    double last_width = 1;            ///< ... to this; > 0

    /// Throws core::UsageError naming the field.
    void validate() const;
};

struct Orientation {
    std::vector<Vector3> normals;  ///< unit, outwards
    std::vector<double> areas;  ///< of the surface, one for each point, scaled so that the winding number inside is 1
};

/// `noise`: standard deviation of the points off the surface.
Orientation oriented_normals(const Cloud& cloud, std::span<const Vector3> axes, double noise,
                             const OrientationParameters& parameters, core::Observer& observer);

}  // namespace dsc::reconstruct
