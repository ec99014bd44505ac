// SPDX-License-Identifier: GPL-3.0-or-later
// Tori of revolution with an elliptic generator (thesis 5.3.2; circular for lambda = 1, equation 5.1):
//   r(u,v) = ((R + cos v) cos u, (R + cos v) sin u, lambda sin v),  g = diag((R + cos v)², sin² v + lambda² cos² v).
// Guarantee: closed formulas, accurate to a few units in the last place for every lambda. Cost: one sine, one cosine.
#pragma once

#include "geodesic/metric.h"

namespace dsc::geodesic {

class TorusOfRevolution final : public Metric {
public:
    /// Throws core::UsageError unless lambda > 0 and |R| > 1: for |R| <= 1 the metric degenerates where R + cos v = 0.
    /// R < -1 is the torus of radius |R|, its chart turned by half a period in u and in v.
    TorusOfRevolution(double major_radius, double lambda);

    MetricTensor tensor(const Point2& x) const override;
    LocalGeometry local_geometry(const Point2& x) const override;
    ConnectionJet connection_jet(const Point2& x) const override;
    std::optional<Point3> position(const Point2& x) const override;

private:
    double major_radius_;
    double lambda_;
};

}  // namespace dsc::geodesic
