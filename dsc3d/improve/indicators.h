// SPDX-License-Identifier: GPL-3.0-or-later
// The quality indicators of a mesh: its worst tetrahedron and seven thresholded means, by which a schedule judges
// whether a pass has improved it. Source: thesis 3.4. Cost: linear.
#pragma once

#include <array>

#include "dsc3d/operations/rated_mesh.h"

namespace dsc::dsc3d {

struct QualityIndicators {
    double worst = 0;
    std::array<double, 7> means = {};  ///< of min(quality, sin of 1, 5, 10, 15, 25, 35, 45 degrees)

    explicit QualityIndicators(const RatedMesh& mesh);

    /// The worst quality or one of the means has increased by at least `least_gain`.
    bool is_better_than(const QualityIndicators& before, double least_gain) const;
    /// Each indicator becomes the larger of the two.
    void raise_to(const QualityIndicators& other);
};

}  // namespace dsc::dsc3d
