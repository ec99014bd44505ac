// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/arc_curve.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/assert.h"
#include "core/errors.h"

namespace dsc::cutlocus {

using geodesic::GeodesicFlow;
using geodesic::Meeting;
using geodesic::Vector2;

namespace {

/// Cubic Hermite prediction of (middle, t) between two meetings.
Vector2 predicted(const Meeting& a, const Meeting& b, double w) {
    const double width = b.w - a.w, x = (w - a.w) / width;
    const double h01 = x * x * (3 - 2 * x), h00 = 1 - h01, h10 = x * (1 - x) * (1 - x), h11 = x * x * (x - 1);
    return {h00 * a.middle + h10 * width * a.middle_w + h01 * b.middle + h11 * width * b.middle_w,
            h00 * a.t + h10 * width * a.t_w + h01 * b.t + h11 * width * b.t_w};
}

/// Values of w at which the arc is cut into panels of about `panel_length`.
std::vector<double> panel_borders(const GeodesicFlow& flow, const std::vector<Meeting>& anchors, double panel_length) {
    std::vector<double> chord{0};
    for (std::size_t i = 1; i < anchors.size(); ++i) {
        const Vector2 step = anchors[i].first.x - anchors[i - 1].first.x;
        chord.push_back(chord.back() + flow.metric().tensor(anchors[i].first.x).norm(step));
    }
    const int count = std::max(1, static_cast<int>(std::lround(chord.back() / panel_length)));
    std::vector<double> borders{anchors.front().w};
    for (int i = 1; i < count; ++i) {
        const double s = chord.back() * i / count;
        const auto k = static_cast<std::size_t>(std::upper_bound(chord.begin(), chord.end(), s) - chord.begin());
        const double x = (s - chord[k - 1]) / (chord[k] - chord[k - 1]);
        const double a = anchors[k - 1].w, b = anchors[k].w;
        // Next to a conjugate end the length grows with the square of w.
        const double border = a == 0 ? b * std::sqrt(x) : a + x * (b - a);
        if (border > borders.back()) borders.push_back(border);
    }
    borders.push_back(anchors.back().w);
    return borders;
}

}  // namespace

double ArcCurve::Panel::w(double x) const { return is_squared ? end * std::sqrt(x) : begin + x * (end - begin); }

CutSample ArcCurve::Panel::sample(const geodesic::ChebyshevNodes& nodes, double x) const {
    const Eigen::RowVector4d value = nodes.interpolation_row(x) * values;
    return {{value[2], value[3]}, value[1], value[0] + w(x), value[0] - w(x)};
}

BrokenArc::BrokenArc(const Meeting& before, const Meeting& after)
    : core::RunError("the arc can't be followed between directions " + std::to_string(before.theta1()) + " and " +
                     std::to_string(after.theta1())),
      before_(before),
      after_(after) {}

ArcCurve::ArcCurve(GeodesicFlow& flow, const std::vector<Meeting>& meetings, const ArcParameters& parameters)
    : nodes_(parameters.degree) {
    DSC_ASSERT(meetings.size() >= 2);
    for (int degree = 4; degree < parameters.degree; degree *= 2) coarser_.emplace_back(degree);
    Anchors anchors;
    for (const Meeting& meeting : meetings) anchors.emplace(meeting.w, Anchor{meeting});
    anchors.begin()->second.is_exact = anchors.rbegin()->second.is_exact = true;
    const std::vector<double> borders = panel_borders(flow, meetings, parameters.panel_length);
    const double smallest_panel = std::ldexp(1.0, -parameters.max_halvings);
    smallest_j_ = std::numeric_limits<double>::infinity();
    std::optional<GeodesicFlow> fine_flow;  // for the panel next to a conjugate end, once it has missed

    struct Interval {
        double begin, end, fraction;
    };
    std::vector<Interval> pending;  // a stack, the next interval on top
    for (std::size_t i = borders.size() - 1; i > 0; --i) pending.push_back({borders[i - 1], borders[i], 1});
    while (!pending.empty()) {
        const Interval interval = pending.back();
        pending.pop_back();
        const bool is_at_end = interval.begin == 0;
        GeodesicFlow& used = is_at_end && fine_flow ? *fine_flow : flow;
        std::optional<Panel> panel = solve_panel(used, interval.begin, interval.end, parameters.tolerance, anchors);
        const double missed = panel ? miss(flow, *panel, meetings.front().lattice) : 0;
        if (missed > parameters.tolerance && is_at_end && !fine_flow) {
            // Only the arc's two ends stay as they are.
            fine_flow.emplace(flow.metric(), flow.origin(), parameters.fine_step_tolerance);
            for (auto& [w, anchor] : anchors) anchor.is_exact = w == meetings.front().w || w == meetings.back().w;
            pending.push_back(interval);
            continue;
        }
        if (!panel || missed > parameters.tolerance) {
            const double half = interval.fraction / 2, middle = (interval.begin + interval.end) / 2;
            if (half < smallest_panel)
                throw core::RunError("the arc between directions " + std::to_string(meetings.front().theta1()) +
                                     " and " + std::to_string(meetings.back().theta1()) + " does not converge");
            pending.push_back({middle, interval.end, half});
            pending.push_back({interval.begin, middle, half});
            continue;
        }
        panel->offset = length_;
        length_ += panel->arc_length[panel->arc_length.size() - 1];
        sector_area_ += sector_area_of(*panel);
        residual_ = std::max(residual_, missed);
        panels_.push_back(std::move(*panel));
    }
}

const Meeting& ArcCurve::exact_meeting(GeodesicFlow& flow, double w, const std::optional<Vector2>& prediction,
                                       Anchors& anchors) {
    auto after = anchors.lower_bound(w);
    const bool is_known = after->first == w;
    if (is_known && after->second.is_exact) return after->second.meeting;
    const Meeting& next = after->second.meeting;
    const Meeting& previous = is_known ? next : std::prev(after)->second.meeting;
    const Vector2 guess = prediction ? *prediction
                          : is_known ? Vector2(next.middle, next.t)
                                     : predicted(previous, next, w);
    const std::optional<Meeting> solved = geodesic::meet(flow, w, next.lattice, guess[0], guess[1]);
    if (!solved || !(solved->first.j > 0) || !(solved->second.j > 0))
        throw BrokenArc(is_known ? std::prev(after)->second.meeting : previous, next);
    if (!is_known) after = anchors.emplace_hint(after, w, Anchor{});
    after->second = {*solved, true};
    return after->second.meeting;
}

std::optional<ArcCurve::Panel> ArcCurve::solve_panel(GeodesicFlow& flow, double begin, double end, double tolerance,
                                                     Anchors& anchors) {
    const int degree = nodes_.degree();
    Panel panel;
    panel.begin = begin, panel.end = end, panel.is_squared = begin == 0;
    panel.values.resize(degree + 1, 4);
    panel.sectors.resize(degree + 1, 2);
    const auto solve_node = [&](int i, const std::optional<Vector2>& prediction) {
        const double w = i == 0 ? begin : i == degree ? end : panel.w(nodes_.nodes()[i]);
        const Meeting& meeting = exact_meeting(flow, w, prediction, anchors);
        panel.values.row(i) << meeting.middle, meeting.t, meeting.first.x.transpose();
        const double slope = w == 0 ? meeting.first.area_theta : (meeting.first.area - meeting.second.area) / (2 * w);
        panel.sectors.row(i) << meeting.first.area + meeting.second.area, slope;
        if (w != 0) smallest_j_ = std::min({smallest_j_, meeting.first.j, meeting.second.j});
    };
    for (int i = 0; i <= degree; i += degree / 4) solve_node(i, std::nullopt);
    for (const geodesic::ChebyshevNodes& coarse : coarser_) {
        const int stride = degree / coarse.degree();
        Eigen::Matrix<double, Eigen::Dynamic, 4> known(coarse.degree() + 1, 4);
        for (int i = 0; i <= coarse.degree(); ++i) known.row(i) = panel.values.row(i * stride);
        double mistake = 0;
        for (int i = stride / 2; i < degree; i += stride) {
            const Eigen::RowVector4d value = coarse.interpolation_row(nodes_.nodes()[i]) * known;
            solve_node(i, value.head<2>());
            const Vector2 difference = panel.values.row(i).tail<2>() - value.tail<2>();
            mistake = std::max(mistake, flow.metric().tensor(value.tail<2>()).norm(difference));
        }
        // The error falls geometrically with the degree: that of twice the degree is about the square.
        if (std::pow(mistake, degree / coarse.degree()) > tolerance) return std::nullopt;
    }
    const Eigen::Matrix<double, Eigen::Dynamic, 2> slope = nodes_.differentiation() * panel.values.rightCols<2>();
    Eigen::VectorXd speed(degree + 1);
    for (Eigen::Index i = 0; i <= degree; ++i)
        speed[i] = flow.metric().tensor(panel.values.row(i).tail<2>()).norm(slope.row(i));
    panel.arc_length = nodes_.integration() * speed;
    return panel;
}

double ArcCurve::sector_area_of(const Panel& panel) const {
    // ∫ A1 dtheta1 - A2 dtheta2 = ∫ (A1 + A2) + (A1 - A2) dmiddle/dw dw, where the polynomials may be in w².
    const Eigen::VectorXd middle_slope = nodes_.differentiation() * panel.values.col(0);
    const int finer = 2 * nodes_.degree();
    const geodesic::ChebyshevNodes quadrature(finer);
    const double width = panel.end - panel.begin;
    Eigen::VectorXd integrand(finer + 1);
    for (Eigen::Index i = 0; i <= finer; ++i) {
        const double y = quadrature.nodes()[i], w = panel.begin + y * width;
        const double x = panel.is_squared ? y * y : y;
        const double x_w = (panel.is_squared ? 2 * y : 1) / width;
        const Eigen::RowVectorXd row = nodes_.interpolation_row(x);
        const Eigen::RowVector2d sectors = row * panel.sectors;
        integrand[i] = sectors[0] + 2 * w * sectors[1] * (row * middle_slope).value() * x_w;
    }
    return width * quadrature.integration().bottomRows<1>() * integrand;
}

double ArcCurve::miss(GeodesicFlow& flow, const Panel& panel, const geodesic::LatticeVector& lattice) const {
    double largest = 0;
    const Eigen::VectorXd& nodes = nodes_.nodes();
    for (Eigen::Index i : {Eigen::Index{1}, nodes.size() / 2, nodes.size() - 2}) {
        const CutSample sample = panel.sample(nodes_, (nodes[i] + nodes[i - 1]) / 2);
        const geodesic::MetricTensor tensor = flow.metric().tensor(sample.x);
        const Point2 end1 = flow.shoot(sample.theta1, sample.distance).x;
        const Point2 end2 = flow.shoot(sample.theta2, sample.distance).x + flow.metric().periods().translation(lattice);
        largest = std::max({largest, tensor.norm(end1 - sample.x), tensor.norm(end2 - sample.x)});
    }
    return largest;
}

CutSample ArcCurve::at_length(double s) const {
    std::size_t k = panels_.size() - 1;
    while (k > 0 && panels_[k].offset > s) --k;
    const Panel& panel = panels_[k];
    const double target = s - panel.offset;
    double low = 0, high = 1, x = target / panel.arc_length[panel.arc_length.size() - 1];
    const Eigen::VectorXd speed = nodes_.differentiation() * panel.arc_length;
    for (int iteration = 0; iteration < 60; ++iteration) {  // Newton, kept inside a shrinking bracket
        x = std::clamp(x, low, high);
        const Eigen::RowVectorXd row = nodes_.interpolation_row(x);
        const double excess = row * panel.arc_length - target;
        if (std::abs(excess) <= 1e-14 * (1 + length_)) break;
        (excess > 0 ? high : low) = x;
        const double newton = x - excess / (row * speed);
        x = newton > low && newton < high ? newton : (low + high) / 2;
    }
    return panel.sample(nodes_, x);
}

std::vector<CutSample> ArcCurve::samples(int count) const {
    std::vector<CutSample> samples;
    samples.push_back(panels_.front().sample(nodes_, 0));
    for (int i = 1; i < count; ++i) samples.push_back(at_length(length_ * i / count));
    samples.push_back(panels_.back().sample(nodes_, 1));
    return samples;
}

Extremum ArcCurve::extremum(double sign) const {
    // Best node first, then a golden-section search between its neighbours.
    Extremum best{sign * std::numeric_limits<double>::infinity(), {0, 0}};
    const Eigen::VectorXd& nodes = nodes_.nodes();
    for (const Panel& panel : panels_) {
        Eigen::Index i = 0;
        (sign * panel.values.col(1)).minCoeff(&i);
        double low = nodes[std::max<Eigen::Index>(i - 1, 0)], high = nodes[std::min(i + 1, nodes.size() - 1)];
        constexpr double golden = 0.6180339887498949;
        while (high - low > 1e-9) {
            const double a = high - golden * (high - low), b = low + golden * (high - low);
            (sign * panel.sample(nodes_, a).distance < sign * panel.sample(nodes_, b).distance ? high : low) =
                sign * panel.sample(nodes_, a).distance < sign * panel.sample(nodes_, b).distance ? b : a;
        }
        for (double x : {low, high, nodes[i]}) {
            const CutSample sample = panel.sample(nodes_, x);
            if (sign * sample.distance < sign * best.distance) best = {sample.distance, sample.x};
        }
    }
    return best;
}

}  // namespace dsc::cutlocus
