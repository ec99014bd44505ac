// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/meetings.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>

#include "core/parallel.h"
#include "geodesic/connect.h"

namespace dsc::cutlocus {

using geodesic::GeodesicFlow;
using geodesic::GeodesicState;
using geodesic::LatticeVector;
using geodesic::Meeting;
using geodesic::Point2;

namespace {

/// Local error of the integrator's steps, in units of the tolerance of a draft.
constexpr double draft_step_tolerance = 1e-3;

/// The same meeting with its directions ordered so that 0 < w <= π/2.
Meeting canonical(Meeting meeting) {
    constexpr double turn = 2 * std::numbers::pi;
    double theta1 = wrapped_angle(meeting.theta1()), theta2 = wrapped_angle(meeting.theta2());
    if (wrapped_angle(theta1 - theta2) > std::numbers::pi) {
        std::swap(theta1, theta2);
        std::swap(meeting.first, meeting.second);
        meeting.lattice = -meeting.lattice;
        meeting.middle_w = -meeting.middle_w;
        meeting.t_w = -meeting.t_w;
    }
    if (theta1 < theta2) theta1 += turn;
    meeting.w = (theta1 - theta2) / 2;
    meeting.middle = (theta1 + theta2) / 2;
    return meeting;
}

/// One side of a meeting: the geodesic, and the lattice vector to the end of the other one (this - other).
struct Side {
    const GeodesicState* state;
    const GeodesicState* other;
    LatticeVector lattice;

    Side(const Meeting& meeting, int side)
        : state(side == 0 ? &meeting.first : &meeting.second),
          other(side == 0 ? &meeting.second : &meeting.first),
          lattice(side == 0 ? meeting.lattice : LatticeVector(-meeting.lattice)) {}
};

/// True if a geodesic near the partner of `rival` reaches the end of `side` earlier than `side` itself, or just as
/// early. `side` and `rival` are neighbours on the circle of directions.
bool is_overtaken(GeodesicFlow& flow, const Side& side, const Side& rival, double tolerance) {
    const Point2 target = side.state->x - flow.metric().periods().translation(rival.lattice);
    const auto competitor =
        geodesic::connect(flow, target, rival.other->theta, side.state->t, {.tolerance = tolerance / 10});
    if (!competitor || !(competitor->j > 0)) return false;
    // A competitor that is one of the two geodesics of the meeting itself proves nothing. Where j is large the errors
    // of both have grown with it, so they are told apart on a coarser scale.
    const auto is_same = [&](const GeodesicState& state) {
        return std::abs(std::remainder(competitor->theta - state.theta, 2 * std::numbers::pi)) * state.j <
               std::sqrt(tolerance);
    };
    if (is_same(*side.state) || is_same(*side.other)) return false;
    return competitor->t < side.state->t + tolerance;
}

}  // namespace

std::vector<DirectionPair> pairs_of(std::span<const FoundMeeting> meetings) {
    std::vector<DirectionPair> pairs;
    for (const Meeting& meeting : meetings)
        pairs.push_back({meeting.theta1(), meeting.theta2(), meeting.t, meeting.lattice});
    return pairs;
}

std::vector<FoundMeeting> draft_meetings(const geodesic::Metric& metric, const Point2& origin,
                                         std::span<const DirectionPair> contacts, double largest_shift,
                                         double tolerance, int threads) {
    geodesic::MeetingParameters parameters;
    parameters.linear_step = std::sqrt(tolerance);  // the error left is quadratic in it
    std::vector<std::optional<Meeting>> solved(contacts.size());
    core::parallel_for(contacts.size(), {.threads = threads, .grain = 16}, [&](std::size_t i) {
        const DirectionPair& contact = contacts[i];
        GeodesicFlow flow(metric, origin, draft_step_tolerance * tolerance);
        const auto meeting =
            geodesic::nearest_meeting(flow, contact.theta1, contact.theta2, contact.t, contact.lattice, parameters);
        if (!meeting || !(meeting->first.j > 0) || !(meeting->second.j > 0)) return;
        // What lies far from its contact is the meeting of other parts of the front.
        const double shift = std::max({std::abs(meeting->theta1() - contact.theta1) * meeting->first.j,
                                       std::abs(meeting->theta2() - contact.theta2) * meeting->second.j,
                                       std::abs(meeting->t - contact.t)});
        if (shift > largest_shift) return;
        // So near a conjugate end that the error leaves the order of the directions open, a meeting tells nothing.
        constexpr double largest_uncertainty = 0.1;
        if (meeting->sensitivity * tolerance <= largest_uncertainty * std::abs(meeting->w))
            solved[i] = canonical(*meeting);
    });
    std::vector<FoundMeeting> meetings;
    for (const std::optional<Meeting>& meeting : solved)
        if (meeting) meetings.push_back({*meeting});
    const auto key = [](const Meeting& m) {
        return std::tuple(m.lattice.x(), m.lattice.y(), wrapped_angle(m.middle), m.w);
    };
    std::sort(meetings.begin(), meetings.end(), [&](const Meeting& a, const Meeting& b) { return key(a) < key(b); });
    const auto is_same = [&](const Meeting& a, const Meeting& b) {
        return a.lattice == b.lattice &&
               std::abs(std::remainder(a.middle - b.middle, 2 * std::numbers::pi)) * a.first.j < tolerance &&
               std::abs(a.w - b.w) * a.first.j < tolerance;
    };
    meetings.erase(std::unique(meetings.begin(), meetings.end(), is_same), meetings.end());
    return meetings;
}

void remove_overtaken(const geodesic::Metric& metric, const Point2& origin, std::vector<FoundMeeting>& meetings,
                      std::span<const double> free_directions, double tolerance) {
    GeodesicFlow flow(metric, origin, draft_step_tolerance * tolerance);
    std::set<std::pair<double, double>> harmless;  // directions of side and rival, already compared
    for (bool is_changed = true; is_changed;) {
        is_changed = false;
        const Gluing gluing(pairs_of(meetings), free_directions);
        std::vector<char> is_removed(meetings.size(), 0);
        const auto contest = [&](int k, int rival) {
            const Gluing::Entry &entry = gluing.entry(k), &other = gluing.entry(rival);
            const auto index = static_cast<std::size_t>(entry.pair);
            if (entry.pair == other.pair || is_removed[index] || !harmless.emplace(entry.theta, other.theta).second)
                return;
            if (!is_overtaken(flow, Side(meetings[index], entry.side),
                              Side(meetings[static_cast<std::size_t>(other.pair)], other.side), tolerance))
                return;
            is_removed[index] = 1;
            is_changed = true;
        };
        for (int gap = 0; gap < gluing.size(); ++gap) {
            if (gluing.is_inside_arc(gap)) continue;
            contest(gap, gap + 1);
            contest(gap + 1, gap);
        }
        std::vector<FoundMeeting> kept;
        for (std::size_t i = 0; i < meetings.size(); ++i)
            if (!is_removed[i]) kept.push_back(std::move(meetings[i]));
        meetings = std::move(kept);
    }
}

namespace {

/// A meeting near the conjugate end `end` that lies nearer than its distance to the arc's other geodesic, `rival`.
std::optional<Meeting> meeting_before(GeodesicFlow& flow, const GeodesicState& end, const GeodesicState& rival,
                                      const LatticeVector& lattice, double largest_w) {
    constexpr double smallest_w = 1e-4;  // below, directions are not told apart well enough to be put in order
    for (double w = largest_w; w > smallest_w; w /= 2) {
        const auto meeting = geodesic::meet(flow, w, {0, 0}, end.theta, end.t);
        if (!meeting || !(meeting->first.j > 0) || !(meeting->second.j > 0)) continue;
        const Point2 target = meeting->first.x - flow.metric().periods().translation(lattice);
        const auto other = geodesic::connect(flow, target, rival.theta, rival.t);
        if (other && other->t > meeting->t) return meeting;
    }
    return std::nullopt;
}

}  // namespace

std::optional<FoundMeeting> hidden_meeting(GeodesicFlow& flow, const Meeting& before, const Meeting& after) {
    for (int side : {0, 1}) {
        const double a = side == 0 ? before.theta1() : before.theta2();
        const double b = side == 0 ? after.theta1() : after.theta2();
        const auto end = geodesic::conjugate_end(flow, (a + b) / 2, (before.t + after.t) / 2);
        if (!end || end->theta <= std::min(a, b) || end->theta >= std::max(a, b)) continue;
        const GeodesicState& rival = side == 0 ? before.second : before.first;
        const LatticeVector lattice = side == 0 ? before.lattice : LatticeVector(-before.lattice);
        if (const auto meeting = meeting_before(flow, *end, rival, lattice, std::abs(b - a) / 2))
            return FoundMeeting{canonical(*meeting), false};
    }
    return std::nullopt;
}

}  // namespace dsc::cutlocus
