// SPDX-License-Identifier: GPL-3.0-or-later
// A cut locus as one HTML page: the surface in space with cut locus, vertices, distance circles and the growing front
// on a slider, the same in the chart, and the geodesic to the place that is clicked on. Without an embedding the chart
// alone.
//
// Guarantee: as io/html_view. Cost: some tenths of a second and 5 to 7 MB for a torus, most of it the table of
// geodesics and the fronts.
#pragma once

#include <filesystem>
#include <string>

#include "apps/cutlocus/cutlocus.h"
#include "apps/cutlocus/picture/svg_chart.h"
#include "geodesic/metric.h"
#include "io/html_view.h"

namespace dsc::cutlocus {

io::HtmlPage html_page(const geodesic::Metric& metric, const geodesic::Point2& p, const CutLocus& locus,
                       const ChartStyle& style = {});

void write_html(const std::filesystem::path& path, const geodesic::Metric& metric, const geodesic::Point2& p,
                const CutLocus& locus, const ChartStyle& style = {});

}  // namespace dsc::cutlocus
