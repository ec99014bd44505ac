// SPDX-License-Identifier: GPL-3.0-or-later
// A random smooth velocity without divergence, that repeats itself by the box: the curl of a potential that is a sum of
// plane waves. With walls, the potential fades out towards the sides of the box, which nothing crosses then.
// Source: Bridson, Hourihan, Nordenstam (2007), "Curl-noise for procedural fluid flow". Guarantee: derivatives are
// analytic, so that the divergence is zero to rounding; same seed, same bits; the largest speed is `max_speed`, as
// found by a lattice and a climb from its maxima. Cost: `waves` sines and cosines; to make: the lattice, well below a
// second.
//
//     const motion::VelocityField<3> noise =
//         motion::curl_noise({.low = {0, 0, 0}, .high = {1, 1, 1}, .has_walls = true, .max_speed = 1, .seed = 7});
#pragma once

#include <cstdint>

#include "motion/velocity.h"

namespace dsc::motion {

template <int Dimension>
struct CurlNoiseParameters {
    Vector<Dimension> low = Vector<Dimension>::Zero();   ///< corner of the box
    Vector<Dimension> high = Vector<Dimension>::Ones();  ///< opposite corner; larger in every coordinate
    bool has_walls = false;                              ///< nothing crosses the sides of the box
    /// Thickness of the layer in which the potential fades out [size of the box]. In (0, 0.5].
    double wall_layer = 0.25;
    int waves = 24;            ///< plane waves in the sum. >= 1
    double max_frequency = 3;  ///< largest number of wave lengths across the box, in any direction. In [1, 20]
    double max_speed = 1;      ///< [length/time], >= 0
    std::uint64_t seed = 1;

    /// Throws core::UsageError that names the first field out of its range.
    void validate() const;
};

VelocityField<2> curl_noise(const CurlNoiseParameters<2>& parameters);
VelocityField<3> curl_noise(const CurlNoiseParameters<3>& parameters);

}  // namespace dsc::motion
