// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/deform/contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "dsc2d/deform/degeneracy.h"
#include "dsc2d/operations/collapse.h"
#include "dsc2d/operations/flip.h"
#include "dsc2d/operations/split.h"
#include "geometry/triangle.h"

namespace dsc::dsc2d {

namespace {

class ContactPass {
public:
    explicit ContactPass(PassContext& context)
        : context_(context),
          complex_(context.complex),
          distance_(context.absolute(context.parameters.contact_distance)),
          minimum_(context.absolute(context.parameters.contact_minimum)),
          piece_floor_(std::max(minimum_, 0.5 * context.absolute(context.parameters.interface_min_edge.value_or(0.0)))),
          cosine_of_wedge_(std::cos(context.parameters.contact_wedge)) {}

    void visit(VertexId v) {
        // Every change gives v another ring; then it is looked at again. Each change locks or removes something.
        while (!complex_.is_deleted(v) && complex_.is_interface(v) && visit_ring(v)) {
        }
    }

    bool stop_blocked(VertexId v, HalfedgeId blocking) {
        const HalfedgeId base = complex_.next(blocking), closing = complex_.prev(blocking);
        if (is_blunt_corner(base) || is_blunt_corner(closing)) return false;
        const bool meets_base =
            complex_.is_interface(base) && !complex_.is_interface(blocking) && !complex_.is_interface(closing);
        if (allows_change(blocking)) return false;
        if (meets_base) {
            stop_at_base(base, /*limit=*/std::nullopt, smallest_piece(base));
            return complex_.is_locked(v);
        }
        // One of v's own edges may rest on a vertex of the other side: that place is held, v goes on.
        for (const HalfedgeId own : {blocking, closing})
            if (complex_.is_interface(own) && complex_.is_interface(complex_.to(complex_.next(own))) &&
                !complex_.is_interface(complex_.next(own)) && !complex_.is_interface(complex_.prev(own)) &&
                stop_at_base(own, distance_, piece_floor_))
                return true;
        HalfedgeId nearest;
        for (const HalfedgeId h : {blocking, Complex::opposite(closing)}) {
            if (!complex_.is_interface(complex_.to(h))) continue;
            if (!nearest.is_valid() || complex_.length(h) < complex_.length(nearest)) nearest = h;
        }
        // What is in the way may be a chord across a bay of the interface: then nothing is close, and a flip will do.
        if (!nearest.is_valid() || complex_.length(nearest) > distance_) return false;
        // A neighbour along the interface may still be on its way; only another part of the interface is held.
        report(nearest, complex_.label(complex_.face(blocking)), !complex_.is_interface(nearest));
        return true;
    }

private:
    bool allows_change(HalfedgeId h) const {
        return motion::allows_change(context_.parameters.topology, complex_.label(complex_.face(h)),
                                     context_.parameters.background_label);
    }

    bool visit_ring(VertexId v) {
        for (const HalfedgeId h : complex_.outgoing(v)) {
            if (complex_.is_boundary(h)) continue;
            if (treat_edge(h) || treat_island(h)) return true;
            const HalfedgeId base = complex_.next(h);
            if (treat_cap(base) || treat_cap(h) || treat_cap(complex_.prev(h))) return true;
        }
        return false;
    }

    double local_length(VertexId v) const {
        double sum = 0.0;
        int count = 0;
        for (const HalfedgeId h : complex_.outgoing(v))
            if (complex_.is_interface(h)) {
                sum += complex_.length(h);
                ++count;
            }
        return count == 0 ? 0.0 : sum / count;
    }

    bool is_movable(VertexId v) const { return !complex_.is_locked(v) && !complex_.is_boundary(v); }

    // The angle at from(h) of face(h), against the wedge.
    bool is_sharp(HalfedgeId h) const {
        const Point2 u = complex_.vector(h), w = -complex_.vector(complex_.prev(h));
        return u.dot(w) > cosine_of_wedge_ * std::sqrt(u.squaredNorm() * w.squaredNorm());
    }

    // True when the interface turns at from(h), along two sides of face(h), by a right angle or less: then the face is
    // an ear of a smooth interface, which flips away, not a gap that closes.
    bool is_blunt_corner(HalfedgeId h) const {
        return complex_.is_interface(h) && complex_.is_interface(complex_.prev(h)) &&
               complex_.vector(h).dot(complex_.vector(complex_.prev(h))) >= 0.0;
    }

    // True when the apex of face(h) is joined to both ends of h by the interface, at an angle that is not sharp.
    bool bridges_blunt_wedge(HalfedgeId h) const {
        if (complex_.is_boundary(h)) return false;
        const HalfedgeId to_apex = complex_.next(h), from_apex = complex_.prev(h);
        return complex_.is_interface(to_apex) && complex_.is_interface(from_apex) && !is_sharp(from_apex);
    }

    bool treat_edge(HalfedgeId h) {
        const VertexId a = complex_.from(h), b = complex_.to(h);
        if (complex_.is_interface(h) || !complex_.is_interface(a) || !complex_.is_interface(b)) return false;
        const double squared = complex_.vector(h).squaredNorm();
        if (squared >= distance_ * distance_) return false;
        const bool allowed = allows_change(h);
        if (!allowed && !is_movable(a) && !is_movable(b))
            return lock_enclosed(h) || lock_enclosed(Complex::opposite(h));
        if (squared >= minimum_ * minimum_) {
            const double local = context_.parameters.contact_fraction * std::max(local_length(a), local_length(b));
            if (squared >= local * local) return false;
            if (bridges_blunt_wedge(h) || bridges_blunt_wedge(Complex::opposite(h))) return false;
        }
        if (allowed) return join_ends(h);
        report(h, complex_.label(complex_.face(h)), true);
        return true;
    }

    // A region that is a single thin face goes, or is stopped before it shrinks to nothing.
    bool treat_island(HalfedgeId h) {
        std::array<HalfedgeId, 3> sides = {h, complex_.next(h), complex_.prev(h)};
        bool is_movable_one = false;
        for (const HalfedgeId side : sides) {
            if (!complex_.is_interface(side)) return false;
            is_movable_one = is_movable_one || is_movable(complex_.from(side));
        }
        std::ranges::sort(sides, {}, [&](HalfedgeId side) { return complex_.length(side); });
        if (2.0 * complex_.area(complex_.face(h)) >= distance_ * complex_.length(sides[2])) return false;
        if (allows_change(h)) return collapse_island(sides);
        if (!is_movable_one) return false;
        const int label = complex_.label(complex_.face(h));
        report(sides[0], label, true);
        report(sides[1], label, true);
        return true;
    }

    bool collapse_island(const std::array<HalfedgeId, 3>& sides) {
        for (const HalfedgeId side : sides)
            for (const HalfedgeId way : {side, Complex::opposite(side)}) {
                if (!can_collapse(complex_, way, CollapseRule::change_topology)) continue;
                context_.collapse_and_tell(way);
                ++context_.report.counts.topology_changes;
                return true;
            }
        return false;
    }

    // A vertex whose two neighbours have met in front of it can't get out any more.
    bool lock_enclosed(HalfedgeId h) {
        if (complex_.is_boundary(h)) return false;
        const HalfedgeId from_apex = complex_.prev(h);
        if (!is_movable(complex_.from(from_apex))) return false;
        if (!complex_.is_interface(from_apex) || !complex_.is_interface(complex_.next(h)) || !is_sharp(from_apex))
            return false;
        report(from_apex, complex_.label(complex_.face(h)), false);
        return true;
    }

    bool treat_cap(HalfedgeId base) {
        const HalfedgeId to_apex = complex_.next(base), from_apex = complex_.prev(base);
        const VertexId apex = complex_.to(to_apex);
        if (!complex_.is_interface(base) || !complex_.is_interface(apex)) return false;
        const Point2 along = complex_.vector(base);
        const double length = along.norm();
        const double height = geometry::cross(along, -complex_.vector(from_apex)) / length;
        if (height >= distance_) return false;
        if (!is_movable(apex) && !is_movable(complex_.from(base)) && !is_movable(complex_.to(base))) return false;
        const double limit =
            std::min(distance_, context_.parameters.contact_fraction * std::max(length, local_length(apex)));
        if (height >= limit) return false;
        // Where the apex is a neighbour of the base along the interface, only a sharp wedge counts.
        if (complex_.is_interface(to_apex) && (complex_.is_interface(from_apex) || !is_sharp(to_apex))) return false;
        if (complex_.is_interface(from_apex) && !is_sharp(base)) return false;
        return allows_change(base) ? join_apex(base) : stop_at_base(base, limit, smallest_piece(base));
    }

    // The base of a cap is not cut into pieces shorter than this.
    double smallest_piece(HalfedgeId base) const {
        return std::max(piece_floor_,
                        0.5 * std::min(distance_, context_.parameters.contact_fraction * complex_.length(base)));
    }

    // Stops the apex of face(base) and the nearest point of the base, when that is nearer than the limit.
    bool stop_at_base(HalfedgeId base, std::optional<double> limit, double piece) {
        const HalfedgeId to_apex = complex_.next(base), from_apex = complex_.prev(base);
        const Point2 along = complex_.vector(base), apex = -complex_.vector(from_apex);
        const double s = geometry::closest_parameter(apex, Point2::Zero(), along);
        const Point2 nearest = s * along;
        const double gap = (apex - nearest).norm();
        if (limit && gap >= *limit) return false;
        const int label = complex_.label(complex_.face(base));
        const double length = along.norm();
        if (std::min(s, 1.0 - s) * length < piece)
            return stop_at_end(s < 0.5 ? from_apex : Complex::opposite(to_apex), limit, label);
        const auto place = can_split_edge(complex_, base, s);
        if (!place) return false;
        const VertexId apex_vertex = complex_.to(to_apex);
        const VertexId q = complex_.from(base), r = complex_.to(base);
        const VertexId m = split_edge(complex_, base, *place);
        ++context_.report.counts.edge_splits;
        complex_.lock(m);
        context_.listener.on_interface_split(m, q, r, s);
        for (const HalfedgeId h : complex_.outgoing(m)) context_.active.add(complex_.to(h));
        for (const HalfedgeId h : complex_.outgoing(m))
            if (complex_.to(h) == apex_vertex && complex_.label(complex_.face(h)) == label &&
                !complex_.is_interface(h)) {
                report(Complex::opposite(h), label, true);
                return true;
            }
        return true;
    }

    // The contact of a cap whose apex, from(h), lies over an end of its base, to(h).
    bool stop_at_end(HalfedgeId h, std::optional<double> limit, int label) {
        if (complex_.is_interface(h)) return false;
        if (!is_movable(complex_.from(h)) && !is_movable(complex_.to(h))) return false;
        if (limit && complex_.length(h) >= *limit) return false;
        report(h, label, true);
        return true;
    }

    // Locks from(h), and to(h) if asked, and reports the contact.
    void report(HalfedgeId h, int label, bool locks_both) {
        const VertexId a = complex_.from(h), b = complex_.to(h);
        complex_.lock(a);
        if (locks_both) complex_.lock(b);
        const Point2 way = complex_.vector(h);
        const Contact contact{a, b, complex_.position(a) + 0.5 * way, complex_.offset(h), way.norm(), label};
        context_.report.contacts.push_back(contact);
        context_.listener.on_contact(contact);
        tell(motion::EventKind::contact, contact.place, label);
        context_.active.add(a);
        context_.active.add(b);
    }

    bool join_ends(HalfedgeId h) {
        const int label = complex_.label(complex_.face(h));
        const Point2 place = complex_.position(complex_.from(h)) + 0.5 * complex_.vector(h);
        const std::array<HalfedgeId, 2> ways = {h, Complex::opposite(h)};
        for (const HalfedgeId way : ways) {
            if (!can_collapse(complex_, way, CollapseRule::change_topology)) continue;
            context_.collapse_and_tell(way);
            tell_change(place, label);
            return true;
        }
        // A vertex inside the gap would be pushed through the interface: it goes first.
        for (const HalfedgeId side : ways) {
            if (complex_.is_boundary(side)) continue;
            const VertexId apex = complex_.to(complex_.next(side));
            if (context_.is_steiner(apex) && remove_steiner_vertex(context_, apex)) return true;
        }
        return false;
    }

    bool join_apex(HalfedgeId base) {
        const HalfedgeId from_apex = complex_.prev(base);
        const Point2 along = complex_.vector(base), apex = -complex_.vector(from_apex);
        const double s = apex.dot(along) / along.squaredNorm();
        // The flip needs an apex over the base; otherwise the nearest end is met first.
        if (s <= 0.0 || s >= 1.0 || complex_.is_boundary(Complex::edge(base))) return false;
        if (!can_flip(complex_, Complex::edge(base))) return false;
        const int label = complex_.label(complex_.face(base));
        const Point2 place = complex_.position(complex_.from(base)) + apex;
        for (const VertexId v : {complex_.from(base), complex_.to(base), complex_.from(from_apex)})
            context_.active.add(v);
        flip_to_label_of(complex_, Complex::opposite(base));
        ++context_.report.counts.flips;
        tell_change(place, label);
        return true;
    }

    void tell_change(const Point2& place, int label) {
        ++context_.report.counts.topology_changes;
        tell(motion::EventKind::topology_change, place, label);
    }

    void tell(motion::EventKind kind, const Point2& place, int label) {
        context_.listener.on_event({kind, place, context_.report.substeps, label});
    }

    PassContext& context_;
    Complex& complex_;
    double distance_;
    double minimum_;
    double piece_floor_;
    double cosine_of_wedge_;
};

}  // namespace

void treat_contacts(PassContext& context) {
    ContactPass pass(context);
    for (std::size_t i = 0; i < context.active.size(); ++i) pass.visit(context.active[i]);
}

bool treat_blocked_vertex(PassContext& context, VertexId v, HalfedgeId blocking) {
    return ContactPass(context).stop_blocked(v, blocking);
}

}  // namespace dsc::dsc2d
