// SPDX-License-Identifier: GPL-3.0-or-later
// Cut loci of many points of one surface: one CSV and one JSON file each, in a folder.
#pragma once

#include "apps/cutlocus/options.h"
#include "core/observer.h"

namespace dsc::cutlocus {

/// The points of a file with one u,v per line (blank lines and lines after '#' are skipped, numbers may be multiples of
/// pi). Throws core::InputError naming the line.
std::vector<Point2> read_points(const std::string& path);

/// Writes NNNN.csv and NNNN.json for each point of options.points_file into the folder options.common.output and prints
/// a line per point. With options.is_resumed points whose JSON file is there are passed over. Returns the number of
/// points whose certificate fails.
int run_batch(const Options& options, core::Observer& observer);

}  // namespace dsc::cutlocus
