// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/planar/flow.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "apps/flow/planar/held_contacts.h"
#include "apps/flow/run_steps.h"
#include "core/errors.h"
#include "core/stopwatch.h"
#include "dsc2d/deform/deformer.h"
#include "io/number.h"

namespace dsc::flow::planar {

using dsc2d::Complex;
using dsc2d::VertexId;

namespace {

/// Arrays with more deleted elements than this are compacted: when there is no contact, and in any case.
constexpr double much_garbage = 0.3, too_much_garbage = 0.8;
/// The motion in a part of a step is not longer than this [edge_length].
constexpr double motion_share = 0.5;
/// Where the interface may have to be stopped, its vertices don't come nearer to each other than by this in a part:
/// otherwise there would be nothing left of the gap when the contact is found [edge_length].
constexpr double approach_share = 0.1;
/// The interface comes no nearer to the wall of the box [edge_length].
constexpr double room_at_wall = 0.25;
constexpr double most_parts = 1e5;
/// On a torus, vertices further from the domain than this are taken back, likewise [periods].
constexpr double far = 4, too_far = 16;

class EventList final : public dsc2d::Listener {
public:
    void on_event(const dsc2d::Event& event) override { events_.push_back(event); }
    std::vector<dsc2d::Event> taken() { return std::exchange(events_, {}); }

private:
    std::vector<dsc2d::Event> events_;
};

/// The motion that the parts of a step have left over, summed up for each vertex.
class Lags {
public:
    void add(const motion::UnfinishedMotion<2>& motion) {
        auto [at, is_new] = lags_.try_emplace(motion.vertex.index(), motion);
        if (is_new) return;
        at->second.remaining += motion.remaining;
        at->second.is_locked = motion.is_locked;
    }
    bool is_empty() const { return lags_.empty(); }
    void hand_over(const Complex& complex, dsc2d::StepReport& report) const {
        for (const auto& [index, motion] : lags_) {
            if (complex.is_deleted(motion.vertex)) continue;
            report.unfinished.push_back(motion);
            if (!motion.is_locked) report.is_complete = false;
        }
    }

private:
    std::map<std::uint32_t, motion::UnfinishedMotion<2>> lags_;
};

class Run {
public:
    Run(Complex& complex, const dsc2d::Parameters& parameters, const Targets& targets, Snapshots& snapshots,
        const core::Observer& observer, FlowResult& result, Checkpoints* checkpoints)
        : complex_(complex),
          parameters_(parameters),
          targets_(targets),
          snapshots_(snapshots),
          observer_(observer),
          result_(result),
          checkpoints_(checkpoints) {
        if (checkpoints_ && checkpoints_->state()) {
            equip(*checkpoints_->state());
        } else {
            deformer_.emplace(complex_, parameters_, events_);
            unchanged_.emplace(complex_);
            components_.emplace(complex_);
            result_.steps.push_back(step_record(complex_, 0, 0, *unchanged_));
            keep(result_.steps.back());
        }
    }

    // In as many parts as keep the motion of each below a share of the edge length, so that the mesh can follow, and
    // velocities are looked up on the way. Throws core::RunError when there are no targets, core::Cancelled when the
    // observer asks for an end; what was made of the step before is recorded.
    void take_step() {
        const double start = result_.time.time(result_.steps.back().step);
        const double end = result_.time.time(result_.steps.back().step + 1);
        made_ = {};
        core::Stopwatch watch;
        if (checkpoints_ && checkpoints_->is_due(result_.steps.back().step)) {
            renew();
            made_.checkpoint_ms = 1e3 * watch.seconds();
        }
        watch = {};
        prepare();
        const std::vector<std::optional<Point2>> wanted = targets_at(start, end - start);
        const double needed = std::ceil(parts_of(wanted));
        if (!(needed <= most_parts))
            throw core::RunError(
                fmt::format("the step at time {} is more than {:g} parts of half an edge length; take "
                            "smaller steps",
                            io::number_text(start, 6), most_parts));
        const int parts = static_cast<int>(needed);
        const double dt = (end - start) / parts;
        made_.targets_ms = 1e3 * watch.seconds();
        for (int part = 0; part < parts; ++part) {
            try {
                take_part(parts > 1 ? nullptr : &wanted, start + part * dt, dt);
            } catch (...) {
                if (part > 0) record(start + part * dt);
                throw;
            }
        }
        record(end);
    }

    void save() {
        if (checkpoints_) checkpoints_->save(history());
    }

    void keep(const StepRecord& record) { snapshots_.add(complex_, record.step, record.time); }
    bool is_empty(const StepRecord& record) const { return record.interface_edges == 0; }
    std::string describe(const StepRecord& record) const {
        return fmt::format("step {}, {} triangles, smallest angle {:.1f}", record.step, record.triangles,
                           record.min_angle);
    }

private:
    /// What the parts of the present step have made.
    struct Made {
        dsc2d::StepReport report;
        Lags lags;
        std::optional<double> checkpoint_ms;
        double targets_ms = 0, deform_ms = 0;
    };

    Checkpoints::History history() const { return {result_.steps, result_.events, snapshots_.frames()}; }

    RunState state() const {
        return {.step = result_.steps.back().step,
                .seconds = result_.seconds + watch_.seconds(),
                .domain = result_.domain,
                .edges = {.edge_length = parameters_.edge_length,
                          .shortest = *parameters_.interface_min_edge,
                          .longest = *parameters_.interface_max_edge},
                .complex = complex_.arrays(),
                .unchanged = unchanged_->state(),
                .contacts = contacts_.contacts()};
    }

    // The complex and all that looks at it from what a checkpoint holds, as a run that goes on from it has them.
    void renew() {
        checkpoints_->take(state(), history());
        deformer_.reset();
        unchanged_.reset();
        components_.reset();
        complex_ = Complex(complex_.domain(), checkpoints_->state()->complex);
        equip(*checkpoints_->state());
    }

    void equip(const RunState& state) {
        deformer_.emplace(complex_, parameters_, events_);
        unchanged_.emplace(complex_, state.unchanged);
        components_.emplace(complex_);
        contacts_ = HeldContacts(state.contacts);
    }

    // Towards the targets given, if there are any.
    void take_part(const std::vector<std::optional<Point2>>* given, double time, double dt) {
        observer_.check_cancelled();
        core::Stopwatch watch;
        if (given == nullptr) prepare();
        const std::vector<std::optional<Point2>> wanted = given != nullptr ? *given : targets_at(time, dt);
        require_reach(wanted, time);
        contacts_.release(complex_, wanted);
        made_.targets_ms += 1e3 * watch.seconds();
        watch = {};
        const dsc2d::StepReport report = deformer_->step(wanted);
        made_.deform_ms += 1e3 * watch.seconds();
        contacts_.add(complex_, report.contacts);
        made_.report.counts += report.counts;
        made_.report.substeps += report.substeps;
        for (const auto& motion : report.unfinished) made_.lags.add(motion);
    }

    void record(double time) {
        const core::Stopwatch watch;
        const int step = result_.steps.back().step + 1;
        StepRecord record = step_record(complex_, step, time, *unchanged_);
        made_.lags.hand_over(complex_, made_.report);
        add_step(record, complex_, made_.report);
        add_events(step, time);
        if (made_.checkpoint_ms) record.milliseconds.emplace_back("checkpoint", *made_.checkpoint_ms);
        record.milliseconds.emplace_back("targets", made_.targets_ms);
        record.milliseconds.emplace_back("deform", made_.deform_ms);
        record.milliseconds.emplace_back("measure", 1e3 * watch.seconds());
        result_.steps.push_back(std::move(record));
    }

    // Contacts are known by the numbers and periods of their vertices: they are let go, to be found again, where that
    // can't be put off. So is motion that is left over, until the end of the step.
    void prepare() {
        tidy();
        stay_in_reach();
    }

    void tidy() {
        if (!made_.lags.is_empty()) return;
        const double garbage = complex_.garbage_fraction();
        if (garbage > too_much_garbage) contacts_.release_all(complex_);
        if (garbage > much_garbage && contacts_.is_empty()) complex_.compact();
    }

    void stay_in_reach() {
        const double periods = largest_period();
        if (periods > too_far) contacts_.release_all(complex_);
        if (periods > far && contacts_.is_empty()) take_back();
    }

    Point2 periods(VertexId v) const {
        return complex_.domain().basis().inverse() * (complex_.position(v) - complex_.domain().origin());
    }

    double largest_period() const {
        double largest = 0;
        for (std::uint32_t i = 0; result_.is_torus && i < complex_.vertex_capacity(); ++i)
            if (!complex_.is_deleted(VertexId(i)))
                largest = std::max(largest, periods(VertexId(i)).cwiseAbs().maxCoeff());
        return largest;
    }

    void take_back() {
        for (std::uint32_t i = 0; i < complex_.vertex_capacity(); ++i) {
            if (complex_.is_deleted(VertexId(i))) continue;
            complex_.reanchor(VertexId(i), -periods(VertexId(i)).array().floor().cast<int>().matrix());
        }
    }

    std::vector<std::optional<Point2>> targets_at(double time, double dt) const {
        std::vector<std::optional<Point2>> wanted = targets_(complex_, time, dt);
        require_places(wanted, time);
        return wanted;
    }

    double parts_of(const std::vector<std::optional<Point2>>& wanted) const {
        const auto motion = [&](VertexId v) {
            return wanted[v.index()] ? Point2(*wanted[v.index()] - complex_.position(v)) : Point2(Point2::Zero());
        };
        double parts = 1;
        for (std::uint32_t i = 0; i < wanted.size(); ++i)
            if (wanted[i])
                parts = std::max(parts, motion(VertexId(i)).norm() / (motion_share * parameters_.edge_length));
        if (parameters_.topology != motion::TopologyPolicy::adaptive) {
            for (std::uint32_t i = 0; i < complex_.edge_capacity(); ++i) {
                if (complex_.is_deleted(core::EdgeId(i))) continue;
                const core::HalfedgeId h = Complex::halfedge(core::EdgeId(i));
                const VertexId a = complex_.from(h), b = complex_.to(h);
                if (!complex_.is_interface(a) || !complex_.is_interface(b)) continue;
                const Point2 gap = complex_.vector(h);
                const double length = gap.norm(), approach = -(motion(b) - motion(a)).dot(gap) / length;
                if (length < parameters_.edge_length)
                    parts = std::max(parts, approach / (approach_share * parameters_.edge_length));
            }
        }
        return parts;
    }

    void require_places(const std::vector<std::optional<Point2>>& wanted, double time) const {
        for (std::uint32_t i = 0; i < wanted.size(); ++i) {
            if (!wanted[i]) continue;
            const Point2& p = complex_.position(VertexId(i));
            const bool is_finite = wanted[i]->allFinite();
            if (is_finite && (result_.is_torus || has_room(p, *wanted[i]))) continue;
            refuse(VertexId(i), is_finite ? "leads out of the box" : "is not finite", time);
        }
    }

    void require_reach(const std::vector<std::optional<Point2>>& wanted, double time) const {
        for (std::uint32_t i = 0; i < wanted.size(); ++i)
            if (wanted[i] && !complex_.domain().is_in_reach(*wanted[i]))
                refuse(VertexId(i), "leads through too many periods in one step", time);
    }

    [[noreturn]] void refuse(VertexId v, const char* problem, double time) const {
        const Point2& p = complex_.position(v);
        throw core::RunError(fmt::format("the motion of vertex {} at ({:.6g}, {:.6g}) {} at time {}", v.index(), p.x(),
                                         p.y(), problem, io::number_text(time, 6)));
    }

    // Between the interface and the wall of the box, there has to be room for the mesh.
    bool has_room(const Point2& from, const Point2& to) const {
        const auto distance = [&](const Point2& p) {
            return std::min((p - result_.domain.min()).minCoeff(), (result_.domain.max() - p).minCoeff());
        };
        return distance(to) >= std::min(room_at_wall * parameters_.edge_length, distance(from));
    }

    void add_events(int step, double time) {
        const auto add = [&](const char* kind, const Point2& place, int label) {
            result_.events.push_back({.kind = kind, .step = step, .time = time, .place = place, .label = label});
        };
        for (const dsc2d::Event& event : events_.taken()) {
            const bool is_contact = event.kind == motion::EventKind::contact;
            add(is_contact                                    ? "contact"
                : event.label == parameters_.background_label ? "merge"
                                                              : "split",
                event.place, event.label);
        }
        for (const auto& [label, centroid] : components_->update(complex_)) add("vanish", centroid, label);
    }

    Complex& complex_;
    dsc2d::Parameters parameters_;
    const Targets& targets_;
    Snapshots& snapshots_;
    const core::Observer& observer_;
    FlowResult& result_;
    Checkpoints* checkpoints_;
    core::Stopwatch watch_;
    EventList events_;
    std::optional<dsc2d::Deformer> deformer_;
    HeldContacts contacts_;
    std::optional<UnchangedEdges> unchanged_;
    std::optional<ComponentTracker> components_;
    Made made_;
};

}  // namespace

void run_flow(Complex& complex, const dsc2d::Parameters& parameters, const Targets& targets, Snapshots& snapshots,
              core::Observer& observer, FlowResult& result, Checkpoints* checkpoints) {
    Run run(complex, parameters, targets, snapshots, observer, result, checkpoints);
    run_steps(result, run, observer);
    run.save();
    snapshots.add_last(complex, result.steps.back().step, result.steps.back().time);
}

}  // namespace dsc::flow::planar
