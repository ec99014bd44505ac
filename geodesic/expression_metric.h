// SPDX-License-Identifier: GPL-3.0-or-later
// Metrics given by expressions in u and v: an embedding "x=...;y=...;z=..." or a tensor "E=...;F=...;G=...".
// Thesis 5.1.1 and 5.4.2. Grammar: geodesic/expression/syntax.h.
//
//   const ExpressionEmbedding torus("x=(2+cos(v))*cos(u); y=(2+cos(v))*sin(u); z=2*sin(v)", {2 * pi, 2 * pi});
//   check_metric(torus, "--embedding");
//   GeodesicFlow flow(torus, {0, 0});
//
// Guarantee: derivatives are symbolic, so that curvature and Christoffel symbols are exact up to rounding; the same
// bits in every run and on every thread. Cost: 0.1 to 0.2 µs per query for a torus of revolution, eight times the
// built-in formula; 0.6 µs for a torus with a wavy section.
#pragma once

#include <memory>
#include <string_view>

#include "geodesic/metric.h"

namespace dsc::geodesic {

class ExpressionEmbedding final : public Metric {
public:
    /// `text` must give all of x, y and z. Throws core::InputError with the column of what can't be read, with `source`
    /// as its source, and core::UsageError for a period that is not positive.
    ExpressionEmbedding(std::string_view text, ChartPeriods periods, std::string_view source = "--embedding");
    ~ExpressionEmbedding() override;

    MetricTensor tensor(const Point2& x) const override;
    LocalGeometry local_geometry(const Point2& x) const override;
    ConnectionJet connection_jet(const Point2& x) const override;
    std::optional<Point3> position(const Point2& x) const override;

private:
    class Programs;
    std::unique_ptr<Programs> programs_;
};

class ExpressionMetric final : public Metric {
public:
    /// `text` must give all of E, F and G (F = 0 too). Throws as ExpressionEmbedding.
    ExpressionMetric(std::string_view text, ChartPeriods periods, std::string_view source = "--metric");
    ~ExpressionMetric() override;

    MetricTensor tensor(const Point2& x) const override;
    LocalGeometry local_geometry(const Point2& x) const override;
    ConnectionJet connection_jet(const Point2& x) const override;

private:
    class Programs;
    std::unique_ptr<Programs> programs_;
};

}  // namespace dsc::geodesic
