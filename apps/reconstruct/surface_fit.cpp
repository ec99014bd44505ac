// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/surface_fit.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "core/parallel.h"
#include "core/require.h"
#include "surface/triangle.h"

namespace dsc::reconstruct {

namespace {

using Triangles = std::vector<std::array<VertexId, 2>>;

class SurfaceFit {
public:
    SurfaceFit(Workbench& bench, const SurfaceModel& model, const std::function<double(const Point3&)>& wanted,
               const SurfaceFitParameters& parameters, core::Observer& observer)
        : bench_(bench),
          model_(model),
          wanted_(wanted),
          parameters_(parameters),
          observer_(observer),
          side_cosine_(std::cos(surface::radians(model.parameters().side_angle))),
          place_(bench.complex().vertex_attributes(), SurfacePlace()),
          target_(bench.complex().vertex_attributes(), Point3(Point3::Zero())),
          error_(bench.complex().vertex_attributes(), 0.0) {}

    SurfaceFitCounts run(const FitWatcher& watcher) {
        const auto end_stage = [&](const char* stage) {
            if (watcher) watcher(stage);
        };
        for (int i = 0; i < parameters_.approaches; ++i) approach(i + 1 < parameters_.approaches);
        collapse_short_edges();
        end_stage("patches");
        for (int round = 0; round < parameters_.rounds; ++round) {
            observer_.check_cancelled();
            observer_.progress("fitting", static_cast<double>(round) / parameters_.rounds, "");
            claim_creases();
            cut_crossing_edges();
            collapse_short_edges();
            flip_edges();
            settle(round + 1 < parameters_.rounds);
            flip_edges();
        }
        end_stage("creases");
        refine();
        flip_edges();
        decimate();
        flip_edges();
        balance();
        end_stage("coarsened");
        for (const VertexId v : bench_.interface_vertices()) {
            counts_.crease_vertices += place_[v].sides == 2 ? 1 : 0;
            counts_.corners += place_[v].sides == 3 ? 1 : 0;
        }
        return counts_;
    }

private:
    // ---- what is where

    Vector3 normal(VertexId a, VertexId b, VertexId c) const {
        return surface::unit_normal(bench_.position(a), bench_.position(b), bench_.position(c));
    }
    double length(EdgeId e) const {
        const auto [a, b] = bench_.complex().vertices(e);
        return (bench_.position(a) - bench_.position(b)).norm();
    }
    Point3 ring_mean(const Triangles& ring) const {
        Point3 sum = Point3::Zero();
        for (const auto& [b, c] : ring) sum += bench_.position(b);
        return sum / static_cast<double>(ring.size());
    }
    bool shares_side(const Vector3& n, const SurfacePlace& place) const {
        for (int i = 0; i < place.sides; ++i)
            if (place.normals[static_cast<std::size_t>(i)].dot(n) > side_cosine_) return true;
        return false;
    }
    bool share_side(const SurfacePlace& a, const SurfacePlace& b) const {
        for (int i = 0; i < a.sides; ++i)
            if (shares_side(a.normals[static_cast<std::size_t>(i)], b)) return true;
        return false;
    }
    /// Every side of a is one of b.
    bool is_within(const SurfacePlace& a, const SurfacePlace& b) const {
        for (int i = 0; i < a.sides; ++i)
            if (!shares_side(a.normals[static_cast<std::size_t>(i)], b)) return false;
        return true;
    }

    void move_to_targets(std::span<const VertexId> vertices) {
        bench_.move(vertices, target_);
        bench_.keep_up();
    }

    // ---- passes

    // Vertices to the patch of the nearest side, and towards the middle of their neighbours along it.
    void approach(bool relaxes) {
        const std::vector<VertexId> vertices = bench_.interface_vertices();
        const std::vector<Point3> from = relaxed_positions(vertices, relaxes ? 0.5 : 0);
        core::parallel_for(vertices.size(), {.threads = model_.threads()}, [&](std::size_t i) {
            place_[vertices[i]] = model_.place(from[i], 0, 0);
            target_[vertices[i]] = place_[vertices[i]].point;
        });
        limit_targets(vertices);
        move_to_targets(vertices);
    }

    std::vector<Point3> relaxed_positions(std::span<const VertexId> vertices, double share) {
        std::vector<Point3> places;
        Triangles ring;
        for (const VertexId v : vertices) {
            bench_.gather_ring(v, ring);
            places.push_back(share > 0 ? Point3((1 - share) * bench_.position(v) + share * ring_mean(ring))
                                       : bench_.position(v));
        }
        return places;
    }

    // No farther than a wanted edge: what is farther away belongs to another part.
    void limit_targets(std::span<const VertexId> vertices) {
        for (const VertexId v : vertices) {
            const Vector3 way = target_[v] - bench_.position(v);
            const double most = wanted_(bench_.position(v));
            if (way.norm() > most) target_[v] = bench_.position(v) + way * (most / way.norm());
        }
    }

    // Vertices within reach of a crease or corner go there, the nearest ones first, corners before creases.
    void claim_creases() {
        const std::vector<VertexId> vertices = bench_.interface_vertices();
        std::vector<SurfacePlace> found(vertices.size());
        std::vector<double> edge(vertices.size());
        core::parallel_for(vertices.size(), {.threads = model_.threads()}, [&](std::size_t i) {
            edge[i] = wanted_(bench_.position(vertices[i]));
            found[i] = model_.place(bench_.position(vertices[i]), parameters_.corner_reach * edge[i],
                                    parameters_.claim_reach * edge[i]);
        });
        struct Claim {
            int sides;
            double distance;
            std::size_t at;
            bool operator<(const Claim& other) const {
                if (sides != other.sides) return sides > other.sides;
                return distance != other.distance ? distance < other.distance : at < other.at;
            }
        };
        std::vector<Claim> claims;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            if (found[i].sides > 1)
                claims.push_back({found[i].sides, (found[i].point - bench_.position(vertices[i])).norm(), i});
            place_[vertices[i]] = found[i].sides > 1 ? SurfacePlace() : found[i];
        }
        std::sort(claims.begin(), claims.end());
        Triangles ring;
        for (const Claim& claim : claims) {
            const VertexId v = vertices[claim.at];
            bench_.gather_ring(v, ring);
            const auto is_taken = [&](const SurfacePlace& place) {
                return std::any_of(ring.begin(), ring.end(), [&](const auto& pair) {
                    const SurfacePlace& other = place_[pair[0]];
                    return other.sides > 1 && other.sides >= place.sides &&
                           (other.point - place.point).norm() < parameters_.claim_distance * edge[claim.at];
                });
            };
            place_[v] = found[claim.at];
            if (place_[v].sides == 3 && is_taken(place_[v]))
                place_[v] = model_.place(bench_.position(v), 0, parameters_.claim_reach * edge[claim.at]);
            if (place_[v].sides == 2 && is_taken(place_[v])) place_[v] = model_.place(bench_.position(v), 0, 0);
        }
        for (const VertexId v : vertices) target_[v] = place_[v].point;
        limit_targets(vertices);
        move_to_targets(vertices);
    }

    // Edges between different sides get a vertex where the sides meet.
    void cut_crossing_edges() {
        std::vector<EdgeId> edges = bench_.interface_edges();
        constexpr int most_rounds = 3;
        for (int round = 0; round < most_rounds && !edges.empty(); ++round) {
            std::vector<std::pair<double, EdgeId>> crossing;
            for (const EdgeId e : edges) {
                if (bench_.complex().is_deleted(e) || !bench_.complex().is_interface(e)) continue;
                const auto [a, b] = bench_.complex().vertices(e);
                if (!share_side(place_[a], place_[b])) crossing.emplace_back(-length(e), e);
            }
            std::sort(crossing.begin(), crossing.end());
            std::vector<VertexId> added;
            for (const auto& [key, e] : crossing) {
                const VertexId m = cut(e);
                if (m.is_valid()) added.push_back(m);
            }
            move_to_targets(added);
            edges.clear();
            for (const EdgeId e : bench_.interface_edges()) {
                const auto [a, b] = bench_.complex().vertices(e);
                if (std::binary_search(added.begin(), added.end(), a) ||
                    std::binary_search(added.begin(), added.end(), b))
                    edges.push_back(e);
            }
        }
    }

    VertexId cut(EdgeId e) {
        const auto [a, b] = bench_.complex().vertices(e);
        const Point3 &p = bench_.position(a), &q = bench_.position(b);
        const double edge = (q - p).norm();
        if (edge < parameters_.short_edge * wanted_(p)) return {};
        // Where the tangent planes at the ends meet.
        const double beyond_a = std::abs((q - p).dot(place_[a].normals[0]));
        const double beyond_b = std::abs((q - p).dot(place_[b].normals[0]));
        const double sum = beyond_a + beyond_b;
        const double share =
            sum > 0 ? std::clamp(beyond_b / sum, parameters_.cut_margin, 1 - parameters_.cut_margin) : 0.5;
        const Point3 at = p + share * (q - p);
        const SurfacePlace place = model_.place(at, 0.7 * edge, 0.7 * edge);
        const VertexId m = bench_.split(e, at);
        if (!m.is_valid()) return m;
        place_[m] = place;
        target_[m] = place.point;
        ++counts_.cuts;
        return m;
    }

    // The vertex that an edge may be collapsed to: the one with more sides, when it has those of the other one.
    std::optional<VertexId> kept_end(EdgeId e) const {
        auto [a, b] = bench_.complex().vertices(e);
        if (place_[b].sides > place_[a].sides) std::swap(a, b);
        if (place_[b].sides == 3 || !is_within(place_[b], place_[a])) return std::nullopt;
        return a;
    }

    // No triangle at `gone` turns by more than the cosine says when it goes to where `kept` is.
    bool keeps_normals(VertexId gone, VertexId kept, const Point3& place, double least_cosine) {
        bench_.gather_ring(gone, ring_);
        for (const auto& [b, c] : ring_) {
            if (b == kept || c == kept) continue;
            const Vector3 after = surface::unit_normal(place, bench_.position(b), bench_.position(c));
            if (after.dot(normal(gone, b, c)) < least_cosine) return false;
        }
        return true;
    }

    void collapse_short_edges() {
        std::vector<std::pair<double, EdgeId>> edges;
        for (const EdgeId e : bench_.interface_edges()) {
            const double relative = length(e) / wanted_(bench_.position(bench_.complex().vertices(e)[0]));
            if (relative < parameters_.short_edge) edges.emplace_back(relative, e);
        }
        std::sort(edges.begin(), edges.end());
        constexpr double least_cosine = 0.3;
        for (const auto& [relative, e] : edges) {
            if (bench_.complex().is_deleted(e) || !bench_.complex().is_interface(e)) continue;
            const auto [a, b] = bench_.complex().vertices(e);
            if (length(e) >= parameters_.short_edge * wanted_(bench_.position(a))) continue;
            const std::optional<VertexId> kept = kept_end(e);
            if (!kept) continue;
            const VertexId gone = *kept == a ? b : a;
            if (!keeps_normals(gone, *kept, bench_.position(*kept), least_cosine)) continue;
            counts_.collapses += bench_.collapse(e, *kept, bench_.position(*kept)) ? 1 : 0;
        }
        bench_.keep_up();
    }

    // Area times how much the triangle's normal is off the side that its vertices share.
    double misfit(VertexId a, VertexId b, VertexId c) const {
        const Vector3 vector = surface::area_vector(bench_.position(a), bench_.position(b), bench_.position(c));
        const double area = vector.norm();
        double best = -1;
        const SurfacePlace& place = place_[a];
        for (int i = 0; i < place.sides; ++i) {
            const Vector3& n = place.normals[static_cast<std::size_t>(i)];
            if (shares_side(n, place_[b]) && shares_side(n, place_[c])) best = std::max(best, vector.dot(n) / area);
        }
        return area * (1 - best);
    }

    void flip_edges() {
        constexpr int most_rounds = 3;
        std::vector<EdgeId> edges = bench_.interface_edges();
        for (int round = 0; round < most_rounds; ++round) {
            std::size_t flips = 0;
            for (const EdgeId e : edges) flips += flip(e) ? 1 : 0;
            counts_.flips += flips;
            if (flips == 0) break;
            edges = bench_.interface_edges();
        }
        bench_.keep_up();
    }

    bool flip(EdgeId e) {
        std::array<VertexId, 2> ends, others;
        if (!bench_.opposite(e, ends, others)) return false;
        const auto [a, b] = ends;
        const auto [c, d] = others;
        const Point3 &p = bench_.position(a), &q = bench_.position(b), &r = bench_.position(c), &s = bench_.position(d);
        const double area = surface::area_vector(p, q, r).norm() + surface::area_vector(q, p, s).norm();
        const double gain = misfit(a, b, c) + misfit(b, a, d) - misfit(a, d, c) - misfit(d, b, c);
        const double angle_before = std::min(surface::min_angle(p, q, r), surface::min_angle(q, p, s));
        const double angle_after = std::min(surface::min_angle(p, s, r), surface::min_angle(s, q, r));
        // The sides decide; where they don't, the shape of the triangles.
        constexpr double clear_gain = 0.004, no_loss = 0.0005, least_angle = 0.03, angle_gain = 0.05;
        const bool fits_better = gain > clear_gain * area && angle_after > least_angle;
        const bool looks_better = gain > -no_loss * area && angle_after > angle_before + angle_gain;
        return (fits_better || looks_better) && bench_.flip(e);
    }

    // Every vertex to its patch, crease or corner again, which may have moved by what was done around it.
    void settle(bool relaxes) {
        const std::vector<VertexId> vertices = bench_.interface_vertices();
        const std::vector<Point3> from = relaxed_positions(vertices, relaxes ? 0.5 : 0.25);
        core::parallel_for(vertices.size(), {.threads = model_.threads()}, [&](std::size_t i) {
            const VertexId v = vertices[i];
            if (place_[v].is_smooth()) {
                const std::optional<SurfacePlace> place = model_.smooth_place(from[i], place_[v].normals[0]);
                if (place) place_[v] = *place;
                target_[v] = place_[v].point;
            } else {
                const double edge = wanted_(bench_.position(v));
                const SurfacePlace place =
                    model_.place(bench_.position(v), place_[v].sides == 3 ? parameters_.corner_reach * edge : 0,
                                 parameters_.claim_reach * edge);
                if (place.sides == place_[v].sides && is_within(place, place_[v])) place_[v] = place;
                target_[v] = place_[v].point;
            }
        });
        limit_targets(vertices);
        move_to_targets(vertices);
    }

    // Edges that are off the surface in their middle get a vertex there: along creases, and on patches.
    void refine() {
        for (int round = 0; round < parameters_.refinements; ++round) {
            const std::vector<EdgeId> edges = bench_.interface_edges();
            std::vector<SurfacePlace> middles(edges.size());
            core::parallel_for(edges.size(), {.threads = model_.threads()},
                               [&](std::size_t i) { middles[i] = place_of_middle(edges[i]); });
            std::vector<std::pair<double, std::size_t>> far;
            for (std::size_t i = 0; i < edges.size(); ++i) {
                if (middles[i].sides == 0) continue;
                const double off = (middles[i].point - middle(edges[i])).norm();
                if (off > parameters_.refinement && off < 0.5 * length(edges[i])) far.emplace_back(-off, i);
            }
            std::sort(far.begin(), far.end());
            std::vector<VertexId> added;
            for (const auto& [key, i] : far) {
                if (bench_.complex().is_deleted(edges[i])) continue;
                const VertexId m = bench_.split(edges[i], middle(edges[i]));
                if (!m.is_valid()) continue;
                place_[m] = middles[i];
                target_[m] = middles[i].point;
                ++counts_.cuts;
                added.push_back(m);
            }
            move_to_targets(added);
        }
    }

    Point3 middle(EdgeId e) const {
        const auto [a, b] = bench_.complex().vertices(e);
        return 0.5 * (bench_.position(a) + bench_.position(b));
    }

    /// Unknown for edges that are short or between different sides.
    SurfacePlace place_of_middle(EdgeId e) const {
        const auto [a, b] = bench_.complex().vertices(e);
        const SurfacePlace &one = place_[a], &other = place_[b];
        const double edge = length(e);
        if (edge < parameters_.shortest_refined * wanted_(bench_.position(a))) return {};
        if (one.is_smooth() || other.is_smooth()) {
            const SurfacePlace &smooth = one.is_smooth() ? one : other, &rest = one.is_smooth() ? other : one;
            if (!is_within(smooth, rest)) return {};
            Vector3 n = smooth.normals[0];
            if (rest.is_smooth()) n = (n + rest.normals[0]).normalized();
            return model_.smooth_place(middle(e), n).value_or(SurfacePlace());
        }
        const SurfacePlace place = model_.place(middle(e), 0, 0.5 * edge);
        return place.sides == 2 && is_within(place, one) && is_within(place, other) ? place : SurfacePlace();
    }

    // Vertices whose absence moves the surface by next to nothing go: it is as fine as it has to be.
    void decimate() {
        if (parameters_.decimation == 0) return;
        struct Candidate {
            double cost;
            EdgeId edge;
            VertexId gone, kept;
            bool operator>(const Candidate& other) const {
                return cost != other.cost ? cost > other.cost : edge.index() > other.edge.index();
            }
        };
        std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue;
        const auto offer = [&](EdgeId e) {
            const auto [a, b] = bench_.complex().vertices(e);
            for (const auto& [gone, kept] : {std::pair{a, b}, std::pair{b, a}}) {
                const std::optional<double> cost = cost_of_collapse(gone, kept);
                if (cost) queue.push({*cost, e, gone, kept});
            }
        };
        for (const EdgeId e : bench_.interface_edges()) offer(e);
        std::vector<EdgeId> around;
        while (!queue.empty()) {
            const Candidate next = queue.top();
            queue.pop();
            const dsc3d::Complex& complex = bench_.complex();
            if (complex.is_deleted(next.edge) || !complex.is_interface(next.edge)) continue;
            const auto [a, b] = complex.vertices(next.edge);
            if (!((a == next.gone && b == next.kept) || (b == next.gone && a == next.kept))) continue;
            const std::optional<double> cost = cost_of_collapse(next.gone, next.kept);
            if (!cost) continue;
            if (*cost > next.cost * (1 + 1e-9) + 1e-15) {
                queue.push({*cost, next.edge, next.gone, next.kept});
                continue;
            }
            if (!bench_.collapse(next.edge, next.kept, bench_.position(next.kept))) continue;
            error_[next.kept] = std::max(error_[next.kept], *cost);
            ++counts_.decimated;
        }
        bench_.keep_up();
    }

    // How far the surface moves when `gone` goes to `kept`: by its distance from the planes of what takes its place, on
    // top of what it has moved before. None when that is too far, or spoils triangles.
    std::optional<double> cost_of_collapse(VertexId gone, VertexId kept) {
        const SurfacePlace &from = place_[gone], &to = place_[kept];
        if (from.sides == 0 || from.sides == 3 || !is_within(from, to)) return std::nullopt;
        const Point3 &p = bench_.position(gone), &q = bench_.position(kept);
        bench_.gather_ring(gone, ring_);
        const double longest = parameters_.longest_edge * wanted_(p);
        constexpr double least_angle = 0.15, least_cosine = 0.97;
        double cost = 0;
        int creases = 0;
        bool is_along_crease = false;
        for (const auto& [b, c] : ring_) {
            if (place_[b].sides > 1 && from.sides > 1) {
                const Vector3 way = (bench_.position(b) - p).normalized();
                ++creases;
                is_along_crease = is_along_crease || b == kept || way.dot((q - p).normalized()) < -least_cosine;
            }
            if (b == kept || c == kept) continue;
            const Point3 &r = bench_.position(b), &s = bench_.position(c);
            if ((r - q).norm() > longest) return std::nullopt;
            const Vector3 after = surface::unit_normal(q, r, s);
            if (after.dot(normal(gone, b, c)) < least_cosine) return std::nullopt;
            const double angle = surface::min_angle(q, r, s);
            if (angle < least_angle && angle < surface::min_angle(p, r, s)) return std::nullopt;
            cost = std::max(cost, std::abs((p - q).dot(after)));
        }
        if (from.sides == 2 && !is_along_crease) return std::nullopt;
        cost += error_[gone];
        return cost < parameters_.decimation ? std::optional(cost) : std::nullopt;
    }

    // Triangles between vertices on a curved patch lie behind it. Vertices go outwards by as much as their triangles
    // are off on average: of a paraboloid that is 3/4 of what they are off in the middle.
    void balance() {
        std::vector<VertexId> vertices = bench_.interface_vertices();
        std::erase_if(vertices, [&](VertexId v) { return !place_[v].is_smooth(); });
        std::vector<Triangles> rings(vertices.size());
        for (std::size_t i = 0; i < vertices.size(); ++i) bench_.gather_ring(vertices[i], rings[i]);
        core::parallel_for(vertices.size(), {.threads = model_.threads()}, [&](std::size_t i) {
            const VertexId v = vertices[i];
            const Vector3& n = place_[v].normals[0];
            double sum = 0, weights = 0;
            for (const auto& [b, c] : rings[i]) {
                const Point3 middle = (bench_.position(v) + bench_.position(b) + bench_.position(c)) / 3;
                const double area =
                    surface::area_vector(bench_.position(v), bench_.position(b), bench_.position(c)).norm();
                const std::optional<SurfacePlace> place = model_.smooth_place(middle, n);
                if (!place) continue;
                sum += area * (place->point - middle).dot(n);
                weights += area;
            }
            target_[v] = bench_.position(v);
            if (weights > 0) target_[v] += 0.75 * sum / weights * n;
        });
        move_to_targets(vertices);
    }

    Workbench& bench_;
    const SurfaceModel& model_;
    const std::function<double(const Point3&)>& wanted_;
    const SurfaceFitParameters& parameters_;
    core::Observer& observer_;
    double side_cosine_;
    core::Attribute<VertexId, SurfacePlace> place_;
    core::Attribute<VertexId, Point3> target_;
    core::Attribute<VertexId, double> error_;  ///< by which decimation has moved the surface there
    SurfaceFitCounts counts_;
    Triangles ring_;
};

}  // namespace

void SurfaceFitParameters::validate() const {
    core::require(approaches >= 1, "approaches", "at least 1");
    core::require(rounds >= 0, "rounds", "at least 0");
    core::require(claim_reach > 0, "claim_reach", "positive");
    core::require(corner_reach > 0, "corner_reach", "positive");
    core::require(claim_distance >= 0, "claim_distance", "at least 0");
    core::require(cut_margin > 0 && cut_margin < 0.5, "cut_margin", "in (0, 0.5)");
    core::require(short_edge >= 0, "short_edge", "at least 0");
    core::require(refinements >= 0, "refinements", "at least 0");
    core::require(refinement > 0, "refinement", "positive");
    core::require(shortest_refined > 0, "shortest_refined", "positive");
    core::require(decimation >= 0, "decimation", "at least 0");
    core::require(longest_edge > 0, "longest_edge", "positive");
}

SurfaceFitCounts fit_surface(Workbench& bench, const SurfaceModel& model,
                             const std::function<double(const Point3&)>& wanted, const SurfaceFitParameters& parameters,
                             core::Observer& observer, const FitWatcher& watcher) {
    parameters.validate();
    return SurfaceFit(bench, model, wanted, parameters, observer).run(watcher);
}

}  // namespace dsc::reconstruct
