// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/deformer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/assert.h"
#include "core/errors.h"
#include "dsc3d/deform/move_to_link.h"

namespace dsc::dsc3d {

namespace {

const DeformParameters& validated(const DeformParameters& parameters) {
    parameters.validate();
    return parameters;
}

Listener& silent_listener() {
    static Listener listener;  // has no state
    return listener;
}

}  // namespace

Deformer::Deformer(Mesh& mesh, const DeformParameters& parameters, Listener& listener, Walls walls)
    : mesh_(mesh),
      parameters_(validated(parameters)),
      listener_(listener),
      rated_(mesh, geometry::QualityMeasure::minimum_sine, FlatSurface::flat_boundary(mesh, std::move(walls))),
      wanted_length_(mesh, parameters.edge_length, parameters.growth),
      advance_(mesh),
      upkeep_(rated_, parameters.seed),
      contacts_(mesh),
      interface_control_(mesh),
      start_(mesh.complex().vertex_attributes(), Point3(Point3::Zero())),
      goal_(mesh.complex().vertex_attributes(), Point3(Point3::Zero())),
      wanted_(mesh.complex().vertex_attributes(), Point3(Point3::Zero())),
      slip_(mesh.complex().vertex_attributes(), Point3(Point3::Zero())),
      off_(mesh.complex().vertex_attributes(), Point3(Point3::Zero())),
      pull_(mesh.complex().vertex_attributes(), Point3(Point3::Zero())),
      target_(mesh.complex().vertex_attributes(), Point3(Point3::Zero())),
      way_(mesh.complex().vertex_attributes(), Point3(Point3::Zero())),
      is_moving_(mesh.complex().vertex_attributes(), 0) {
    StepReport report;
    interface_control_.accept(context(report));
}

Deformer::Deformer(Mesh& mesh, const DeformParameters& parameters) : Deformer(mesh, parameters, silent_listener()) {}

PassContext Deformer::context(StepReport& report) {
    return {rated_, parameters_, wanted_length_, way_, pull_, region_, listener_, report};
}

void Deformer::set_edge_lengths(std::span<const std::optional<double>> lengths) {
    if (lengths.size() > mesh_.complex().vertex_capacity()) throw core::UsageError("edge lengths: more than vertices");
    for (std::uint32_t i = 0; i < lengths.size(); ++i) {
        const VertexId v(i);
        if (!lengths[i] || mesh_.complex().is_deleted(v) || !mesh_.complex().is_interface(v)) continue;
        if (!(*lengths[i] > 0) || !std::isfinite(*lengths[i]))
            throw core::UsageError("edge lengths: that of vertex " + std::to_string(i) + " is not positive");
        wanted_length_.set(v, *lengths[i]);
    }
}

std::vector<double> Deformer::edge_lengths() const {
    std::vector<double> lengths;
    lengths.reserve(mesh_.complex().vertex_count());
    for (std::uint32_t i = 0; i < mesh_.complex().vertex_capacity(); ++i)
        if (!mesh_.complex().is_deleted(VertexId(i))) lengths.push_back(wanted_length_.at(VertexId(i)));
    return lengths;
}

void Deformer::restore_edge_lengths(std::span<const double> lengths) {
    DSC_ASSERT(lengths.size() == mesh_.complex().vertex_capacity());
    for (std::uint32_t i = 0; i < lengths.size(); ++i) wanted_length_.set(VertexId(i), lengths[i]);
    StepReport report;
    interface_control_.accept(context(report));
}

StepReport Deformer::step(std::span<const std::optional<Point3>> targets) { return step(targets, nullptr); }

// Algorithm 4, one time step, in substeps whose number follows from the length of the way.
StepReport Deformer::step(std::span<const std::optional<Point3>> targets, const Path& path) {
    StepReport report;
    set_targets(targets);
    release_resting_ones(path);
    contacts_.begin_step();
    PassContext context = this->context(report);
    const int wanted = moving_.empty() ? 0 : wanted_substeps(path);
    double share = 0;
    for (int substep = 0; substep < wanted; ++substep) {
        const double end = (substep + 1.0) / wanted;
        while (share < end && !moving_.empty()) {
            share = followed_share(share, end, path);
            aim(share, path);
            take_substep(context, substep, wanted);
            wait_for_late_ones(context, substep, wanted);
        }
    }
    open_leftovers(context);
    report_unfinished(context);
    if (report.substeps > 0) finish(context);
    return report;
}

void Deformer::take_substep(PassContext& context, int substep, int wanted) {
    listener_.on_substep(substep, wanted);
    move_vertices_step(context.report);
    maintain(context);
    treat_contacts(context, context.report.substeps, parameters_.contact_distance);
    ++context.report.substeps;
}

// Further substeps of those vertices only that have not come to their targets in this one, until that moves them no
// more: otherwise what comes behind would run into what is held up, and squeeze it.
void Deformer::wait_for_late_ones(PassContext& context, int substep, int wanted) {
    const std::vector<TetId> others(region_.tets().begin(), region_.tets().end());
    const int most = context.report.substeps + parameters_.max_substeps;
    std::vector<VertexId> arrived;
    for (int stalls = 0; stalls < parameters_.max_stalls && context.report.substeps < most;) {
        std::erase_if(moving_, [&](VertexId v) {
            way_[v] = target_[v] - mesh_.position(v);
            if (mesh_.position(v) != target_[v]) return false;
            arrived.push_back(v);
            return true;
        });
        if (moving_.empty()) break;
        region_.clear();
        const double before = way_left();
        take_substep(context, substep, wanted);
        if (way_left() <= parameters_.stalling_share * before) continue;
        ++stalls;
        // What holds them up may be a part of the interface that is not that near yet.
        treat_contacts(context, context.report.substeps, parameters_.gap_width);
        if (parameters_.improves_quality) upkeep_.rescue(context);
    }
    for (const VertexId v : arrived)
        if (is_moving_[v] != 0) moving_.push_back(v);
    region_.add(others);
    region_.settle(mesh_.complex());
}

// What has no way to go is not looked at, so that it stays as it is to the last bit, and what is around it too.
// What is only wanted off its wall has a way too: along it, as its sheets take it.
void Deformer::release_resting_ones(const Path& path) {
    std::erase_if(moving_, [&](VertexId v) {
        if (length_of_way(v, path) != 0 || wanted_[v] != mesh_.position(v)) return false;
        release(v);
        return true;
    });
}

void Deformer::release(VertexId v) {
    is_moving_[v] = 0;
    way_[v].setZero();
    pull_[v].setZero();
}

// Once in a step: the interface as a surface, and what hill climbing has left bad.
void Deformer::finish(PassContext& context) {
    std::vector<TetId> bad;
    for (const TetId t : region_.tets())
        if (rated_.quality(t) < parameters_.bad_quality) bad.push_back(t);
    if (parameters_.controls_interface) {
        rim_control_.run(context, interface_control_.changed_edges(context));
        interface_control_.run(context);
        maintain(context);
        region_.add(bad);
        region_.settle(mesh_.complex());
    }
    if (parameters_.improves_quality) upkeep_.rescue(context);
}

void Deformer::set_targets(std::span<const std::optional<Point3>> targets) {
    const Complex& complex = mesh_.complex();
    if (targets.size() > complex.vertex_capacity()) throw core::UsageError("step: more targets than vertices");
    region_.clear();
    for (const VertexId v : moving_) release(v);  // of a step that was ended
    moving_.clear();
    stopped_.clear();
    held_at_wall_.clear();
    for (std::uint32_t i = 0; i < targets.size(); ++i) {
        if (!targets[i]) continue;
        const VertexId v(i);
        const auto refuse = [&](const char* why) {
            throw core::UsageError("step: vertex " + std::to_string(i) + " can't have a target: " + why);
        };
        if (complex.is_deleted(v)) refuse("it is deleted");
        if (!complex.is_interface(v)) refuse("it lies off the interface");
        if (!targets[i]->allFinite()) refuse("it is not finite");
        start_[v] = mesh_.position(v);
        goal_[v] = at_wall(v, *targets[i]);
        wanted_[v] = *targets[i];
        slip_[v].setZero();
        off_[v].setZero();
        if (goal_[v] == mesh_.position(v) && goal_[v] != *targets[i]) held_at_wall_.emplace_back(v, *targets[i]);
        moving_.push_back(v);
    }
    for (const VertexId v : moving_) is_moving_[v] = 1;
}

int Deformer::wanted_substeps(const Path& path) const {
    double longest = 1;
    for (const VertexId v : moving_)
        longest = std::max(longest, length_of_way(v, path) / (parameters_.stride * wanted_length_.at(v)));
    if (longest > parameters_.most_substeps)
        throw core::RunError("a step is too long: it would take more than " +
                             std::to_string(parameters_.most_substeps) + " substeps; take shorter ones");
    return static_cast<int>(std::ceil(longest * (1 - 1e-9)));
}

double Deformer::length_of_way(VertexId v, const Path& path) const {
    if (!path) return (goal_[v] - start_[v]).norm();
    // Chords of a path that is smooth: one that comes back to its start has a length too.
    constexpr int chords = 4;
    double length = 0;
    Point3 last = start_[v];
    for (int i = 1; i <= chords; ++i) {
        const Point3 next = i == chords ? goal_[v] : at_wall(v, path(start_[v], static_cast<double>(i) / chords));
        length += (next - last).norm();
        last = next;
    }
    return length;
}

// Of all vertices together, to the targets of the substep.
double Deformer::way_left() const {
    double sum = 0;
    for (const VertexId v : moving_) sum += (target_[v] - mesh_.position(v)).norm();
    return sum;
}

// The target of every moving vertex after this share of the step.
void Deformer::aim(double share, const Path& path) {
    for (const VertexId v : moving_) {
        if (mesh_.complex().is_boundary(v)) aim_at_wall(v, share, path);
        target_[v] = share == 1 ? goal_[v] : at_wall(v, wanted_place(v, share, path) + slip_[v]);
        way_[v] = target_[v] - mesh_.position(v);
    }
}

// Where v would be without walls.
Point3 Deformer::wanted_place(VertexId v, double share, const Path& path) const {
    const Point3& end = mesh_.complex().is_boundary(v) ? wanted_[v] : goal_[v];
    if (share == 1) return end;
    return path ? path(start_[v], share) : Point3(start_[v] + share * (end - start_[v]));
}

// How far, from `share` towards `end`, contact lines can follow: where a region leaves a wall they are faster than what
// moves them, and what they lag behind by would be drawn out of the wall.
double Deformer::followed_share(double share, double end, const Path& path) {
    double longest = 1;
    for (const VertexId v : moving_) {
        if (!mesh_.complex().is_boundary(v)) continue;
        const Eigen::Vector3d slip = contact_line_slip(rated_, v, way_off_wall(v, end, path) - off_[v], ring_);
        longest = std::max(longest, slip.norm() / (parameters_.stride * wanted_length_.at(v)));
    }
    const double parts = std::min(std::ceil(longest), static_cast<double>(parameters_.most_line_substeps));
    return parts == 1 ? end : share + (end - share) / parts;
}

// Of where v would be after this share of the step, without walls.
Eigen::Vector3d Deformer::way_off_wall(VertexId v, double share, const Path& path) const {
    const Point3 wanted = wanted_place(v, share, path);
    return wanted - at_wall(v, wanted);
}

// What leads off the wall in this substep makes the contact line slip.
void Deformer::aim_at_wall(VertexId v, double share, const Path& path) {
    const Eigen::Vector3d off = way_off_wall(v, share, path);
    pull_[v] = off - off_[v];
    Eigen::Vector3d slip = contact_line_slip(rated_, v, pull_[v], ring_);
    const double longest = parameters_.stride * wanted_length_.at(v);
    if (slip.norm() > longest) slip *= longest / slip.norm();
    off_[v] = off;
    slip_[v] += slip;
    goal_[v] = at_wall(v, wanted_[v] + slip_[v]);
}

// Algorithm 5, after those vertices have gone that can go together.
void Deformer::move_vertices_step(StepReport& report) {
    advance_.run(rated_, moving_, target_,
                 {.least_quality = parameters_.stopping_quality, .carried_rings = parameters_.carried_rings});
    region_.add(advance_.region());
    for (const VertexId v : moving_) {
        const bool has_arrived =
            mesh_.position(v) == target_[v] ||
            move_to_link(rated_, v, target_[v],
                         {.least_quality = parameters_.stopping_quality, .approach = parameters_.approach});
        report.counts.moves += has_arrived ? 1 : 0;
        report.counts.blocked_moves += has_arrived ? 0 : 1;
    }
    region_.settle(mesh_.complex());
}

// Algorithm 4, step 10.
void Deformer::maintain(PassContext& context) {
    DetailControl::update_lengths(context);
    if (parameters_.controls_detail) detail_.split_long_edges(context);
    if (parameters_.improves_quality) upkeep_.run(context);
    if (parameters_.controls_detail) detail_.collapse_short_edges(context);
}

void Deformer::treat_contacts(PassContext& context, int substep, double distance) {
    std::vector<TetId> others;
    while (contacts_.run(context, substep, distance)) {
        others.insert(others.end(), region_.tets().begin(), region_.tets().end());
        end_motion_at_contacts(context);
    }
    region_.add(others);
    region_.settle(mesh_.complex());
    std::erase_if(moving_, [&](VertexId v) { return is_moving_[v] == 0; });
}

// At the end of the step, when no more contacts come.
void Deformer::open_leftovers(PassContext& context) {
    if (!contacts_.open_leftovers(context)) return;
    const std::vector<TetId> others(region_.tets().begin(), region_.tets().end());
    end_motion_at_contacts(context);
    region_.add(others);
    region_.settle(mesh_.complex());
    std::erase_if(moving_, [&](VertexId v) { return is_moving_[v] == 0; });
}

// What has changed its label has changed what moves: those vertices end their motion for this step. Afterwards the
// region is their surroundings.
void Deformer::end_motion_at_contacts(PassContext& context) {
    region_.clear();
    for (const VertexId v : contacts_.touched()) {
        region_.add_star(rated_, v);
        if (is_moving_[v] == 0) continue;
        release(v);
        stopped_.push_back(v);
    }
    region_.settle(mesh_.complex());
    maintain(context);
}

void Deformer::report_unfinished(PassContext& context) {
    StepReport& report = context.report;
    for (const VertexId v : stopped_)
        if (mesh_.complex().is_interface(v) && mesh_.position(v) != goal_[v])
            report.unfinished.push_back({v, goal_[v] - mesh_.position(v), true});
    for (const VertexId v : moving_) {
        if (mesh_.position(v) == goal_[v]) continue;
        const bool is_locked = is_held(context, v);
        report.unfinished.push_back({v, goal_[v] - mesh_.position(v), is_locked});
        report.is_complete = report.is_complete && is_locked;
    }
    for (const auto& [v, target] : held_at_wall_)
        if (mesh_.complex().is_interface(v) && goal_[v] == start_[v])
            report.unfinished.push_back({v, target - mesh_.position(v), true});
    Contacts::report_held(context);
    for (const VertexId v : moving_) release(v);
    moving_.clear();
}

// By another part of the interface in front of it.
bool Deformer::is_held(PassContext& context, VertexId v) {
    const std::span<const TetId> found = rated_.walker().star(v);
    const std::vector<TetId> star(found.begin(), found.end());  // looking at its tetrahedra walks other stars
    return std::any_of(star.begin(), star.end(),
                       [&](TetId t) { return facing_sheets(context, t, parameters_.gap_width).has_value(); });
}

void Deformer::take_whole_mesh() {
    std::vector<TetId> all;
    for (std::uint32_t i = 0; i < mesh_.complex().tet_capacity(); ++i)
        if (!mesh_.complex().is_deleted(TetId(i))) all.push_back(TetId(i));
    region_.assign(all);
}

StepReport Deformer::coarsen_everywhere() {
    // Level by level, with room to recover in between: short edges beside long ones make what can't be collapsed.
    constexpr double level = 1.3;
    // As coarse as can be without being halved again: what stays too fine costs time in every step.
    const double relative_length = 0.5 * parameters_.max_edge;
    StepReport report;
    PassContext context = this->context(report);
    take_whole_mesh();
    double longest = 0;
    for (std::uint32_t i = 0; i < mesh_.complex().vertex_capacity(); ++i)
        if (!mesh_.complex().is_deleted(VertexId(i))) longest = std::max(longest, wanted_length_.at(VertexId(i)));
    DetailControl::update_lengths(context);
    for (double length = parameters_.edge_length; length < longest; length *= level) {
        detail_.collapse_edges(context, relative_length, length);
        upkeep_.smooth(context);
    }
    // Until it gets hardly coarser: what has been in the way has been smoothed or collapsed itself.
    constexpr double enough = 0.98;
    for (double count = std::numeric_limits<double>::infinity();
         static_cast<double>(mesh_.complex().tet_count()) < enough * count;) {
        count = static_cast<double>(mesh_.complex().tet_count());
        upkeep_.run(context);
        detail_.collapse_edges(context, relative_length, longest);
        upkeep_.smooth(context);
    }
    upkeep_.run(context);
    return report;
}

StepReport Deformer::improve_everywhere() {
    StepReport report;
    take_whole_mesh();
    interface_control_.reconsider();
    PassContext context = this->context(report);
    maintain(context);
    finish(context);
    return report;
}

}  // namespace dsc::dsc3d
