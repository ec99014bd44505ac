// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of a cut locus in its chart, for print (thesis Figs. 5.1 and 5.4 to 5.6).
// Guarantee: lines are cut at the seams, and thinned to 0.2 px. Cost: some tenths of a second for a torus.
//
//     io::write_file("locus.svg", svg_chart(torus, {0, 0}, cut_locus(torus, {0, 0}, {}, silent)));
#pragma once

#include <string>

#include "apps/cutlocus/cutlocus.h"
#include "geodesic/metric.h"

namespace dsc::cutlocus {

struct ChartStyle {
    std::string surface;  ///< what the title says about the surface; may be empty, left out if long
    bool has_title = true;
    double width = 800;   ///< px
    int geodesics = 120;  ///< evenly spaced directions
    int circles = 22;     ///< about this many distance circles
};

/// `what`, p and the surface; empty without a title.
std::string chart_title(const std::string& what, const geodesic::Metric& metric, const geodesic::Point2& p,
                        const ChartStyle& style);

/// The chart centred on (0, 0) with minimising geodesics, distance circles, cut locus and its vertices.
std::string svg_chart(const geodesic::Metric& metric, const geodesic::Point2& p, const CutLocus& locus,
                      const ChartStyle& style = {});

/// The chart centred on p with geodesics that go on beyond the cut locus, the circles of their ends and the conjugate
/// locus (Fig. 5.1): nothing is wrapped at the seams.
std::string svg_geodesics(const geodesic::Metric& metric, const geodesic::Point2& p, const CutLocus& locus,
                          const ChartStyle& style = {});

}  // namespace dsc::cutlocus
