// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/vertices.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/assert.h"
#include "geodesic/connect.h"

namespace dsc::cutlocus {

using geodesic::Arrival;
using geodesic::GeodesicFlow;
using geodesic::GeodesicState;
using geodesic::LatticeVector;

namespace {

/// Directions of gap k: its ends, the upper one unwrapped above the lower one.
struct GapRange {
    double low, high;

    GapRange(const Gluing& gluing, int gap)
        : low(gluing.entry(gap).theta), high(low + wrapped_angle(gluing.entry(gap + 1).theta - low)) {
        if (gluing.size() > 0 && high == low) high = low + full_turn;
    }
    double middle() const { return (low + high) / 2; }
    /// How far theta lies outside: negative below, positive above, 0 inside.
    double excess(double theta) const {
        const double centred = middle() + std::remainder(theta - middle(), full_turn);
        return centred < low ? centred - low : centred > high ? centred - high : 0;
    }
};

const DirectionPair& pair_at(const Gluing& gluing, std::span<const DirectionPair> pairs, int entry) {
    return pairs[static_cast<std::size_t>(gluing.entry(entry).pair)];
}

/// Lattice vector from the end of `entry`'s geodesic to that of its partner.
LatticeVector crossing(const Gluing& gluing, std::span<const DirectionPair> pairs, int entry) {
    const LatticeVector lattice = pair_at(gluing, pairs, entry).lattice;
    return gluing.entry(entry).side == 0 ? LatticeVector(-lattice) : lattice;
}

VertexSolution failed(std::string reason) {
    VertexSolution solution;
    solution.failure = std::move(reason);
    return solution;
}

/// The pairs at the ends of the walk's gaps that an arrival outside its gap proves to lie beyond the vertex.
std::vector<int> overtaken_pairs(const Gluing& gluing, const SolvedVertex& vertex) {
    std::vector<int> pairs;
    for (std::size_t i = 0; i < vertex.gaps.size(); ++i) {
        const double excess = GapRange(gluing, vertex.gaps[i]).excess(vertex.arrivals[i].theta);
        if (excess == 0) continue;
        pairs.push_back(gluing.entry(vertex.gaps[i] + (excess > 0 ? 1 : 0)).pair);
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

VertexSolution solve_end(GeodesicFlow& flow, const Gluing& gluing, std::span<const DirectionPair> pairs,
                         const Gluing::Walk& walk) {
    const int gap = walk.gaps.front();
    const GapRange range(gluing, gap);
    const auto state = geodesic::conjugate_end(flow, range.middle(), pair_at(gluing, pairs, gap).t);
    if (!state) return failed("no conjugate point found at the end of an arc");
    VertexSolution solution;
    solution.corners = {0};
    solution.vertices.push_back({VertexKind::end, state->t, 0, walk.gaps, {*state}, {LatticeVector(0, 0)}});
    solution.overtaken_pairs = overtaken_pairs(gluing, solution.vertices.front());
    return solution;
}

VertexSolution solve_frontier(GeodesicFlow& flow, const Gluing& gluing, std::span<const DirectionPair> pairs,
                              const Gluing::Walk& walk, double max_distance) {
    if (walk.gaps.size() != 2) return failed("arcs branch at the largest distance asked for");
    // Unknown directions a (above the first gap's open part) and b with E(a, R) = E(b, R) + lattice.
    const int entry = walk.gaps.front() + 1;
    const LatticeVector lattice = crossing(gluing, pairs, entry);
    const double theta = gluing.entry(entry).theta, other = gluing.entry(gluing.partner(entry)).theta;
    GeodesicState a = flow.shoot(theta, max_distance), b = flow.shoot(other, max_distance);
    for (int iteration = 0; iteration < 30; ++iteration) {
        const geodesic::Vector2 miss = b.x - flow.metric().periods().translation(lattice) - a.x;
        Eigen::Matrix2d jacobian;
        jacobian << jacobi_field(flow.metric(), a), -jacobi_field(flow.metric(), b);
        const geodesic::Vector2 correction = jacobian.inverse() * miss;
        const double step = std::max(std::abs(correction[0] * a.j), std::abs(correction[1] * b.j));
        if (!std::isfinite(step)) break;
        if (step < 1e-11) {
            VertexSolution solution;
            solution.corners = {0, 0};
            solution.vertices.push_back(
                {VertexKind::frontier, max_distance, 0, walk.gaps, {a, b}, {LatticeVector(0, 0), lattice}});
            return solution;
        }
        const double shortened = std::min(1.0, 0.25 * max_distance / step);
        a = flow.shoot(a.theta + shortened * correction[0], max_distance);
        b = flow.shoot(b.theta + shortened * correction[1], max_distance);
    }
    return failed("an arc does not reach the largest distance asked for");
}

/// The branch point of some of the arrivals, if they meet in one point.
std::optional<SolvedVertex> common_point(GeodesicFlow& flow, const std::vector<Arrival>& arrivals,
                                         const std::vector<int>& gaps, const std::vector<std::size_t>& chosen, double t,
                                         double coincidence) {
    std::vector<Arrival> some;
    SolvedVertex vertex;
    for (std::size_t i : chosen) {
        some.push_back({arrivals[i].theta, arrivals[i].lattice - arrivals[chosen.front()].lattice});
        vertex.gaps.push_back(gaps[i]);
        vertex.lattices.push_back(some.back().lattice);
    }
    auto point = geodesic::branch_point(flow, some, t);
    if (!point || point->residual > coincidence) return std::nullopt;
    if (std::any_of(point->arrivals.begin(), point->arrivals.end(), [](const auto& state) { return !(state.j > 0); }))
        return std::nullopt;
    vertex.distance = point->t, vertex.residual = point->residual;
    vertex.arrivals = std::move(point->arrivals);
    return vertex;
}

/// Resolves arrivals that have no common point into branch points of degree three, joined by arcs: cuts three
/// neighbours off the ring whose common point no other arrival reaches earlier, until three are left.
VertexSolution resolve(GeodesicFlow& flow, const std::vector<Arrival>& arrivals, const std::vector<int>& gaps, double t,
                       double coincidence) {
    struct Link {  // an arrival, and the vertex beyond the side to the next arrival, if one was cut off there
        std::size_t arrival;
        std::optional<std::size_t> vertex;
    };
    std::vector<Link> ring;
    for (std::size_t i = 0; i < arrivals.size(); ++i) ring.push_back({i, std::nullopt});
    VertexSolution solution;
    solution.corners.resize(arrivals.size());

    const auto is_reached_earlier = [&](const SolvedVertex& vertex, std::size_t base, std::size_t i) {
        const geodesic::ChartPeriods& periods = flow.metric().periods();
        const auto target = vertex.arrivals[0].x + periods.translation(arrivals[i].lattice - arrivals[base].lattice);
        const auto other = geodesic::connect(flow, target, arrivals[i].theta, vertex.distance);
        return other && other->t < vertex.distance;
    };
    const auto close_side = [&](const Link& link, const Link& next, std::size_t vertex) {
        if (link.vertex)
            solution.arcs.push_back({*link.vertex, vertex, gaps[link.arrival], gaps[next.arrival]});
        else
            solution.corners[link.arrival] = vertex;
    };
    while (ring.size() >= 3) {
        bool is_cut = false;
        for (std::size_t k = 0; k < ring.size() && !is_cut; ++k) {
            const Link a = ring[k], b = ring[(k + 1) % ring.size()], c = ring[(k + 2) % ring.size()];
            auto vertex = common_point(flow, arrivals, gaps, {a.arrival, b.arrival, c.arrival}, t, coincidence);
            if (!vertex) continue;
            const bool is_free = std::none_of(ring.begin(), ring.end(), [&](const Link& link) {
                return link.arrival != a.arrival && link.arrival != b.arrival && link.arrival != c.arrival &&
                       is_reached_earlier(*vertex, a.arrival, link.arrival);
            });
            if (!is_free) continue;
            const std::size_t index = solution.vertices.size();
            solution.vertices.push_back(std::move(*vertex));
            close_side(a, b, index);
            close_side(b, c, index);
            if (ring.size() == 3) {
                close_side(c, a, index);
                return solution;
            }
            ring[k].vertex = index;
            ring.erase(ring.begin() + static_cast<std::ptrdiff_t>((k + 1) % ring.size()));
            is_cut = true;
        }
        if (!is_cut) break;
    }
    return failed("the geodesics around a vertex don't meet");
}

VertexSolution solve_branch(GeodesicFlow& flow, const Gluing& gluing, std::span<const DirectionPair> pairs,
                            const Gluing::Walk& walk, double coincidence) {
    std::vector<Arrival> arrivals;
    LatticeVector lattice(0, 0);
    double t = 0;
    for (int gap : walk.gaps) {
        arrivals.push_back({GapRange(gluing, gap).middle(), lattice});
        lattice += crossing(gluing, pairs, gluing.wrapped(gap + 1));
        t = std::max(t, pair_at(gluing, pairs, gap + 1).t);
    }
    if (lattice != LatticeVector(0, 0)) return failed("the pairs around a vertex don't close");
    std::vector<std::size_t> all(arrivals.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;

    VertexSolution solution;
    if (auto vertex = common_point(flow, arrivals, walk.gaps, all, t, coincidence)) {
        solution.vertices.push_back(std::move(*vertex));
        solution.corners.assign(arrivals.size(), 0);
    } else if (arrivals.size() > 3) {
        solution = resolve(flow, arrivals, walk.gaps, t, coincidence);
    } else {
        return failed("three geodesics don't meet where a branch point should be");
    }
    for (const SolvedVertex& vertex : solution.vertices) {
        const std::vector<int> overtaken = overtaken_pairs(gluing, vertex);
        solution.overtaken_pairs.insert(solution.overtaken_pairs.end(), overtaken.begin(), overtaken.end());
    }
    return solution;
}

}  // namespace

std::size_t SolvedVertex::arrival_in(int gap) const {
    const auto position = std::find(gaps.begin(), gaps.end(), gap);
    DSC_ASSERT(position != gaps.end());
    return static_cast<std::size_t>(position - gaps.begin());
}

VertexSolution solve_vertex(GeodesicFlow& flow, const Gluing& gluing, std::span<const DirectionPair> pairs,
                            const Gluing::Walk& walk, std::optional<double> max_distance, double coincidence) {
    if (!walk.is_closed) {
        DSC_ASSERT(max_distance);
        return solve_frontier(flow, gluing, pairs, walk, *max_distance);
    }
    if (walk.gaps.size() == 1) return solve_end(flow, gluing, pairs, walk);
    return solve_branch(flow, gluing, pairs, walk, coincidence);
}

}  // namespace dsc::cutlocus
