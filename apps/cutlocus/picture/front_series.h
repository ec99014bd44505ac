// SPDX-License-Identifier: GPL-3.0-or-later
// The growing front for ParaView: FOLDER/front.pvd and one VTP file per snapshot, in space where the surface has an
// embedding, otherwise in the chart. Point data: "chart" (u, v), "distance" from p and "theta", the direction at p.
// Guarantee: as io::PvdSeries. Cost: a tenth of a second for a torus.
#pragma once

#include <filesystem>

#include "apps/cutlocus/front.h"
#include "geodesic/metric.h"

namespace dsc::cutlocus {

/// Throws core::UsageError if the front was grown without snapshots, and core::InputError where the folder can't be
/// written.
void write_front_series(const std::filesystem::path& folder, const geodesic::Metric& metric, const geodesic::Point2& p,
                        const FrontResult& front);

}  // namespace dsc::cutlocus
