// SPDX-License-Identifier: GPL-3.0-or-later
// Polylines for pictures: thinned to what can be seen, with steps that people like to read.
// Source: D. H. Douglas, T. K. Peucker, Algorithms for the reduction of the number of points required to represent a
// digitized line, 1973.
//
// Guarantee: the thinned line lies within the tolerance of the given one and keeps its ends. Cost: O(n log n) for what
// occurs in pictures.
#pragma once

#include <span>
#include <vector>

#include "geodesic/metric.h"

namespace dsc::cutlocus {

using Polyline = std::vector<geodesic::Point2>;

/// `line` with fewer points; no segment becomes longer than `longest_segment` that was not so before.
Polyline thinned(std::span<const geodesic::Point2> line, double tolerance, double longest_segment);

/// The smallest of 1, 2, 2.5, 5 times a power of ten that is at least `lower_bound` > 0.
double round_step(double lower_bound);

}  // namespace dsc::cutlocus
