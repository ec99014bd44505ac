// SPDX-License-Identifier: GPL-3.0-or-later
// Curvature of a triangle surface at a vertex: mean curvature by the cotangent formula over the mixed Voronoi area,
// Gaussian curvature by the angle defect.
// Source: thesis 4.4.1.2; Meyer, Desbrun, Schröder, Barr (2003), "Discrete Differential-Geometry Operators for
// Triangulated 2-Manifolds". Convention: the flow moves a vertex with the speed k1 + k2, so that a sphere of radius r0
// has the radius sqrt(r0^2 - 4 t). Guarantee: exactly zero up to rounding inside a plane; second order in the edge
// length on regular meshes. Cost: linear in the ring, no allocation.
#pragma once

#include "surface/one_ring.h"

namespace dsc::surface {

struct Curvature {
    /// (k1 + k2) times the unit normal that points to the centre of curvature: the velocity of mean curvature flow.
    /// Minus the gradient of the area of the ring over the mixed area, whatever the orientation and the number of
    /// sheets; at a boundary it holds the pull of the free edge.
    Vector3 vector;
    double gaussian;  ///< k1 k2; only for a closed ring of one sheet
    double area;      ///< mixed Voronoi area
    /// Explicit steps of the flow below 1 over the largest stiffness are stable [1/time].
    double stiffness;

    double mean() const { return 0.5 * vector.norm(); }  ///< |k1 + k2| / 2
    /// The larger of |k1| and |k2|.
    double max_principal() const;
};

/// Zeros for a ring without area.
Curvature curvature(const OneRing& ring);

/// Cotangents of the angles at p and q of the triangle (centre, p, q), and its share of the mixed area of the centre.
struct CotangentTriangle {
    double cot_p;
    double cot_q;
    double mixed_area;
    double angle;  ///< at the centre [rad]
};
/// Zeros for a triangle without area.
CotangentTriangle cotangents(const Point3& centre, const Point3& p, const Point3& q);

}  // namespace dsc::surface
