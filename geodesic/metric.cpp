// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic/metric.h"

#include <cmath>

#include "core/assert.h"
#include "core/errors.h"

namespace dsc::geodesic {

double MetricTensor::norm(const Vector2& a) const { return std::sqrt(inner(a, a)); }

Vector2 MetricTensor::rotated(const Vector2& a) const {
    const double root = std::sqrt(determinant());
    return {-(F * a.x() + G * a.y()) / root, (E * a.x() + F * a.y()) / root};
}

Vector2 ChartPeriods::translation(const LatticeVector& lattice) const {
    DSC_ASSERT(u || lattice.x() == 0);
    DSC_ASSERT(v || lattice.y() == 0);
    return {u.value_or(0) * lattice.x(), v.value_or(0) * lattice.y()};
}

Point2 ChartPeriods::wrapped(Point2 point) const {
    if (u) point.x() -= *u * std::floor(point.x() / *u + 0.5);
    if (v) point.y() -= *v * std::floor(point.y() / *v + 0.5);
    return point;
}

std::optional<Point3> Metric::position(const Point2&) const { return std::nullopt; }

Frame::Frame(const MetricTensor& tensor) : e1(1 / std::sqrt(tensor.E), 0), e2(tensor.rotated(e1)) {}

double total_area(const Metric& metric, double tolerance) {
    DSC_ASSERT(metric.periods().is_torus());
    const double period_u = *metric.periods().u, period_v = *metric.periods().v;
    const auto trapezoidal = [&](int count) {
        double sum = 0;
        for (int i = 0; i < count; ++i) {
            double column = 0;  // summed apart, so that rounding errors don't pile up
            for (int k = 0; k < count; ++k)
                column += std::sqrt(metric.tensor({i * period_u / count, k * period_v / count}).determinant());
            sum += column;
        }
        return sum * (period_u / count) * (period_v / count);
    };
    double previous = trapezoidal(16);
    for (int count = 32; count <= 4096; count *= 2) {
        const double area = trapezoidal(count);
        if (std::abs(area - previous) <= tolerance * area) return area;
        previous = area;
    }
    throw core::RunError("the area of the surface does not converge: is the metric smooth and periodic?");
}

}  // namespace dsc::geodesic
