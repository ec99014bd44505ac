// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic/scaled_metric.h"

#include "core/assert.h"

namespace dsc::geodesic {

ScaledMetric::ScaledMetric(const Metric& metric, double factor)
    : Metric(metric.periods()), metric_(metric), factor_(factor) {
    DSC_ASSERT(factor > 0);
}

MetricTensor ScaledMetric::scaled(const MetricTensor& tensor) const {
    const double square = factor_ * factor_;
    return {square * tensor.E, square * tensor.F, square * tensor.G};
}

MetricTensor ScaledMetric::tensor(const Point2& x) const { return scaled(metric_.tensor(x)); }

LocalGeometry ScaledMetric::local_geometry(const Point2& x) const {
    LocalGeometry local = metric_.local_geometry(x);
    local.tensor = scaled(local.tensor);
    local.curvature /= factor_ * factor_;
    local.curvature_gradient /= factor_ * factor_;
    return local;
}

ConnectionJet ScaledMetric::connection_jet(const Point2& x) const {
    ConnectionJet jet = metric_.connection_jet(x);
    jet.tensor = scaled(jet.tensor);
    return jet;
}

std::optional<Point3> ScaledMetric::position(const Point2& x) const {
    std::optional<Point3> place = metric_.position(x);
    if (place) *place *= factor_;
    return place;
}

}  // namespace dsc::geodesic
