// SPDX-License-Identifier: GPL-3.0-or-later
// From the contacts of the front to the exact cut locus: every contact is a pair of directions and a lattice vector,
// from which Newton's method finds the exact meeting point; the gluing of the circle of directions tells which meetings
// follow each other on an arc, where the arcs end and where they branch; end and branch points and the arcs are solved
// exactly.
//
// Nothing but the contacts is searched for. What they did not announce (an arc between the branch points into which an
// inconsistent vertex of higher degree is resolved) is marked; where the gluing is inconsistent, a Doubt tells the
// direction near which the front was too coarse.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "apps/cutlocus/arc_curve.h"
#include "apps/cutlocus/cut_graph.h"
#include "apps/cutlocus/gluing.h"
#include "core/observer.h"

namespace dsc::cutlocus {

struct ExactParameters {
    double spacing = 0.005;              ///< of the samples of an arc, on the surface
    double tolerance = 1e-9;             ///< of every position, on the surface
    std::optional<double> max_distance;  ///< the largest distance asked for, if the surface is not closed
    /// Arriving geodesics whose ends lie closer than this (on the surface) meet in one vertex.
    double coincidence = 1e-9;
    /// The meetings that the contacts announce serve as first guesses, and are solved to this accuracy only; two of
    /// them, or one and a branch point, that lie closer together are taken for one.
    double draft_tolerance = 1e-6;
    /// A meeting may lie this far from the contact that announced it, on the surface.
    double largest_shift = std::numeric_limits<double>::infinity();
    int threads = 1;  ///< 0: all; the result does not depend on it
};

/// The graph of exact vertices and arcs, without its certificate. If `doubts` of the result is not empty, the graph is
/// incomplete. Throws core::Cancelled.
CutGraph exact_graph(const geodesic::Metric& metric, const Point2& origin, std::span<const DirectionPair> contacts,
                     std::span<const double> free_directions, const ExactParameters& parameters,
                     core::Observer& observer);

}  // namespace dsc::cutlocus
