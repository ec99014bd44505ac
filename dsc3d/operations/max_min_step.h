// SPDX-License-Identifier: GPL-3.0-or-later
// One step of the maximization of a minimum of smooth functions: the point d that maximizes
//
//     min_k (value_k + gradient_k . d) - |d|^2 / (2 s),
//
// the linear model of the minimum, held close by a proximal term of scale s [length^2].
// Its dual is a quadratic program over the unit simplex, min |sum l_k gradient_k|^2 s / 2 + sum l_k value_k, solved
// exactly by an active set of at most four functions (five while one is exchanged).
// Source: the max-min problem of Freitag, Jones and Plassmann (thesis 3.2.1); proximal bundle step, e.g. Kiwiel (1990).
// Cost: linear in the number of functions times the 4 to 8 exchanges; no allocation.
#pragma once

#include <Eigen/Core>
#include <span>

#include "geometry/tetrahedron_quality.h"

namespace dsc::dsc3d {

struct MaxMinStep {
    Eigen::Vector3d step;
    double predicted;  ///< the linear model's minimum there
};

/// Precondition: at least one term, s > 0.
MaxMinStep max_min_step(std::span<const geometry::QualityTerm> terms, double s);

}  // namespace dsc::dsc3d
