// SPDX-License-Identifier: GPL-3.0-or-later
// The chart as the domain of the front's complex, stretched by a linear map so that on average a length in the domain
// is the length on the surface: the complex judges shapes by Euclidean lengths and angles.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "dsc2d/domain.h"
#include "geodesic/metric.h"

namespace dsc::cutlocus {

class FrontChart {
public:
    /// `reach`: half extents in u and v of the part of the chart that is needed where it is not periodic.
    FrontChart(const geodesic::Metric& metric, const geodesic::Point2& origin, const geodesic::Vector2& reach);

    const dsc2d::Domain& domain() const { return domain_; }
    geodesic::Point2 to_domain(const geodesic::Point2& x) const { return stretch_ * (x - origin_); }
    geodesic::Point2 to_chart(const geodesic::Point2& y) const { return origin_ + inverse_ * y; }
    /// The lattice vector nearest to a translation of the domain.
    geodesic::LatticeVector lattice_of(const geodesic::Vector2& translation) const;

private:
    geodesic::Point2 origin_;
    geodesic::ChartPeriods periods_;
    Eigen::Matrix2d stretch_, inverse_;
    dsc2d::Domain domain_;
};

}  // namespace dsc::cutlocus
