// SPDX-License-Identifier: GPL-3.0-or-later
// Curvature flow of an interface over a time of any length: every vertex moves by its discrete curvature vector, twice
// the sum of the unit vectors to its neighbours over the sum of their distances; at junctions by the same sum, which is
// zero where the angles are equal.
// Source: thesis 4.4.1.2; Desbrun, Meyer, Schröder, Barr (1999) for the semi-implicit step, in the plane. Each substep
// solves (M + h K) d = h f with the lengths as they are, once whole and once in halves; the extrapolated result is of
// second order, the difference chooses the substep. Guarantee: stable for every dt; a regular polygon of circumradius r
// follows r' = -1/r up to the tolerance, and so does any polygon on a circle. Cost: some sparse factorizations, each
// about linear in the interface.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dsc2d/interface.h"

namespace dsc::dsc2d {

struct CurvatureParameters {
    /// Edges count as no shorter than this, so that a curve that vanishes does so in finite time [length]. > 0.
    double shortest_edge = 0;
    /// Difference of whole and halved substep that is still taken [length of the edges at the vertex]. > 0.
    double tolerance = 2e-3;
    /// Substeps of one call at most. >= 1.
    int max_substeps = 2048;

    /// Throws core::UsageError that names the first field out of its range.
    void validate() const;
};

/// One for each vertex of the interface, after the time `dt` > 0; a vertex whose entry in `is_fixed` is not 0 stays.
std::vector<Point2> curvature_displacements(const Interface& interface, double dt,
                                            std::span<const std::uint8_t> is_fixed,
                                            const CurvatureParameters& parameters);

}  // namespace dsc::dsc2d
