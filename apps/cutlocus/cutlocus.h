// SPDX-License-Identifier: GPL-3.0-or-later
// The cut locus of a point on a Riemannian 2-manifold, exact and certified.
// Source: thesis chapter 5 for the front; exact points, arcs and the certificate are what it names as missing (5.4.1).
// Guarantee: if result.graph.certificate.holds(), every sample lies within the tolerance of the cut locus and nothing
// of it is missing; same input, same bits. Cost: about half a second for a torus.
//
//     geodesic::TorusOfRevolution torus(2, 2);
//     core::Observer silent;
//     CutLocus locus = cut_locus(torus, {0, 0}, {}, silent);
//     for (const CutArc& arc : locus.graph.arcs) use(arc.samples);
#pragma once

#include <optional>
#include <vector>

#include "apps/cutlocus/cut_graph.h"
#include "apps/cutlocus/front.h"
#include "core/observer.h"
#include "geodesic/metric.h"

namespace dsc::cutlocus {

struct CutLocusParameters {
    double tolerance = 1e-9;             ///< of positions, on the surface; in [1e-11, 1e-3]
    double spacing = 0.005;              ///< of the samples of an arc, on the surface; > 0
    std::optional<double> max_distance;  ///< as far as asked for; needed unless the chart is a torus
    /// Spacing of the front, relative to the square root of the area (or to max_distance); in [1e-4, 0.1].
    double front_spacing = 0.01;
    double largest_shift = 4;  ///< between a contact of the front and the exact meeting it announces; in front spacings
    int max_refinements = 3;   ///< halvings of the front's spacing while the certificate fails; >= 0
    int snapshots = 0;         ///< of the front, about
    int threads = 1;           ///< 0: all; the result does not depend on it

    /// Throws core::UsageError that names the first field out of its range.
    void validate() const;
};

struct CutLocus {
    CutGraph graph;
    FrontResult front;
    double front_spacing = 0;  ///< on the surface, the one that led to the result
    int refinements = 0;
    double front_seconds = 0, exact_seconds = 0;
};

/// Throws core::UsageError, core::Cancelled, core::RunError. A result whose certificate does not hold is returned as it
/// is: its failures say what is wrong, and where.
CutLocus cut_locus(const geodesic::Metric& metric, const geodesic::Point2& p, const CutLocusParameters& parameters,
                   core::Observer& observer);

}  // namespace dsc::cutlocus
