// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/front_chart.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

namespace dsc::cutlocus {

using dsc2d::Domain;
using geodesic::LatticeVector;
using geodesic::Metric;
using geodesic::Point2;
using geodesic::Vector2;

namespace {

/// Linear map under which Euclidean lengths are lengths in the mean of the metric over the needed part of the chart.
Eigen::Matrix2d mean_stretch(const Metric& metric, const Point2& origin, const Vector2& reach) {
    constexpr int samples = 16;  // in each direction
    const Vector2 extent{metric.periods().u.value_or(2 * reach.x()), metric.periods().v.value_or(2 * reach.y())};
    Eigen::Matrix2d mean = Eigen::Matrix2d::Zero();
    for (int i = 0; i < samples; ++i)
        for (int k = 0; k < samples; ++k) {
            const Vector2 offset{(i + 0.5) / samples - 0.5, (k + 0.5) / samples - 0.5};
            const geodesic::MetricTensor tensor = metric.tensor(origin + extent.cwiseProduct(offset));
            mean += (Eigen::Matrix2d() << tensor.E, tensor.F, tensor.F, tensor.G).finished() / (samples * samples);
        }
    return mean.llt().matrixU();
}

}  // namespace

FrontChart::FrontChart(const Metric& metric, const Point2& origin, const Vector2& reach)
    : origin_(origin),
      periods_(metric.periods()),
      stretch_(mean_stretch(metric, origin, reach)),
      inverse_(stretch_.inverse()),
      domain_([&] {
          const Vector2 u = stretch_.col(0) * periods_.u.value_or(2 * reach.x());
          const Vector2 v = stretch_.col(1) * periods_.v.value_or(2 * reach.y());
          const Point2 corner = -(u + v) / 2;
          if (periods_.u && periods_.v) return Domain::torus((Eigen::Matrix2d() << u, v).finished(), corner);
          if (periods_.u) return Domain::cylinder(u, v, corner);
          if (periods_.v) return Domain::cylinder(v, -u, corner + u);
          // Without periods any box will do that holds the parallelogram.
          const Vector2 half = (u.cwiseAbs() + v.cwiseAbs()) / 2;
          return Domain::box(-half, half);
      }()) {}

LatticeVector FrontChart::lattice_of(const Vector2& translation) const {
    const Vector2 chart = inverse_ * translation;
    const auto count = [](double length, const std::optional<double>& period) {
        return period ? static_cast<int>(std::lround(length / *period)) : 0;
    };
    return {count(chart.x(), periods_.u), count(chart.y(), periods_.v)};
}

}  // namespace dsc::cutlocus
