// SPDX-License-Identifier: GPL-3.0-or-later
// A metric in another unit of length: the same surface, its geodesics and directions, with all lengths multiplied.
#pragma once

#include "geodesic/metric.h"

namespace dsc::geodesic {

class ScaledMetric final : public Metric {
public:
    /// `metric` must outlive this one; `factor` > 0 multiplies lengths. With a power of two nothing is rounded.
    ScaledMetric(const Metric& metric, double factor);

    MetricTensor tensor(const Point2& x) const override;
    LocalGeometry local_geometry(const Point2& x) const override;
    ConnectionJet connection_jet(const Point2& x) const override;
    std::optional<Point3> position(const Point2& x) const override;

private:
    MetricTensor scaled(const MetricTensor& tensor) const;

    const Metric& metric_;
    double factor_;
};

}  // namespace dsc::geodesic
