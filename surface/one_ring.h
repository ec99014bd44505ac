// SPDX-License-Identifier: GPL-3.0-or-later
// What the algorithms of this folder see of a mesh: a vertex and the triangles at it, as positions. Any mesh can be
// shown to them, and none is known to them.
// Source: thesis 4.3.2.2. Guarantee: no order of the triangles is asked for, so that boundaries and vertices where more
// than two sheets meet need no case of their own. Cost: a view; the triangles lie in a buffer of the caller.
//
//     std::vector<surface::RingTriangle> buffer;       // kept from vertex to vertex
//     buffer.push_back({position(b), position(c)});    // for each triangle (v, b, c)
//     const surface::OneRing ring{position(v), buffer};
#pragma once

#include <Eigen/Core>
#include <span>

#include "geometry/predicates.h"

namespace dsc::surface {

using geometry::Point3;
using Vector3 = Eigen::Vector3d;

/// The triangle (centre, a, b), counterclockwise seen from the side the normal points to.
struct RingTriangle {
    Point3 a;
    Point3 b;

    bool has(const Point3& end) const { return a == end || b == end; }
};

struct OneRing {
    Point3 centre;
    std::span<const RingTriangle> triangles;
};

}  // namespace dsc::surface
