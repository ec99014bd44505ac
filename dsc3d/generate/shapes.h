// SPDX-License-Identifier: GPL-3.0-or-later
// Closed surfaces to begin with: all edges about as long as asked for, normals outwards.
// Guarantee: closed, oriented, manifold; the same bits everywhere for the same arguments. Least angle of a triangle: 50
// degrees (icosphere), 30 (torus with minor <= major / 2, dumbbell). Throws core::UsageError, naming the shape, for
// lengths that are not positive or don't fit together. Cost: linear, below a microsecond per triangle.
//
//     geometry::SurfaceData ball = dsc3d::icosphere(Point3(0.5, 0.5, 0.5), 0.3, 8);  // 1280 triangles
#pragma once

#include <cstdint>

#include "geometry/predicates.h"
#include "geometry/surface_data.h"

namespace dsc::dsc3d {

using geometry::Point3;

/// An icosahedron whose edges were divided into `frequency` parts, on the sphere: 20 frequency^2 triangles. Powers of
/// two are reached by halving edges on the sphere, which keeps the triangles most alike.
geometry::SurfaceData icosphere(const Point3& centre, double radius, std::uint32_t frequency);

/// The frequency at which the edges of an icosphere are about `edge_length` long on average.
std::uint32_t icosphere_frequency(double radius, double edge_length);

/// Two icospheres beside each other in direction x, `gap` between them, their middle at `centre`.
geometry::SurfaceData two_spheres(const Point3& centre, double radius, double gap, std::uint32_t frequency);

/// Around an axis in direction z: `major` is the radius of the circle in the middle of the tube, `minor` that of the
/// tube. 0 < minor < major.
geometry::SurfaceData torus(const Point3& centre, double major, double minor, double edge_length);

struct DumbbellSize {
    double half_distance = 0.5;  ///< of the centres of the balls, on a line in direction x
    double ball_radius = 0.3;    ///< in (0, half_distance)
    double neck_radius = 0.1;    ///< where it is thinnest; in (0, ball_radius)
};

/// Two balls and a neck between them: a surface of revolution. The profile of the neck is the arc of a circle that
/// touches both balls, so that the normals are continuous.
geometry::SurfaceData dumbbell(const Point3& centre, const DumbbellSize& size, double edge_length);

}  // namespace dsc::dsc3d
