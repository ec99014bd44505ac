// SPDX-License-Identifier: GPL-3.0-or-later
// The dihedral angles of meshes as histograms one below the other, to the same scale. Source: thesis tables 3.1 to 3.3.
// Bars that tower above all others are cut off, drawn in red, and carry their share.
#pragma once

#include <string>
#include <vector>

#include "apps/improve/mesh_statistics.h"

namespace dsc::improve {

struct AngleHistogram {
    std::string name;
    MeshStatistics statistics;
};

/// An SVG document that is `width` px wide; precondition: at least one histogram.
std::string histogram_picture(const std::vector<AngleHistogram>& histograms, double width = 520);

}  // namespace dsc::improve
