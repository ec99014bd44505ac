// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines to begin with: discs, regular polygons, rectangles, and what is made of them, with sides about as long as
// asked for.
// Guarantee: simple polygons, counterclockwise; corners of the shape are corners of the outline. The same bits for the
// same arguments. Throws core::UsageError, naming the shape, for lengths that are not positive or don't fit together.
// Cost: linear.
//
//     std::vector<dsc2d::Region> disc = dsc2d::disc({0.5, 0.5}, 0.3, 0.01);
#pragma once

#include <vector>

#include "dsc2d/generate/insert_polygon.h"

namespace dsc::dsc2d {

/// A regular polygon, its first corner in direction x, or in direction y when `stands`: on a side, if the number of
/// corners is odd.
std::vector<Point2> regular_polygon(const Point2& centre, double radius, int corners, bool stands = false);

/// The corners, and as many places on each side as make its parts no longer than `edge_length`, up to a quarter.
std::vector<Point2> divided(const std::vector<Point2>& corners, double edge_length);

/// Regular polygons whose sides are about as long as `edge_length`.
std::vector<Region> disc(const Point2& centre, double radius, double edge_length);
/// Beside each other in direction x, `gap` between them, their middle at `centre`.
std::vector<Region> two_discs(const Point2& centre, double radius, double gap, double edge_length);
/// Between the circles of radius - half_width and radius + half_width. 0 < half_width < radius.
std::vector<Region> ring(const Point2& centre, double radius, double half_width, double edge_length);
std::vector<Region> rectangle(const Point2& centre, const Point2& size, double edge_length);

struct DumbbellSize {
    double half_distance = 0.5;  ///< of the centres of the discs, on a line in direction x
    double disc_radius = 0.3;    ///< in (0, half_distance)
    double neck = 0.1;           ///< half of the width where it is thinnest; in (0, disc_radius)
};

/// Two discs and a neck between them, whose sides are arcs of circles that touch both discs.
std::vector<Region> dumbbell(const Point2& centre, const DumbbellSize& size, double edge_length);

/// A disc with a slot from below, in the middle: Zalesak's. 0 < width / 2 < radius, 0 < depth < 2 radius.
std::vector<Region> slotted_disc(const Point2& centre, double radius, double width, double depth, double edge_length);

/// A rectangle of three labels that meet in its centre: 1 fills the half of low x, 2 and 3 the lower and the upper half
/// of the rest.
std::vector<Region> labelled_block(const Point2& centre, const Point2& size, double edge_length);

}  // namespace dsc::dsc2d
