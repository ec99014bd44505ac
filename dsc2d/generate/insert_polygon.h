// SPDX-License-Identifier: GPL-3.0-or-later
// Puts a closed polygon into a complex: its corners become vertices, its sides edges, its inside gets a label.
// Source: thesis 4.3.1 (the mesh conforms to the initial interface); edges are recovered by flips as in Sloan (1993).
// Guarantee: the complex is valid and constrained Delaunay at the end. When an exception is thrown the complex is still
// valid, but may have gained vertices. Cost: walks of the square root of the number of faces per corner.
//
//     std::vector<VertexId> front = insert_polygon(complex, circle, 1);
//     insert_regions(complex, {{{lower_half, 1}, {upper_half, 2}}});
#pragma once

#include <span>
#include <vector>

#include "core/observer.h"
#include "dsc2d/complex.h"

namespace dsc::dsc2d {

/// `corners` are cover coordinates of a simple closed polygon, either orientation; it may cross the seam. Returns the
/// interface vertices along the polygon in the order of `corners`: one per corner, and one for every vertex of the
/// complex that happens to lie exactly on a side. Throws core::InputError when the polygon has fewer than three
/// corners, touches itself, one of its own translates, an interface that is there already, or the boundary of the
/// domain.
std::vector<VertexId> insert_polygon(Complex& complex, std::span<const Point2> corners, int label);

/// A part of the plane by its outline, a simple polygon in either orientation.
struct Region {
    std::vector<Point2> outline;
    int label = 1;
};

/// The same for regions that may touch each other in whole sides and in corners, as the parts of a block do, or lie in
/// one another: then the later one counts. None may cross one before it. Throws core::Cancelled when the observer asks
/// for an end, and leaves the complex half-done.
void insert_regions(Complex& complex, std::span<const Region> regions, const core::Observer& observer = {});

/// The same for several polygons that don't touch each other; later ones may lie inside earlier ones.
std::vector<std::vector<VertexId>> insert_polygons(Complex& complex, std::span<const std::vector<Point2>> polygons,
                                                   std::span<const int> labels);

}  // namespace dsc::dsc2d
