// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/front_geodesics.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/attribute.h"
#include "geodesic/two_point.h"

namespace dsc::cutlocus {

using core::VertexId;
using geodesic::GeodesicFlow;
using geodesic::GeodesicState;
using geodesic::Metric;
using geodesic::Point2;
using geodesic::Vector2;

namespace {

/// The direction between those of a and b, on the short way round.
double direction_between(const GeodesicState& a, const GeodesicState& b, double s) {
    return a.theta + s * std::remainder(b.theta - a.theta, 2 * std::numbers::pi);
}

class IntegratedGeodesics final : public FrontGeodesics {
public:
    IntegratedGeodesics(const dsc2d::Complex& complex, const Metric& metric, const Point2& origin, double tolerance)
        : flow_(metric, origin, tolerance), states_(complex.vertex_attributes()) {}

    void start(VertexId v, double theta, double t) override { states_[v] = flow_.shoot(theta, t); }
    void insert(VertexId v, VertexId a, VertexId b, double s, double t) override {
        states_[v] = flow_.shoot(direction_between(states_[a], states_[b], s), t);
    }
    void advance(VertexId v, double t) override { flow_.advance(states_[v], t - states_[v].t); }
    const GeodesicState& state(VertexId v) const override { return states_[v]; }

private:
    GeodesicFlow flow_;
    core::Attribute<VertexId, GeodesicState> states_;
};

class TwoPointGeodesics final : public FrontGeodesics {
public:
    TwoPointGeodesics(const dsc2d::Complex& complex, const Metric& metric, const Point2& origin, double segment_length,
                      double tolerance)
        : metric_(metric),
          origin_(origin),
          frame_(metric.tensor(origin)),
          segment_length_(segment_length),
          tolerance_(tolerance),
          solver_(metric, {.tolerance = tolerance * 1e-2, .max_iterations = 30}),
          states_(complex.vertex_attributes()),
          polylines_(complex.vertex_attributes()) {}

    void start(VertexId v, double theta, double t) override {
        const Point2 end = origin_ + t * frame_.direction(theta);
        polylines_[v] = geodesic::straight_polyline(origin_, end, segments(t));
        correct(v, t);
    }
    void insert(VertexId v, VertexId a, VertexId b, double s, double t) override {
        // Locked neighbours stopped at a smaller distance: both polylines are sampled alike before they are averaged.
        const int count = segments(t);
        const std::vector<Point2> first = resampled(polylines_[a], count), second = resampled(polylines_[b], count);
        polylines_[v].resize(first.size());
        for (std::size_t i = 0; i < first.size(); ++i) polylines_[v][i] = (1 - s) * first[i] + s * second[i];
        correct(v, t);
    }
    void advance(VertexId v, double t) override {
        polylines_[v].back() += (t - states_[v].t) * states_[v].velocity;
        if (static_cast<int>(polylines_[v].size()) <= segments(t))
            polylines_[v] = resampled(polylines_[v], segments(t));
        correct(v, t);
    }
    const GeodesicState& state(VertexId v) const override { return states_[v]; }

private:
    int segments(double t) const { return std::max(8, static_cast<int>(std::ceil(t / segment_length_))); }

    /// The polyline with `count` segments, by linear interpolation in the index.
    static std::vector<Point2> resampled(const std::vector<Point2>& nodes, int count) {
        std::vector<Point2> result;
        for (int i = 0; i <= count; ++i) {
            const double position = static_cast<double>(nodes.size() - 1) * i / count;
            const auto k = std::min(static_cast<std::size_t>(position), nodes.size() - 2);
            const double x = position - static_cast<double>(k);
            result.push_back((1 - x) * nodes[k] + x * nodes[k + 1]);
        }
        return result;
    }

    /// Pushes the end along its geodesic until it lies at distance t (5.2.2, 5.2.4).
    void correct(VertexId v, double t) {
        constexpr int max_pushes = 20;
        GeodesicState& state = states_[v];
        std::vector<Point2>& nodes = polylines_[v];
        for (int push = 0; push < max_pushes; ++push) {
            const geodesic::TwoPointReport report = solver_.solve(nodes);
            state.velocity = report.final_direction;
            const double angle = std::atan2(metric_.tensor(origin_).inner(report.initial_direction, frame_.e2),
                                            metric_.tensor(origin_).inner(report.initial_direction, frame_.e1));
            state.theta = angle;
            if (std::abs(report.length - t) <= tolerance_) break;
            nodes.back() += (t - report.length) * state.velocity;
        }
        state.x = nodes.back();
        state.t = t;
        state.j = std::numeric_limits<double>::infinity();  // not known to this method
    }

    const Metric& metric_;
    Point2 origin_;
    geodesic::Frame frame_;
    double segment_length_;
    double tolerance_;
    geodesic::TwoPointSolver solver_;
    core::Attribute<VertexId, GeodesicState> states_;
    core::Attribute<VertexId, std::vector<Point2>> polylines_;
};

}  // namespace

std::unique_ptr<FrontGeodesics> integrated_geodesics(const dsc2d::Complex& complex, const Metric& metric,
                                                     const Point2& origin, double tolerance) {
    return std::make_unique<IntegratedGeodesics>(complex, metric, origin, tolerance);
}

std::unique_ptr<FrontGeodesics> two_point_geodesics(const dsc2d::Complex& complex, const Metric& metric,
                                                    const Point2& origin, double segment_length, double tolerance) {
    return std::make_unique<TwoPointGeodesics>(complex, metric, origin, segment_length, tolerance);
}

}  // namespace dsc::cutlocus
