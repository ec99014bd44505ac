// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic/metric_check.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "core/assert.h"
#include "core/errors.h"
#include "core/random.h"

namespace dsc::geodesic {

namespace {

constexpr double smallest_definiteness = 1e-14;  // of det / trace²: below it E G - F² is rounding noise
constexpr std::size_t searched_minima = 16;
constexpr int period_samples = 256;

std::string short_text(double value) {
    std::array<char, 32> buffer;
    std::snprintf(buffer.data(), buffer.size(), "%.6g", value);
    return buffer.data();
}

std::string place(const Point2& x) { return "u = " + short_text(x.x()) + ", v = " + short_text(x.y()); }

class Checker {
public:
    Checker(const Metric& metric, std::string_view source, const MetricCheckParameters& parameters)
        : metric_(metric), source_(source), parameters_(parameters), low_(parameters.center) {
        const auto span = [&](const std::optional<double>& period) { return period.value_or(2 * parameters.reach); };
        extent_ = {span(metric.periods().u), span(metric.periods().v)};
        low_ -= extent_ / 2;
    }

    void check_definiteness() {
        const int n = parameters_.grid;
        const Vector2 spacing = extent_ / n;
        std::vector<Point2> points;
        std::vector<double> values;
        // A strip without period has two ends; on a period the last point would be the first one again.
        const int columns = n + !metric_.periods().u, rows = n + !metric_.periods().v;
        for (int i = 0; i < columns; ++i)
            for (int k = 0; k < rows; ++k) {
                points.push_back(low_ + Vector2{i * spacing.x(), k * spacing.y()});
                values.push_back(definiteness(points.back()));
            }
        for (const std::size_t start : lowest(values, columns, rows)) descend(points[start], values[start], spacing);
    }

    void check_period(const Vector2& translation, const char* direction) {
        core::Random random(1);
        for (int i = 0; i < period_samples; ++i) {
            const Point2 x = low_ + Vector2{random.uniform() * extent_.x(), random.uniform() * extent_.y()};
            const double change = relative_change(metric_.local_geometry(x), metric_.local_geometry(x + translation));
            if (!(change <= parameters_.period_tolerance))
                throw core::InputError(source_, place(x),
                                       "the metric changes by a fraction " + short_text(change) + " over the period " +
                                           short_text(translation.norm()) + " in " + direction,
                                       "correct the expression or --period");
        }
    }

private:
    /// det / trace² of the tensor, after checking that it is a positive number.
    double definiteness(const Point2& x) const {
        const MetricTensor g = metric_.tensor(x);
        const double determinant = g.determinant(), trace = g.E + g.G, value = determinant / (trace * trace);
        if (!std::isfinite(g.E + g.F + g.G))
            throw core::InputError(source_, place(x),
                                   "the metric is not finite: E = " + short_text(g.E) + ", F = " + short_text(g.F) +
                                       ", G = " + short_text(g.G),
                                   "it must be a number everywhere on the chart");
        if (!(g.E > 0 && g.G > 0 && value > smallest_definiteness))
            throw core::InputError(
                source_, place(x),
                "E G - F^2 = " + short_text(determinant) + " with E = " + short_text(g.E) + ", G = " + short_text(g.G) +
                    ": the metric is " +
                    (g.E > 0 && g.G > 0 && determinant > 0 ? "degenerate to rounding" : "not positive definite"),
                "it must be everywhere on the chart");
        return value;
    }

    /// The deepest local minima of the grid (against the four neighbours, with wrap-around).
    static std::vector<std::size_t> lowest(const std::vector<double>& values, int columns, int rows) {
        const auto index = [&](int i, int k) {
            return static_cast<std::size_t>((i + columns) % columns * rows + (k + rows) % rows);
        };
        std::vector<std::size_t> minima;
        for (int i = 0; i < columns; ++i)
            for (int k = 0; k < rows; ++k) {
                const double value = values[index(i, k)];
                if (value <= values[index(i - 1, k)] && value <= values[index(i + 1, k)] &&
                    value <= values[index(i, k - 1)] && value <= values[index(i, k + 1)])
                    minima.push_back(index(i, k));
            }
        std::stable_sort(minima.begin(), minima.end(),
                         [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
        minima.resize(std::min(minima.size(), searched_minima));
        return minima;
    }

    /// Compass search: a tensor that degenerates on a curve between the grid points is found out on the way down.
    void descend(Point2 x, double value, Vector2 step) const {
        constexpr int halvings = 32;
        for (int halving = 0; halving < halvings; step /= 2, ++halving)
            for (const Vector2& direction : {Vector2{1, 0}, Vector2{-1, 0}, Vector2{0, 1}, Vector2{0, -1}}) {
                const Point2 candidate = x + direction.cwiseProduct(step);
                if (!is_in_chart(candidate)) continue;
                const double candidate_value = definiteness(candidate);
                if (candidate_value < value) x = candidate, value = candidate_value;
            }
    }

    bool is_in_chart(const Point2& x) const {
        const auto is_within = [](double a, double low, double extent, bool has_period) {
            return has_period || (a >= low && a <= low + extent);
        };
        return is_within(x.x(), low_.x(), extent_.x(), metric_.periods().u.has_value()) &&
               is_within(x.y(), low_.y(), extent_.y(), metric_.periods().v.has_value());
    }

    static double relative_change(const LocalGeometry& a, const LocalGeometry& b) {
        // Free of the unit of length: the comparison is the same for a surface of a millimetre and of a kilometre.
        const double unit = a.tensor.E + a.tensor.G;
        const auto numbers = [&](const LocalGeometry& g) {
            return std::array{g.tensor.E / unit,  g.tensor.F / unit,  g.tensor.G / unit,  g.christoffel_u[0],
                              g.christoffel_u[1], g.christoffel_u[2], g.christoffel_v[0], g.christoffel_v[1],
                              g.christoffel_v[2], g.curvature * unit};
        };
        const auto p = numbers(a), q = numbers(b);
        double largest = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double change = std::abs(p[i] - q[i]) / (1 + std::abs(p[i]) + std::abs(q[i]));
            if (!(change <= largest)) largest = change;  // keeps a NaN
            if (std::isnan(largest)) break;
        }
        return largest;
    }

    const Metric& metric_;
    std::string source_;
    MetricCheckParameters parameters_;
    Point2 low_;
    Vector2 extent_;
};

}  // namespace

void check_metric(const Metric& metric, std::string_view source, const MetricCheckParameters& parameters) {
    DSC_ASSERT(parameters.grid >= 2);
    Checker checker(metric, source, parameters);
    checker.check_definiteness();
    const ChartPeriods& periods = metric.periods();
    if (periods.u) checker.check_period({*periods.u, 0}, "u");
    if (periods.v) checker.check_period({0, *periods.v}, "v");
}

}  // namespace dsc::geodesic
