// SPDX-License-Identifier: GPL-3.0-or-later
// The growth of the front in the chart: a row of pictures of the distance circle with the minimising geodesics of its
// vertices (thesis Fig. 5.3). Guarantee: as svg_chart.
#pragma once

#include <string>

#include "apps/cutlocus/front.h"
#include "apps/cutlocus/picture/polyline.h"
#include "apps/cutlocus/picture/svg_chart.h"

namespace dsc::cutlocus {

/// Six snapshots from the first to the last, in two rows. Throws core::UsageError if there is no snapshot.
std::string svg_front(const geodesic::Metric& metric, const geodesic::Point2& p, const FrontResult& front,
                      const ChartStyle& style = {});

/// The front of a snapshot as a closed line of the universal cover without jumps between periods.
Polyline front_line(const FrontSnapshot& snapshot, const geodesic::ChartPeriods& periods);

}  // namespace dsc::cutlocus
