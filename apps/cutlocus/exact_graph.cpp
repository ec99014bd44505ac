// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/exact_graph.h"

#include <algorithm>
#include <cmath>

#include "apps/cutlocus/meetings.h"
#include "apps/cutlocus/vertices.h"
#include "core/assert.h"
#include "core/errors.h"
#include "core/parallel.h"

namespace dsc::cutlocus {

using geodesic::GeodesicFlow;
using geodesic::GeodesicState;
using geodesic::Meeting;

namespace {

/// Local error of the integrator's steps, in units of what the end of a geodesic may be off.
constexpr double exact_step_tolerance = 1e-2;
/// The same next to a conjugate end, where that is not always enough; and as much as round-off allows.
constexpr double fine_step_tolerance = 1e-4, finest_step_tolerance = 1e-14;

/// An arc between two solved vertices: gaps on its two sides at either end, and the meetings in between.
struct ArcPlan {
    std::size_t start = 0, end = 0;
    int start_first = 0, start_second = 0;  ///< gap of the start vertex's arrival on the side of theta1, of theta2
    int end_first = 0, end_second = 0;
    std::vector<Meeting> meetings;
    bool is_announced = false;
};

/// The skeleton: all vertices solved, the chains of meetings between them known.
struct Skeleton {
    std::vector<FoundMeeting> meetings;
    std::vector<SolvedVertex> vertices;
    std::vector<ArcPlan> arcs;
    std::vector<Doubt> doubts;
};

/// The meeting seen with the geodesic of `side` as its first one.
Meeting seen_from(const Meeting& meeting, int side) {
    if (side == 0) return meeting;
    Meeting swapped = meeting;
    std::swap(swapped.first, swapped.second);
    swapped.lattice = -meeting.lattice;
    swapped.w = -meeting.w;
    swapped.middle_w = -meeting.middle_w;
    swapped.t_w = -meeting.t_w;
    return swapped;
}

/// The same meeting with directions theta1 in [low, low + 2π) and theta2 in (high - 2π, high].
Meeting unwrapped(Meeting meeting, double low, double high) {
    const double theta1 = low + wrapped_angle(meeting.theta1() - low);
    const double theta2 = high - wrapped_angle(high - meeting.theta2());
    meeting.w = (theta1 - theta2) / 2;
    meeting.middle = (theta1 + theta2) / 2;
    return meeting;
}

/// Vertices of all walks; false if meetings beyond a vertex were taken out, so that the gluing has to be done anew.
bool solve_vertices(GeodesicFlow& flow, const Gluing& gluing, const std::vector<DirectionPair>& pairs,
                    const ExactParameters& parameters, Skeleton& skeleton, std::vector<std::size_t>& corners) {
    skeleton.vertices.clear();
    skeleton.arcs.clear();
    skeleton.doubts.clear();
    corners.assign(static_cast<std::size_t>(gluing.size()), 0);
    std::vector<int> overtaken;
    for (const Gluing::Walk& walk : gluing.walks()) {
        if (walk.is_closed && walk.gaps.size() == 2) continue;
        VertexSolution solution =
            solve_vertex(flow, gluing, pairs, walk, parameters.max_distance, parameters.coincidence);
        if (solution.failure) {
            for (int gap : walk.gaps) skeleton.doubts.push_back({gluing.entry(gap).theta, *solution.failure});
            continue;
        }
        overtaken.insert(overtaken.end(), solution.overtaken_pairs.begin(), solution.overtaken_pairs.end());
        const std::size_t offset = skeleton.vertices.size();
        // The last gap of an open walk is the first one of another.
        const std::size_t count = walk.is_closed ? walk.gaps.size() : walk.gaps.size() - 1;
        for (std::size_t i = 0; i < count; ++i)
            corners[static_cast<std::size_t>(walk.gaps[i])] = offset + solution.corners[i];
        for (const UnannouncedArc& arc : solution.arcs)
            skeleton.arcs.push_back({offset + arc.start,
                                     offset + arc.end,
                                     arc.first_gap,
                                     arc.second_gap,
                                     arc.first_gap,
                                     arc.second_gap,
                                     {},
                                     false});
        for (SolvedVertex& vertex : solution.vertices) skeleton.vertices.push_back(std::move(vertex));
    }
    if (overtaken.empty()) return true;
    std::sort(overtaken.begin(), overtaken.end());
    overtaken.erase(std::unique(overtaken.begin(), overtaken.end()), overtaken.end());
    for (auto pair = overtaken.rbegin(); pair != overtaken.rend(); ++pair)
        skeleton.meetings.erase(skeleton.meetings.begin() + *pair);
    return false;
}

/// The chains of meetings between the vertices. Each arc is found from both of its sides; the one kept starts at its
/// conjugate end, if it has one, or at the smaller entry.
void chain_arcs(const Gluing& gluing, const std::vector<std::size_t>& corners, Skeleton& skeleton) {
    for (int gap = 0; gap < gluing.size(); ++gap) {
        if (gluing.is_inside_arc(gap)) continue;
        ArcPlan plan;
        plan.start = corners[static_cast<std::size_t>(gap)];
        plan.start_first = gap;
        plan.start_second = gluing.next_gap(gap);
        int last = gluing.wrapped(gap + 1);
        for (;; last = gluing.wrapped(last + 1)) {
            const Gluing::Entry& entry = gluing.entry(last);
            const FoundMeeting& meeting = skeleton.meetings[static_cast<std::size_t>(entry.pair)];
            plan.meetings.push_back(seen_from(meeting, entry.side));
            plan.is_announced = plan.is_announced || meeting.is_announced;
            if (!gluing.is_inside_arc(last)) break;
        }
        plan.end_first = last;
        plan.end_second = gluing.wrapped(gluing.partner(last) - 1);
        plan.end = corners[static_cast<std::size_t>(plan.end_second)];
        const bool starts_at_end = skeleton.vertices[plan.start].kind == VertexKind::end;
        const bool ends_at_end = skeleton.vertices[plan.end].kind == VertexKind::end;
        const bool is_kept = starts_at_end != ends_at_end ? starts_at_end : gap < plan.end_second;
        if (is_kept) skeleton.arcs.push_back(std::move(plan));
    }
}

Skeleton build_skeleton(GeodesicFlow& flow, std::vector<FoundMeeting> meetings, std::span<const double> free_directions,
                        const ExactParameters& parameters) {
    Skeleton skeleton;
    skeleton.meetings = std::move(meetings);
    for (;;) {
        const std::vector<DirectionPair> pairs = pairs_of(skeleton.meetings);
        const Gluing gluing(pairs, free_directions);
        std::vector<std::size_t> corners;
        if (!solve_vertices(flow, gluing, pairs, parameters, skeleton, corners)) continue;
        if (skeleton.doubts.empty()) chain_arcs(gluing, corners, skeleton);
        return skeleton;
    }
}

/// The vertex as a meeting of its arrivals with these indices.
Meeting meeting_at(const SolvedVertex& vertex, std::size_t i, std::size_t k) {
    Meeting meeting;
    meeting.first = vertex.arrivals[i];
    meeting.second = vertex.arrivals[k];
    meeting.lattice = vertex.lattices[i] - vertex.lattices[k];
    meeting.t = vertex.distance;
    meeting.middle = (meeting.first.theta + meeting.second.theta) / 2;
    meeting.w = (meeting.first.theta - meeting.second.theta) / 2;
    return meeting;
}

/// Meetings along the arc with w ascending, its two ends included.
std::vector<Meeting> anchors_of(GeodesicFlow& flow, const Skeleton& skeleton, const ArcPlan& plan) {
    const SolvedVertex &start = skeleton.vertices[plan.start], &end = skeleton.vertices[plan.end];
    // Both arrivals of a frontier vertex may lie in one gap: there their order tells them apart.
    Meeting first = start.kind == VertexKind::frontier
                        ? meeting_at(start, 0, 1)
                        : meeting_at(start, start.arrival_in(plan.start_first), start.arrival_in(plan.start_second));
    Meeting last = end.kind == VertexKind::frontier
                       ? meeting_at(end, 1, 0)
                       : meeting_at(end, end.arrival_in(plan.end_first), end.arrival_in(plan.end_second));
    first = unwrapped(first, wrapped_angle(first.theta1()), wrapped_angle(first.theta1()));
    std::vector<Meeting> anchors{first};
    for (const Meeting& meeting : plan.meetings)
        anchors.push_back(unwrapped(meeting, anchors.back().theta1(), anchors.back().theta2()));
    anchors.push_back(unwrapped(last, anchors.back().theta1(), anchors.back().theta2()));
    // The geodesics of neighbours belong to one sheet: bring their ends together in the universal cover.
    for (Meeting* meeting : {&anchors.front(), &anchors.back()}) {
        if (meeting->w == 0) continue;
        const auto exact = geodesic::meet(flow, meeting->w, meeting->lattice, meeting->middle, meeting->t);
        if (!exact) throw core::RunError("the arc can't be followed from its vertex");
        meeting->middle_w = exact->middle_w;
        meeting->t_w = exact->t_w;
    }
    return anchors;
}

CutVertex cut_vertex(const SolvedVertex& vertex) {
    CutVertex result;
    result.kind = vertex.kind;
    result.x = vertex.arrivals.front().x;
    result.distance = vertex.distance;
    result.residual = vertex.residual;
    for (const GeodesicState& state : vertex.arrivals) result.thetas.push_back(std::remainder(state.theta, full_turn));
    std::sort(result.thetas.begin(), result.thetas.end());
    return result;
}

/// What became of one planned arc.
struct SolvedArc {
    std::optional<CutArc> arc;
    double sector_area = 0, residual = 0, smallest_j = 0;
    Extremum nearest, farthest;
    std::optional<BrokenArc> broken;
    std::string failure;
};

SolvedArc solve_arc(GeodesicFlow& flow, const Skeleton& skeleton, const ArcPlan& plan,
                    const ExactParameters& parameters) {
    SolvedArc result;
    ArcParameters arc_parameters;
    arc_parameters.tolerance = parameters.tolerance / 10;
    arc_parameters.fine_step_tolerance = std::max(fine_step_tolerance * parameters.tolerance, finest_step_tolerance);
    try {
        const std::vector<Meeting> anchors = anchors_of(flow, skeleton, plan);
        const ArcCurve curve(flow, anchors, arc_parameters);
        const int intervals = std::max(1, static_cast<int>(std::ceil(curve.length() / parameters.spacing)));
        result.arc = CutArc{static_cast<int>(plan.start),
                            static_cast<int>(plan.end),
                            anchors.front().lattice,
                            curve.length(),
                            plan.is_announced,
                            curve.samples(intervals)};
        result.sector_area = curve.sector_area();
        result.residual = curve.residual();
        result.smallest_j = curve.smallest_j();
        result.nearest = curve.extremum(1);
        result.farthest = curve.extremum(-1);
    } catch (const BrokenArc& error) {
        result.broken = error;
    } catch (const core::RunError& error) {
        result.failure = error.what();
    }
    return result;
}

/// Solves all arcs of the skeleton into `graph`; returns the ones that are broken.
std::vector<BrokenArc> solve_arcs(const geodesic::Metric& metric, const Point2& origin, const Skeleton& skeleton,
                                  const ExactParameters& parameters, core::Observer& observer, CutGraph& graph) {
    std::vector<SolvedArc> solved(skeleton.arcs.size());
    core::parallel_for(solved.size(), {.threads = parameters.threads, .grain = 1}, [&](std::size_t i) {
        if (observer.is_cancelled()) return;
        GeodesicFlow flow(metric, origin, exact_step_tolerance * parameters.tolerance);
        solved[i] = solve_arc(flow, skeleton, skeleton.arcs[i], parameters);
    });
    observer.check_cancelled();

    Certificate& certificate = graph.certificate;
    graph.nearest.distance = certificate.smallest_j = std::numeric_limits<double>::infinity();
    std::vector<BrokenArc> broken;
    for (std::size_t i = 0; i < solved.size(); ++i) {
        SolvedArc& result = solved[i];
        if (result.broken) broken.push_back(*result.broken);
        if (!result.failure.empty())
            graph.doubts.push_back({skeleton.vertices[skeleton.arcs[i].start].arrivals.front().theta, result.failure});
        if (!result.arc) continue;
        graph.length += result.arc->length;
        certificate.sector_area += result.sector_area;
        certificate.residual = std::max(certificate.residual, result.residual);
        certificate.smallest_j = std::min(certificate.smallest_j, result.smallest_j);
        if (result.nearest.distance < graph.nearest.distance) graph.nearest = result.nearest;
        if (result.farthest.distance > graph.farthest.distance) graph.farthest = result.farthest;
        ++graph.vertices[skeleton.arcs[i].start].degree;
        ++graph.vertices[skeleton.arcs[i].end].degree;
        graph.arcs.push_back(std::move(*result.arc));
    }
    return broken;
}

}  // namespace

CutGraph exact_graph(const geodesic::Metric& metric, const Point2& origin, std::span<const DirectionPair> contacts,
                     std::span<const double> free_directions, const ExactParameters& parameters,
                     core::Observer& observer) {
    observer.progress("meetings", -1, "");
    std::vector<FoundMeeting> meetings = draft_meetings(metric, origin, contacts, parameters.largest_shift,
                                                        parameters.draft_tolerance, parameters.threads);
    if (parameters.max_distance)
        std::erase_if(meetings, [&](const FoundMeeting& meeting) { return meeting.t >= *parameters.max_distance; });
    remove_overtaken(metric, origin, meetings, free_directions, parameters.draft_tolerance);
    GeodesicFlow flow(metric, origin, exact_step_tolerance * parameters.tolerance);
    for (;;) {
        observer.check_cancelled();
        observer.progress("vertices", -1, "");
        const Skeleton skeleton = build_skeleton(flow, meetings, free_directions, parameters);
        CutGraph graph;
        graph.doubts = skeleton.doubts;
        if (!graph.doubts.empty()) return graph;
        for (const SolvedVertex& vertex : skeleton.vertices) graph.vertices.push_back(cut_vertex(vertex));
        observer.progress("arcs", -1, std::to_string(skeleton.arcs.size()) + " arcs");
        const std::vector<BrokenArc> broken = solve_arcs(metric, origin, skeleton, parameters, observer, graph);
        if (broken.empty()) return graph;
        // Every round finds at least one hidden end, or is the last.
        meetings = skeleton.meetings;
        bool is_found = false;
        for (const BrokenArc& arc : broken) {
            const std::optional<FoundMeeting> hidden = hidden_meeting(flow, arc.before(), arc.after());
            if (hidden) meetings.push_back(*hidden);
            is_found = is_found || hidden;
            graph.doubts.push_back({arc.before().theta1(), arc.what()});
        }
        if (!is_found) return graph;
    }
}

}  // namespace dsc::cutlocus
