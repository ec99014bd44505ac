// SPDX-License-Identifier: GPL-3.0-or-later
// Quality measures of a tetrahedron: indifferent to scale, 0 when it is flat, negative when it is inverted, larger when
// it is better. Source: thesis 3.3.3 (minimum sine, minimum biased sine), 4.3.2 (volume-length ratio);
// radius ratio: three times the radius of the inscribed sphere over that of the circumscribed one.
// Guarantee: the sign is that of the rounded volume; validity is decided by geometry/predicates.h.
// Cost: 30 to 100 ns, no allocation.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "geometry/predicates.h"

namespace dsc::geometry {

enum class QualityMeasure : std::uint8_t {
    minimum_sine,         ///< least sine of the six dihedral angles
    minimum_biased_sine,  ///< the same, sines of obtuse angles multiplied by `obtuse_bias`
    volume_length,        ///< 6 sqrt(2) V / (root mean square of the edge lengths)^3
    radius_ratio,         ///< 3 r / R
};

inline constexpr double obtuse_bias = 0.7;

/// Quality of the tetrahedron a, b, c, d; `bias` is that of the minimum biased sine.
double quality(QualityMeasure measure, const Point3& a, const Point3& b, const Point3& c, const Point3& d,
               double bias = obtuse_bias);

/// One smooth function of which a quality is the minimum, and its gradient with respect to the first vertex.
struct QualityTerm {
    double value;
    Eigen::Vector3d gradient;
};

/// The smooth functions of which the quality is the minimum (six sines, or one ratio); returns their number.
/// Precondition: positive volume.
int quality_terms(QualityMeasure measure, const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                  std::array<QualityTerm, 6>& terms, double bias = obtuse_bias);

/// Cotangents of the dihedral angles at the edges ab, ac, ad, bc, bd, cd: cheaper than the angles, and in reverse
/// order. Precondition: positive volume.
std::array<double, 6> dihedral_cotangents(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// Dihedral angles [rad] at the edges ab, ac, ad, bc, bd, cd; above pi or negative when the tetrahedron is inverted.
std::array<double, 6> dihedral_angles(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

}  // namespace dsc::geometry
