// SPDX-License-Identifier: GPL-3.0-or-later
// How long the edges of a tetrahedral mesh around a surface should be: as long as the surface's own ones next to it,
// growing with the distance. Guarantee: the same bits for the same input. Cost: building n log n, a query a microsecond
// or two.
#pragma once

#include <memory>

#include "geometry/predicates.h"
#include "geometry/surface_data.h"

namespace dsc::dsc3d {

using geometry::Point3;

class Sizing {
public:
    /// `growth`: of the edge length per distance. Precondition: at least one triangle, all of positive area.
    Sizing(const geometry::SurfaceData& surface, double growth);
    ~Sizing();
    Sizing(const Sizing&) = delete;
    Sizing& operator=(const Sizing&) = delete;

    struct Answer {
        double edge_length;          ///< wanted at the point
        double surface_edge_length;  ///< mean of the nearest triangle
        double distance;             ///< from the surface
    };
    Answer at(const Point3& p) const;

    double growth() const { return growth_; }
    double least_edge_length() const { return least_; }  ///< least mean of a triangle

private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
    std::vector<double> edge_length_;  ///< mean of each triangle
    double growth_;
    double least_ = 0;
};

}  // namespace dsc::dsc3d
