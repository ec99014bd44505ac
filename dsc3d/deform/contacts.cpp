// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/contacts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>
#include <map>

#include "core/sort_unique.h"

namespace dsc::dsc3d {

namespace {

// What t and its faces add to V - E + F of the interface.
int interface_characteristic(const Complex& complex, TetId t) {
    int sum = 0;
    for (const VertexId v : complex.vertices(t)) sum += complex.is_interface(v) ? 1 : 0;
    for (const EdgeId e : complex.edges(t)) sum -= complex.is_interface(e) ? 1 : 0;
    for (const FaceId f : complex.faces(t)) sum += complex.is_interface(f) ? 1 : 0;
    return sum;
}

double area(const PassContext& context, FaceId f) {
    const FaceVertices v = context.complex().vertices(f);
    const Point3& a = context.mesh.position(v[0]);
    return 0.5 * (context.mesh.position(v[1]) - a).cross(context.mesh.position(v[2]) - a).norm();
}

}  // namespace

Contacts::Contacts(const Mesh& mesh) : claim_(mesh.complex().vertex_attributes(), Claim()) {}

bool Contacts::run(PassContext& context, int substep, double distance) {
    const Complex& complex = context.complex();
    touched_.clear();
    seeds_.clear();
    for (const TetId t : context.region.tets()) {
        if (complex.is_deleted(t) || !may_give_way(context, t)) continue;
        const auto facing = facing_sheets(context, t, distance);
        if (facing && is_closing(context, *facing)) seeds_.emplace_back(t, complex.label(t));
    }
    for (const auto& [seed, label] : seeds_)
        if (complex.label(seed) == label && may_give_way(context, seed)) close_gap(context, seed, substep);
    for (const TetId t : context.region.tets())
        if (!complex.is_deleted(t) && may_give_way(context, t)) lift_foot(context, t, substep);
    core::sort_unique(touched_);
    touched_in_step_.insert(touched_in_step_.end(), touched_.begin(), touched_.end());
    return !touched_.empty();
}

bool Contacts::open_leftovers(PassContext& context) {
    const Complex& complex = context.complex();
    core::sort_unique(touched_in_step_);
    ++step_;
    touched_.clear();
    for (const VertexId v : touched_in_step_) {
        if (complex.is_deleted(v)) continue;
        std::vector<int> labels;
        for (const TetId t : context.mesh.walker().star(v)) labels.push_back(complex.label(t));
        core::sort_unique(labels);
        // What has won there last goes on winning, if that opens the pinch.
        const int last = claim_[v].winner;
        std::stable_partition(labels.begin(), labels.end(), [&](int label) { return label == last; });
        for (const int winner : labels)
            for (const int loser : labels)
                if (winner != loser) open_pinches_at(context, v, winner, loser);
    }
    core::sort_unique(touched_);
    return !touched_.empty();
}

// The policy lets its region be squeezed, and the region has not won there in this step.
bool Contacts::may_give_way(const PassContext& context, TetId t) const {
    const Complex& complex = context.complex();
    const int label = complex.label(t);
    if (!motion::allows_change(context.parameters.topology, label, context.parameters.background_label)) return false;
    const TetVertices& corners = complex.vertices(t);
    return std::none_of(corners.begin(), corners.end(),
                        [&](VertexId v) { return claim_[v].step == step_ && claim_[v].winner == label; });
}

void Contacts::close_gap(PassContext& context, TetId seed, int substep) {
    gather_gap(context, seed);
    give_way(context, seed, substep);
}

// The foot of its region that t has a face of, if it has.
void Contacts::lift_foot(PassContext& context, TetId t, int substep) {
    const Complex& complex = context.complex();
    const auto is_foot = [&](FaceId f) {
        if (!complex.is_boundary(f)) return false;
        const FaceVertices corners = complex.vertices(f);
        return std::any_of(corners.begin(), corners.end(), [&](VertexId v) { return complex.is_interface(v); }) &&
               foot_.find(context, f);
    };
    const std::array<FaceId, 4> faces = complex.faces(t);
    if (std::none_of(faces.begin(), faces.end(), is_foot)) return;
    gap_.assign(foot_.tets().begin(), foot_.tets().end());
    if (std::all_of(gap_.begin(), gap_.end(), [&](TetId s) { return may_give_way(context, s); }))
        give_way(context, t, substep);
}

// The gap goes to the region around it.
void Contacts::give_way(PassContext& context, TetId seed, int substep) {
    const int loser = context.complex().label(seed);
    const std::optional<int> found = winner(context);
    if (!found) return;
    const int winner = *found;
    const std::size_t first_touched = touched_.size();
    characteristic_change_ = 0;
    for (const TetId t : gap_) give(context, t, winner);
    fill_notches(context, first_touched, winner, loser);
    open_pinches(context, first_touched, winner, loser);
    absorb_crumbs(context, loser);
    if (characteristic_change_ == 0) return;
    context.listener.on_event({motion::EventKind::topology_change, context.centroid(seed), substep, loser});
    ++context.report.counts.topology_changes;
}

// What lies between vertices that have been won, and has two sides or more on the winner, is a ragged rim of the gap,
// or a hole in it.
void Contacts::fill_notches(PassContext& context, std::size_t first_touched, int winner, int loser) {
    const Complex& complex = context.complex();
    const auto is_notch = [&](TetId t) {
        if (complex.label(t) != loser) return false;
        const TetVertices& corners = complex.vertices(t);
        if (!std::all_of(corners.begin(), corners.end(),
                         [&](VertexId v) { return claim_[v].step == step_ && claim_[v].winner == winner; }))
            return false;
        int sides = 0;
        for (int k = 0; k < 4; ++k) {
            const TetId next = complex.neighbour(t, k);
            sides += next.is_valid() && complex.label(next) == winner ? 1 : 0;
        }
        return sides >= 2;
    };
    for (std::size_t i = first_touched; i < touched_.size(); ++i) {
        const std::span<const TetId> star = context.mesh.walker().star(touched_[i]);
        std::vector<TetId> notches;
        std::copy_if(star.begin(), star.end(), std::back_inserter(notches), is_notch);
        for (const TetId t : notches)
            if (may_give_way(context, t)) give(context, t, winner);
    }
}

void Contacts::open_pinches(PassContext& context, std::size_t first_touched, int winner, int loser) {
    for (std::size_t i = first_touched; i < touched_.size(); ++i) open_pinches_at(context, touched_[i], winner, loser);
}

void Contacts::open_pinches_at(PassContext& context, VertexId v, int winner, int loser) {
    for (;;) {
        const std::span<const TetId> more = pinches_.find(context, v, winner, loser);
        const auto may_go = [&](TetId t) { return may_give_way(context, t); };
        if (more.empty() || !std::all_of(more.begin(), more.end(), may_go)) break;
        for (const TetId t : more) give(context, t, winner);
    }
}

// The thin region around the seed: wider than what has set it off, so that what merges is joined by more than a thread.
void Contacts::gather_gap(PassContext& context, TetId seed) {
    const Complex& complex = context.complex();
    const Point3 centre = context.centroid(seed);
    const double reach = context.parameters.gap_reach * context.least_wanted_length(seed);
    seen_.clear();
    seen_.add(seed);
    gap_ = {seed};
    for (std::size_t i = 0; i < gap_.size(); ++i) {
        for (int k = 0; k < 4; ++k) {
            const TetId next = complex.neighbour(gap_[i], k);
            if (!next.is_valid() || complex.label(next) != complex.label(seed) || !seen_.add(next)) continue;
            if ((context.centroid(next) - centre).norm() > reach || !may_give_way(context, next)) continue;
            if (facing_sheets(context, next, context.parameters.gap_width)) gap_.push_back(next);
        }
    }
}

// The region that shares most of the gap's surface; none when only its edges are on it.
std::optional<int> Contacts::winner(const PassContext& context) const {
    const Complex& complex = context.complex();
    std::map<int, double> shared;
    for (const TetId t : gap_)
        for (int k = 0; k < 4; ++k) {
            const FaceId f = complex.faces(t)[static_cast<std::size_t>(k)];
            if (complex.is_interface(f)) shared[complex.label(complex.neighbour(t, k))] += area(context, f);
        }
    if (shared.empty()) return std::nullopt;
    return std::max_element(shared.begin(), shared.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; })
        ->first;
}

// What the gap has left of its region may be cut off from the rest: too little to be a body of its own, it goes too.
void Contacts::absorb_crumbs(PassContext& context, int loser) {
    const Complex& complex = context.complex();
    std::vector<TetId> crumb;
    for (const TetId t : gap_) {
        for (int k = 0; k < 4; ++k) {
            const TetId first = complex.neighbour(t, k);
            if (!first.is_valid() || complex.label(first) != loser) continue;
            const double length = context.least_wanted_length(first);
            const double largest = context.parameters.crumb_volume * length * length * length;
            crumb = {first};
            seen_.clear();
            seen_.add(first);
            double volume = 0;
            for (std::size_t i = 0; i < crumb.size() && volume <= largest; ++i) {
                volume += context.volume(crumb[i]);
                for (int n = 0; n < 4; ++n) {
                    const TetId next = complex.neighbour(crumb[i], n);
                    if (next.is_valid() && complex.label(next) == loser && seen_.add(next)) crumb.push_back(next);
                }
            }
            const auto may_go = [&](TetId c) { return may_give_way(context, c); };
            if (volume > largest || !std::all_of(crumb.begin(), crumb.end(), may_go)) continue;
            for (const TetId c : crumb) give(context, c, complex.label(t));
        }
    }
}

void Contacts::give(PassContext& context, TetId t, int winner) {
    const Complex& complex = context.complex();
    characteristic_change_ -= interface_characteristic(complex, t);
    context.mesh.set_label(t, winner);
    characteristic_change_ += interface_characteristic(complex, t);
    for (const VertexId v : complex.vertices(t)) {
        claim_[v] = {step_, winner};
        touched_.push_back(v);
    }
}

void Contacts::report_held(PassContext& context) {
    const Complex& complex = context.complex();
    for (const TetId t : context.region.tets()) {
        if (motion::allows_change(context.parameters.topology, complex.label(t), context.parameters.background_label))
            continue;
        const auto facing = facing_sheets(context, t, context.parameters.gap_width);
        if (!facing || !is_closing(context, *facing)) continue;
        const Point3 &a = context.mesh.position(facing->a), &b = context.mesh.position(facing->b);
        const Contact contact{.a = facing->a,
                              .b = facing->b,
                              .place = 0.5 * (a + b),
                              .lattice = Eigen::Vector3i::Zero(),
                              .gap = (b - a).norm(),
                              .label = complex.label(t)};
        context.listener.on_contact(contact);
        context.report.contacts.push_back(contact);
    }
}

}  // namespace dsc::dsc3d
