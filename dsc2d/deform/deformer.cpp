// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/deform/deformer.h"

#include <algorithm>
#include <string>

#include "core/errors.h"
#include "dsc2d/deform/contacts.h"
#include "dsc2d/deform/degeneracy.h"
#include "dsc2d/improve/detail_control.h"
#include "dsc2d/improve/poor_stars.h"
#include "dsc2d/improve/smoothing.h"
#include "dsc2d/operations/collapse.h"
#include "dsc2d/operations/flip.h"
#include "dsc2d/operations/move_vertex.h"
#include "dsc2d/operations/split.h"
#include "geometry/triangle.h"

namespace dsc::dsc2d {

namespace {

Listener& silent_listener() {
    static Listener listener;  // has no state
    return listener;
}

}  // namespace

// Stands between the passes and the caller's listener: gives vertices that are born in a step their share of motion.
class Deformer::TargetKeeper final : public Listener {
public:
    explicit TargetKeeper(Deformer& deformer) : deformer_(deformer) {}

    /// Vertices that are born after all motion was made have none that could be left over.
    void end_motion() { shares_motion_ = false; }

    void on_interface_split(VertexId m, VertexId a, VertexId b, double s) override {
        const Complex& complex = deformer_.complex_;
        if (shares_motion_ && !complex.is_locked(m) && (deformer_.has_target_[a] || deformer_.has_target_[b])) {
            const Point2 motion = (1.0 - s) * motion_left(a) + s * motion_left(b);
            deformer_.target_[m] = complex.domain().snapped(complex.position(m) + motion);
            deformer_.has_target_[m] = 1;
            deformer_.moving_.push_back(m);
        }
        deformer_.listener_.on_interface_split(m, a, b, s);
    }
    void on_interface_collapse(VertexId removed, VertexId kept) override {
        deformer_.listener_.on_interface_collapse(removed, kept);
    }
    void on_contact(const Contact& contact) override { deformer_.listener_.on_contact(contact); }
    void on_event(const Event& event) override { deformer_.listener_.on_event(event); }

private:
    Point2 motion_left(VertexId v) const {
        if (!deformer_.has_target_[v]) return Point2::Zero();
        return deformer_.target_[v] - deformer_.complex_.position(v);
    }

    Deformer& deformer_;
    bool shares_motion_ = true;
};

Deformer::Deformer(Complex& complex, const Parameters& parameters, Listener& listener)
    : complex_(complex),
      parameters_(parameters),
      listener_(listener),
      delaunay_(complex),
      move_together_(complex),
      active_(complex),
      step_active_(complex),
      target_(complex.vertex_attributes(), Point2(Point2::Zero())),
      has_target_(complex.vertex_attributes(), 0),
      blocked_substeps_(complex.vertex_attributes(), 0) {
    parameters_.validate();
}

Deformer::Deformer(Complex& complex, const Parameters& parameters) : Deformer(complex, parameters, silent_listener()) {}

// Algorithm 4, one time step.
StepReport Deformer::step(std::span<const std::optional<Point2>> targets) {
    StepReport report;
    TargetKeeper keeper(*this);
    PassContext context{complex_, parameters_, active_, keeper, report};
    step_active_.clear();
    set_targets(targets);
    bool is_complete = moving_.empty();
    while (!is_complete && report.substeps < parameters_.max_substeps) {
        is_complete = move_vertices_step(context);
        improve(context);
        ++report.substeps;
    }
    keeper.end_motion();
    finish(context);
    report_unfinished(report);
    forget_handles();
    return report;
}

// Handles change when the complex is compacted between steps.
void Deformer::forget_handles() {
    active_.clear();
    step_active_.clear();
    move_together_.forget();
}

void Deformer::set_targets(std::span<const std::optional<Point2>> targets) {
    moving_.clear();
    if (targets.size() > complex_.vertex_capacity()) throw core::UsageError("step: more targets than vertices");
    for (std::uint32_t i = 0; i < targets.size(); ++i) {
        if (!targets[i]) continue;
        const VertexId v(i);
        if (complex_.is_deleted(v) || complex_.is_boundary(v))
            throw core::UsageError("step: vertex " + std::to_string(i) + " can't have a target: " +
                                   (complex_.is_deleted(v) ? "it is deleted" : "it lies on the domain's boundary"));
        if (!targets[i]->allFinite() || !complex_.domain().is_in_reach(*targets[i]))
            throw core::UsageError("step: the target of vertex " + std::to_string(i) + " is far outside the domain");
        target_[v] = complex_.domain().snapped(*targets[i]);
        has_target_[v] = 1;
        moving_.push_back(v);
    }
}

// Algorithm 5, after those vertices have gone that can go together. True when every vertex that is not locked is at its
// target.
bool Deformer::move_vertices_step(PassContext& context) {
    active_.clear();
    std::erase_if(moving_, [&](VertexId v) { return complex_.is_deleted(v); });
    const auto first_locked =
        std::stable_partition(moving_.begin(), moving_.end(), [&](VertexId v) { return !complex_.is_locked(v); });
    const auto free_count = static_cast<std::size_t>(first_locked - moving_.begin());
    move_together_.run(complex_, std::span(moving_).first(free_count), target_);
    std::size_t left = 0;
    for (std::size_t i = 0; i < moving_.size(); ++i) {
        const VertexId v = moving_[i];
        if (complex_.is_locked(v) || !move_one(context, v)) moving_[left++] = v;
    }
    moving_.resize(left);
    return std::all_of(moving_.begin(), moving_.end(), [&](VertexId v) { return complex_.is_locked(v); });
}

void Deformer::activate_star(PassContext& context, VertexId v) {
    active_.add(v);
    for (const HalfedgeId h : complex_.outgoing(v))
        if (context.is_steiner(complex_.to(h))) active_.add(complex_.to(h));
}

// True when v is at its target.
bool Deformer::move_one(PassContext& context, VertexId v) {
    const double way = (target_[v] - complex_.position(v)).norm();
    MoveResult result = move_vertex(complex_, v, target_[v], {parameters_.approach, parameters_.interface_approach});
    // A fan of faces along the interface opens only one by one: waiting for the Delaunay pass would cost a substep
    // each.
    for (int flips = 0; !result.is_reached && flips < parameters_.flips_on_the_way; ++flips) {
        if (!flip_out_of_the_way(context, v, result.blocking)) break;
        result = move_vertex(complex_, v, target_[v], {parameters_.approach, parameters_.interface_approach});
    }
    activate_star(context, v);
    if (result.is_reached) {
        ++context.report.counts.moves;
        blocked_substeps_[v] = 0;
        has_target_[v] = 0;
        return true;
    }
    ++context.report.counts.blocked_moves;
    if (!complex_.is_interface(v)) return false;
    // One that has all but arrived is not kept from moving.
    const double left = (target_[v] - complex_.position(v)).norm(),
                 limit = context.absolute(parameters_.blocked_motion);
    if (way - left >= limit || left < limit) {
        blocked_substeps_[v] = 0;
    } else if (++blocked_substeps_[v] >= parameters_.blocked_substeps) {
        blocked_substeps_[v] = 0;
        treat_blocked_vertex(context, v, result.blocking);
    }
    return false;
}

// Flips the edge that v, or an edge at v, would run into: face(blocking) turns over on the way of v.
bool Deformer::flip_out_of_the_way(PassContext& context, VertexId v, HalfedgeId blocking) {
    const Point2 way = target_[v] - complex_.position(v);
    const Point2 a = complex_.vector(blocking), b = -complex_.vector(complex_.prev(blocking));
    const double loss = geometry::cross(way, b - a);
    if (loss <= 0.0) return false;
    // Where v would be on the line of the opposite side: between its ends, or beyond one of them.
    const Point2 meeting = geometry::cross(a, b) / loss * way;
    const double s = (meeting - a).dot(b - a) / (b - a).squaredNorm();
    const HalfedgeId edge = s <= 0.0 ? complex_.prev(blocking) : s >= 1.0 ? blocking : complex_.next(blocking);
    if (complex_.is_interface(edge) || !can_flip(complex_, Complex::edge(edge))) return false;
    dsc2d::flip(complex_, Complex::edge(edge));
    ++context.report.counts.flips;
    for (const VertexId end : {complex_.from(edge), complex_.to(edge)}) active_.add(end);
    return true;
}

// Algorithm 4, step 10.
void Deformer::improve(PassContext& context) {
    flip(context);
    remove_degeneracies(context);
    thin_out(context);
    flip(context);
    treat_contacts(context);
    for (const VertexId v : active_.members()) step_active_.add(v);
}

void Deformer::finish(PassContext& context) {
    active_.clear();
    for (const VertexId v : step_active_.members())
        if (!complex_.is_deleted(v)) active_.add(v);
    respace_interface(context);
    // Parts of the interface that have just got other vertices may touch by that.
    if (parameters_.interface_max_edge || parameters_.interface_min_edge) treat_contacts(context);
    split_needles(context);
    for (int sweep = 0; sweep < parameters_.smoothing_sweeps; ++sweep) {
        smooth(context);
        flip(context);
        mend_poor_stars(context);
    }
    flip(context);
}

void Deformer::flip(PassContext& context) {
    touched_.clear();
    context.report.counts.flips += delaunay_.run(complex_, active_.members(), touched_);
    for (const VertexId v : touched_) active_.add(v);
}

void Deformer::report_unfinished(StepReport& report) {
    for (const VertexId v : moving_) {
        if (complex_.is_deleted(v)) continue;
        has_target_[v] = 0;
        report.unfinished.push_back({v, target_[v] - complex_.position(v), complex_.is_locked(v)});
        if (!complex_.is_locked(v)) report.is_complete = false;
    }
    moving_.clear();
}

std::optional<VertexId> Deformer::split_interface_edge(HalfedgeId h, double s) {
    const auto place = can_split_edge(complex_, h, s);
    if (!place) return std::nullopt;
    const VertexId m = split_edge(complex_, h, *place);
    restore_delaunay_at(m);
    return m;
}

bool Deformer::merge_interface_edge(HalfedgeId h) {
    if (!can_collapse(complex_, h, CollapseRule::coarsen_interface)) return false;
    const VertexId kept = complex_.to(h);
    collapse(complex_, h);
    restore_delaunay_at(kept);
    return true;
}

void Deformer::restore_delaunay_at(VertexId v) {
    active_.clear();
    active_.add(v);
    touched_.clear();
    delaunay_.run(complex_, active_.members(), touched_);
    forget_handles();
}

StepReport Deformer::improve_everywhere() {
    StepReport report;
    PassContext context{complex_, parameters_, active_, listener_, report};
    step_active_.clear();
    for (std::uint32_t v = 0; v < complex_.vertex_capacity(); ++v)
        if (!complex_.is_deleted(VertexId(v))) step_active_.add(VertexId(v));
    active_.clear();
    for (const VertexId v : step_active_.members()) active_.add(v);
    flip(context);
    remove_degeneracies(context);
    thin_out(context);
    finish(context);
    forget_handles();
    return report;
}

}  // namespace dsc::dsc2d
