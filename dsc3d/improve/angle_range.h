// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest and the largest dihedral angle of a mesh. Cost: linear.
#pragma once

#include "dsc3d/mesh.h"

namespace dsc::dsc3d {

struct AngleRange {
    double min = 0;  ///< [rad]
    double max = 0;  ///< [rad]

    explicit AngleRange(const Mesh& mesh);
};

}  // namespace dsc::dsc3d
