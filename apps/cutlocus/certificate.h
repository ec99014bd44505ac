// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate of a cut locus. The surface without the cut locus is a disc of directions and distances, so its area
// in geodesic polar coordinates, ∮ ∫₀^{t_cut} j dt dtheta, is the area of the surface: what is missing from the cut
// locus, or does not belong to it, shows as an overlap or a gap. Besides: the graph is connected, its first Betti
// number is that of the surface (2 for a torus), and every direction lies on one side of one arc.
#pragma once

#include "apps/cutlocus/cut_graph.h"
#include "geodesic/metric.h"

namespace dsc::cutlocus {

struct CertificateParameters {
    double area_tolerance = 1e-8;       ///< relative
    double direction_tolerance = 1e-9;  ///< rad
    double end_tolerance = 1e-7;        ///< of the ends of an arc against its vertices, in the chart and in rad
};

/// Completes graph.certificate, the figures of the arcs being there already, and lists what fails.
/// On a torus everything is checked; elsewhere all but the area and the Betti number.
void certify(const geodesic::Metric& metric, CutGraph& graph, const CertificateParameters& parameters = {});

}  // namespace dsc::cutlocus
