// SPDX-License-Identifier: GPL-3.0-or-later
// The distance up to which the geodesic in a direction minimises. From the samples of the arcs of a cut locus: each arc
// is seen from p over two intervals of directions, one for each of its sides. Or, where there is nothing but a front,
// from its stopped vertices.
//
// Guarantee: from a cut locus, cubic interpolation between samples, exact at samples and vertices; from a front,
// linear interpolation, as good as the front. Cost: O(log samples) per query.
#pragma once

#include <vector>

#include "apps/cutlocus/cutlocus.h"

namespace dsc::cutlocus {

class CutDistance {
public:
    /// From the arcs; from the front if there are none.
    explicit CutDistance(const CutLocus& locus);
    explicit CutDistance(const FrontResult& front);

    struct Reach {
        double distance = 0;
        bool is_on_locus = true;  ///< false: the geodesic was followed no further than asked for
    };
    Reach reach(double theta) const;
    /// No geodesic that was followed is longer; a length that scales pictures.
    double limit() const { return limit_; }

private:
    struct Side {
        std::vector<double> thetas;  // ascending, the first in [0, 2π)
        std::vector<double> distances;
        bool ends_at_frontier = false;
        bool is_smooth = true;
    };
    static double interpolated(const Side& side, double theta);

    std::vector<Side> sides_;  // in the order of their directions
    double limit_;
};

}  // namespace dsc::cutlocus
