// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/front.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "apps/cutlocus/front_chart.h"
#include "apps/cutlocus/front_geodesics.h"
#include "core/attribute.h"
#include "core/errors.h"
#include "dsc2d/deform/deformer.h"
#include "dsc2d/generate/insert_polygon.h"
#include "dsc2d/generate/structured.h"
#include "geodesic/geodesic_flow.h"

namespace dsc::cutlocus {

using core::HalfedgeId;
using core::VertexId;
using geodesic::GeodesicState;
using geodesic::Metric;
using geodesic::Point2;
using geodesic::Vector2;

namespace {

constexpr int inside = 1;  // label of the disc around p

/// How far the chart is needed where it is not periodic: geodesics of length max_distance, with a margin.
Vector2 needed_reach(const Metric& metric, const Point2& origin, const FrontParameters& parameters) {
    if (metric.periods().is_torus()) return {0, 0};
    if (!parameters.max_distance)
        throw core::UsageError("a chart that is not periodic in both directions needs --max-distance");
    geodesic::GeodesicFlow flow(metric, origin, 1e-6);
    constexpr int directions = 256, stops = 64;
    Vector2 reach(0, 0);
    for (int i = 0; i < directions; ++i) {
        GeodesicState state = flow.start(2 * std::numbers::pi * i / directions);
        for (int k = 0; k < stops; ++k) {
            flow.advance(state, *parameters.max_distance / stops);
            reach = reach.cwiseMax((state.x - origin).cwiseAbs());
        }
    }
    constexpr double margin = 1.25;
    return margin * reach;
}

dsc2d::Complex initial_complex(const FrontChart& chart, double spacing) {
    constexpr double cell = 6;  // sides of the first triangulation's cells, in spacings
    const auto count = [&](int column) {
        constexpr double most = 256;  // where the front needs but a small part of a long period
        const double wanted = chart.domain().basis().col(column).norm() / (cell * spacing);
        return static_cast<int>(std::lround(std::clamp(wanted, 3.0, most)));
    };
    return dsc2d::structured_complex(chart.domain(), count(0), count(1));
}

dsc2d::Parameters complex_parameters(double spacing) {
    dsc2d::Parameters parameters;
    parameters.edge_length = spacing;
    parameters.topology = motion::TopologyPolicy::preserved;
    return parameters;
}

class Front final : private dsc2d::Listener {
public:
    Front(const Metric& metric, const Point2& origin, const FrontParameters& parameters)
        : metric_(metric),
          parameters_(parameters),
          chart_(metric, origin, needed_reach(metric, origin, parameters)),
          complex_(initial_complex(chart_, parameters.spacing)),
          deformer_(complex_, complex_parameters(parameters.spacing), *this),
          geodesics_(parameters.method == FrontMethod::integrated
                         ? integrated_geodesics(complex_, metric, origin, 1e-9)
                         : two_point_geodesics(complex_, metric, origin, 2 * parameters.time_step,
                                               1e-3 * parameters.time_step)),
          has_stopped_(complex_.vertex_attributes(), 0) {
        place_initial_front();
    }

    /// Thesis 5.2.2.
    FrontResult grow(core::Observer& observer) {
        while (has_moving_vertices()) {
            observer.check_cancelled();
            report(observer);
            keep_snapshot();
            refine();
            coarsen();
            radius_ += std::min(parameters_.time_step, remaining_distance());
            advance_and_correct();
            displace();
            lock_converging();
            lock_local_collisions();
            ++result_.steps;
        }
        finish();
        return std::move(result_);
    }

private:
    /// Front vertices in the order of their directions.
    std::vector<VertexId> loop() const {
        std::vector<VertexId> vertices{first_};
        for (HalfedgeId h = front_halfedge(first_); complex_.to(h) != first_; h = front_halfedge(complex_.to(h)))
            vertices.push_back(complex_.to(h));
        return vertices;
    }
    /// The half-edge of the front that leaves v, with the disc on its left.
    HalfedgeId front_halfedge(VertexId v) const {
        for (HalfedgeId h : complex_.outgoing(v))
            if (complex_.is_interface(h) && complex_.label(complex_.face(h)) == inside) return h;
        throw core::RunError("the front is broken at distance " + std::to_string(radius_));
    }

    /// 5.2.4: a small distance circle around p.
    void place_initial_front() {
        const int count = parameters_.initial_vertices;
        radius_ = std::min(parameters_.spacing * count / (2 * std::numbers::pi), 0.5 * remaining_distance());
        std::vector<Point2> polygon;
        // The polygon is needed before its vertices are there to carry geodesics: the frame gives it to first order,
        // and the first displacement corrects it.
        const geodesic::Frame frame(metric_.tensor(chart_.to_chart(Point2(0, 0))));
        for (int i = 0; i < count; ++i) {
            const double theta = 2 * std::numbers::pi * i / count;
            polygon.push_back(radius_ * (chart_.to_domain(chart_.to_chart(Point2(0, 0)) + frame.direction(theta))));
        }
        const std::vector<VertexId> vertices = dsc2d::insert_polygon(complex_, polygon, inside);
        for (VertexId v : vertices) {
            const Vector2 way = chart_.to_chart(complex_.position(v)) - chart_.to_chart(Point2(0, 0));
            const geodesic::MetricTensor tensor = metric_.tensor(chart_.to_chart(Point2(0, 0)));
            geodesics_->start(v, std::atan2(tensor.inner(way, frame.e2), tensor.inner(way, frame.e1)), radius_);
        }
        first_ = vertices.front();
    }

    double remaining_distance() const {
        return parameters_.max_distance ? *parameters_.max_distance - radius_ : std::numeric_limits<double>::infinity();
    }
    bool has_moving_vertices() {
        if (remaining_distance() <= 0) return false;
        front_ = loop();
        return std::any_of(front_.begin(), front_.end(), [&](VertexId v) { return !complex_.is_locked(v); });
    }

    /// New vertices where neighbours have drifted apart on the surface.
    void refine() {
        for (VertexId v : front_) {
            const HalfedgeId h = front_halfedge(v);
            const VertexId next = complex_.to(h);
            if (complex_.is_locked(v) && complex_.is_locked(next)) continue;
            if (distance_on_surface(h) <= parameters_.spacing) continue;
            if (const std::optional<VertexId> middle = deformer_.split_interface_edge(h))
                geodesics_->insert(*middle, v, next, 0.5, radius_);
        }
    }
    /// Fewer vertices where the front shrinks smoothly. Neighbours that are soon to meet stay: they are where a branch
    /// of the cut locus begins.
    void coarsen() {
        const double shortest = parameters_.shortest_edge * parameters_.spacing;
        for (VertexId v : loop()) {
            const HalfedgeId h = front_halfedge(v);
            const VertexId next = complex_.to(h);
            if (complex_.is_locked(v) || complex_.is_locked(next) || next == first_) continue;
            if (complex_.length(h) >= shortest || steps_to_meeting(h) < parameters_.merging_steps) continue;
            if (deformer_.merge_interface_edge(h) && v == first_) first_ = next;
        }
    }
    /// Steps until the geodesics of two neighbours cross, if they go on as in the last one; infinite when they diverge.
    double steps_to_meeting(HalfedgeId h) const {
        constexpr double never = std::numeric_limits<double>::infinity();
        const VertexId v = complex_.from(h), next = complex_.to(h);
        if (std::max(v.index(), next.index()) >= steps_made_.size()) return never;
        const Point2 place = chart_.to_chart(complex_.position(v));
        const Vector2 edge = chart_.to_chart(complex_.position(v) + complex_.vector(h)) - place;
        const geodesic::MetricTensor tensor = metric_.tensor(place);
        const double closing = -tensor.inner(edge, steps_made_[next.index()] - steps_made_[v.index()]);
        return closing > 0 ? tensor.inner(edge, edge) / closing : never;
    }
    double distance_on_surface(HalfedgeId h) const {
        const Point2 begin = chart_.to_chart(complex_.position(complex_.from(h)));
        const Point2 end = chart_.to_chart(complex_.position(complex_.from(h)) + complex_.vector(h));
        return metric_.tensor((begin + end) / 2).norm(end - begin);
    }

    void advance_and_correct() {
        targets_.assign(complex_.vertex_capacity(), std::nullopt);
        steps_made_.assign(complex_.vertex_capacity(), Vector2(0, 0));
        for (VertexId v : loop()) {
            if (complex_.is_locked(v)) continue;
            const Point2 before = geodesics_->state(v).x;
            geodesics_->advance(v, radius_);
            steps_made_[v.index()] = geodesics_->state(v).x - before;
            if (geodesics_->state(v).j <= 0)
                stop(v);  // past its first conjugate point: no longer minimising
            else
                targets_[v.index()] = domain_target(v);
        }
    }
    /// The end of v's geodesic, in the period of v's position.
    Point2 domain_target(VertexId v) const { return chart_.to_domain(geodesics_->state(v).x); }

    void displace() {
        for (int parts = parameters_.motion_parts; parts > 1; --parts) displace_by(1.0 / parts);
        const dsc2d::StepReport report = displace_by(1);
        // A vertex that the complex has held back for so long faces another part of the front.
        const double longest_way = parameters_.longest_lag * parameters_.spacing;
        for (const auto& motion : report.unfinished)
            if (motion.remaining.norm() > longest_way) stop(motion.vertex);
    }

    /// Moves the vertices by this share of the way that is left to their targets.
    dsc2d::StepReport displace_by(double share) {
        next_targets_.assign(complex_.vertex_capacity(), std::nullopt);
        for (std::uint32_t i = 0; i < targets_.size(); ++i) {
            const VertexId v(i);
            if (!targets_[i] || complex_.is_deleted(v)) continue;
            const Point2 place = complex_.position(v);
            next_targets_[i] = share < 1 ? Point2(place + share * (*targets_[i] - place)) : *targets_[i];
        }
        dsc2d::StepReport report = deformer_.step(next_targets_);
        // The complex has locked the vertices of early contacts too.
        for (VertexId v : early_)
            if (!complex_.is_deleted(v) && !has_stopped_[v]) complex_.unlock(v);
        early_.clear();
        return report;
    }

    /// Neighbours whose geodesics will cross within a step, where the front focuses.
    void lock_converging() {
        for (VertexId v : loop()) {
            const HalfedgeId h = front_halfedge(v);
            const VertexId next = complex_.to(h);
            if (complex_.is_locked(v) || complex_.is_locked(next)) continue;
            if (steps_to_meeting(h) > 1) continue;
            stop(v);
            stop(next);
        }
    }

    /// 5.2.2: an edge of the front that is tangent to the geodesics of its ends belongs to a cusp.
    void lock_local_collisions() {
        for (VertexId v : loop()) {
            const HalfedgeId h = front_halfedge(v);
            const VertexId next = complex_.to(h);
            if (complex_.is_locked(v) && complex_.is_locked(next)) continue;
            const Point2 place = chart_.to_chart(complex_.position(v));
            const Vector2 edge = chart_.to_chart(complex_.position(v) + complex_.vector(h)) - place;
            const geodesic::MetricTensor tensor = metric_.tensor(place);
            const auto sine = [&](VertexId end) {
                return tensor.inner(edge, tensor.rotated(geodesics_->state(end).velocity)) / tensor.norm(edge);
            };
            if (complex_.is_locked(v) != complex_.is_locked(next)) continue;  // the edge leads from the cut locus
            if (std::min(sine(v), sine(next)) > parameters_.tangent_sine) continue;
            stop(v);
            stop(next);
        }
    }
    /// Locks a vertex that has not met another part of the front.
    void stop(VertexId v) {
        if (complex_.is_locked(v)) return;
        complex_.lock(v);
        has_stopped_[v] = 1;
        result_.local_stops.push_back({geodesics_->state(v).theta, radius_, chart_.to_chart(complex_.position(v))});
    }

    void on_interface_split(VertexId m, VertexId a, VertexId b, double s) override {
        geodesics_->insert(m, a, b, s, radius_);
    }
    void on_interface_collapse(VertexId removed, VertexId kept) override {
        if (first_ == removed) first_ = kept;
    }
    void on_contact(const dsc2d::Contact& contact) override {
        if (is_early(contact)) {
            early_.insert(early_.end(), {contact.a, contact.b});
            return;
        }
        for (VertexId v : {contact.a, contact.b})
            if (complex_.is_locked(v)) has_stopped_[v] = 1;
        const GeodesicState &a = geodesics_->state(contact.a), &b = geodesics_->state(contact.b);
        // E(a) - E(b) in whole periods; positions may differ from the ends of their geodesics by periods too.
        const auto windings = [&](VertexId v) {
            return chart_.lattice_of(complex_.position(v) - chart_.to_domain(geodesics_->state(v).x));
        };
        const geodesic::LatticeVector between = chart_.lattice_of(chart_.domain().translation(contact.lattice));
        const geodesic::LatticeVector lattice = between + windings(contact.b) - windings(contact.a);
        result_.contacts.push_back({{a.theta, b.theta, (a.t + b.t) / 2, lattice},
                                    chart_.to_chart(complex_.position(contact.a)),
                                    chart_.to_chart(complex_.position(contact.b))});
    }

    /// True if the complex reports two vertices for being close, but their geodesics go on side by side and meet later,
    /// at a small angle, as they do next to a conjugate point.
    bool is_early(const dsc2d::Contact& contact) const {
        if (!parameters_.contact_steps || has_stopped_[contact.a] || has_stopped_[contact.b]) return false;
        const Point2 place = complex_.position(contact.a), origin = chart_.to_chart(place);
        const auto in_chart = [&](const Vector2& way) -> Vector2 { return chart_.to_chart(place + way) - origin; };
        const Vector2 gap = 2 * (contact.place - place);
        const Vector2 lag_a = domain_target(contact.a) - place;
        const Vector2 lag_b = domain_target(contact.b) - complex_.position(contact.b);
        const Vector2 between = in_chart(gap + lag_b - lag_a);  // from end to end of the geodesics
        const geodesic::MetricTensor tensor = metric_.tensor(origin);
        if (tensor.inner(in_chart(gap), between) <= 0) return false;  // they have met
        const Vector2 parting = geodesics_->state(contact.b).velocity - geodesics_->state(contact.a).velocity;
        const double closing = -tensor.inner(between, parting) * parameters_.time_step;
        return tensor.inner(between, between) > *parameters_.contact_steps * closing;
    }

    void report(core::Observer& observer) const {
        const auto locked =
            std::count_if(front_.begin(), front_.end(), [&](VertexId v) { return complex_.is_locked(v); });
        const double share = static_cast<double>(locked) / static_cast<double>(front_.size());
        observer.progress("front", parameters_.max_distance ? radius_ / *parameters_.max_distance : share,
                          "distance " + std::to_string(radius_) + ", " + std::to_string(front_.size()) + " vertices, " +
                              std::to_string(static_cast<int>(100 * share)) + " % stopped");
    }
    /// Evenly spaced in time whatever the number of steps will be: when there are twice as many as wanted, every second
    /// one goes and the interval is doubled.
    void keep_snapshot() {
        if (parameters_.snapshots == 0 || result_.steps % snapshot_interval_ != 0) return;
        FrontSnapshot snapshot{radius_, {}};
        for (VertexId v : front_) snapshot.points.push_back(chart_.to_chart(complex_.position(v)));
        result_.snapshots.push_back(std::move(snapshot));
        if (static_cast<int>(result_.snapshots.size()) < 2 * parameters_.snapshots) return;
        std::vector<FrontSnapshot> kept;
        for (std::size_t i = 0; i < result_.snapshots.size(); i += 2) kept.push_back(std::move(result_.snapshots[i]));
        result_.snapshots = std::move(kept);
        snapshot_interval_ *= 2;
    }
    void finish() {
        front_ = loop();
        keep_snapshot();
        for (VertexId v : front_)
            if (!complex_.is_locked(v)) result_.free_directions.push_back(geodesics_->state(v).theta);
        result_.vertices = front_.size();
        result_.distance = radius_;
    }

    const Metric& metric_;
    FrontParameters parameters_;
    FrontChart chart_;
    dsc2d::Complex complex_;
    dsc2d::Deformer deformer_;
    std::unique_ptr<FrontGeodesics> geodesics_;
    FrontResult result_;
    std::vector<VertexId> front_;
    std::vector<std::optional<Point2>> targets_, next_targets_;
    core::Attribute<VertexId, std::uint8_t> has_stopped_;  // for good
    std::vector<VertexId> early_;                          // vertices of early contacts
    std::vector<Vector2> steps_made_;                      // of the geodesics' ends, in the chart; by vertex
    VertexId first_;
    double radius_ = 0;
    int snapshot_interval_ = 1;
};

}  // namespace

FrontParameters plain_front(double time_step) {
    FrontParameters parameters;
    parameters.method = FrontMethod::two_point;
    parameters.time_step = time_step;
    parameters.spacing = 0.7 * time_step;
    parameters.motion_parts = 3;
    parameters.contact_steps = 1;
    return parameters;
}

FrontResult grow_front(const Metric& metric, const Point2& origin, const FrontParameters& parameters,
                       core::Observer& observer) {
    if (!(parameters.spacing > 0)) throw core::UsageError("the spacing of the front must be positive");
    if (!(parameters.time_step > 0 && parameters.time_step <= 2 * parameters.spacing))
        throw core::UsageError("the time step of the front must be positive and at most twice its spacing");
    if (!(parameters.shortest_edge >= 0 && parameters.shortest_edge < 0.5))
        throw core::UsageError("the shortest edge of the front must lie between 0 and half its spacing");
    if (parameters.motion_parts < 1) throw core::UsageError("the motion of the front must have at least one part");
    if (parameters.contact_steps && !(*parameters.contact_steps >= 0))
        throw core::UsageError("the steps between a contact of the front and its meeting must not be negative");
    if (!(parameters.merging_steps >= 1))
        throw core::UsageError("the steps before a meeting in which the front is not coarsened must be at least 1");
    return Front(metric, origin, parameters).grow(observer);
}

}  // namespace dsc::cutlocus
