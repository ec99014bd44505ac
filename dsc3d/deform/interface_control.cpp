// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/interface_control.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/sort_unique.h"
#include "dsc3d/deform/move_to_link.h"

namespace dsc::dsc3d {

namespace {

// Inside the domain: what may be changed without a thought for walls.
bool is_inner_edge(const Complex& complex, EdgeId e) {
    if (complex.is_deleted(e)) return false;
    const auto [a, b] = complex.vertices(e);
    return complex.is_interface(e) && !complex.is_boundary(a) && !complex.is_boundary(b);
}

// The vertices opposite to e in its two triangles.
std::optional<std::array<VertexId, 2>> opposite_vertices(const Complex& complex, EdgeId e, EdgeRing& ring) {
    if (complex.is_boundary(e) || complex.surface_degree(e) != 2) return std::nullopt;
    gather_ring(complex, e, ring);
    std::array<VertexId, 2> opposite;
    std::size_t count = 0;
    const std::size_t n = ring.tets.size();
    for (std::size_t i = 0; i < n; ++i)
        if (complex.label(ring.tets[i]) != complex.label(ring.tets[(i + n - 1) % n])) opposite[count++] = ring.link[i];
    DSC_ASSERT(count == 2);
    return opposite;
}

}  // namespace

InterfaceControl::InterfaceControl(const Mesh& mesh) : seen_length_(mesh.complex().edge_attributes(), 0.0) {}

void InterfaceControl::reconsider() { seen_length_.fill(0); }

void InterfaceControl::accept(const PassContext& context) {
    const Complex& complex = context.complex();
    for (std::uint32_t i = 0; i < complex.edge_capacity(); ++i) {
        const EdgeId e(i);
        if (!complex.is_deleted(e) && complex.is_interface(e)) seen_length_[e] = context.relative_length(e);
    }
}

// Rigid motion changes lengths by rounding.
bool InterfaceControl::has_changed(const PassContext& context, EdgeId e) const {
    constexpr double rounding = 1e-7;
    const double length = context.relative_length(e);
    return std::abs(length - seen_length_[e]) > rounding * length;
}

std::vector<EdgeId> InterfaceControl::changed_edges(PassContext& context) const {
    std::vector<EdgeId> edges = context.region.interface_edges(context.complex());
    std::erase_if(edges, [&](EdgeId e) { return !has_changed(context, e); });
    return edges;
}

void InterfaceControl::run(PassContext& context) {
    std::vector<EdgeId> edges = changed_edges(context);
    std::vector<VertexId> vertices;
    for (const EdgeId e : edges) {
        const auto [a, b] = context.complex().vertices(e);
        vertices.insert(vertices.end(), {a, b});
    }
    context.region.clear();
    if (context.parameters.collapses_interface) {
        collapse_short_edges(context, edges);
        remove_degenerate_edges(context, edges);
        retract_threads(context, vertices);
    }
    if (context.parameters.flips_interface) remove_caps(context, edges);
    if (context.parameters.splits_interface) split_long_edges(context, edges);
    const std::vector<EdgeId> new_edges = context.region.interface_edges(context.complex());
    const std::vector<VertexId> new_vertices = context.region.interface_vertices(context.complex());
    edges.insert(edges.end(), new_edges.begin(), new_edges.end());
    vertices.insert(vertices.end(), new_vertices.begin(), new_vertices.end());
    core::sort_unique(edges);
    core::sort_unique(vertices);
    if (context.parameters.flips_interface) flip_edges(context, edges);
    if (context.parameters.smooths_interface) smooth_vertices(context, vertices);
    for (const EdgeId e : edges)
        if (!context.complex().is_deleted(e) && context.complex().is_interface(e))
            seen_length_[e] = context.relative_length(e);
}

void InterfaceControl::collapse_short_edges(PassContext& context, std::span<const EdgeId> candidates) {
    const Complex& complex = context.complex();
    const auto is_short = [&](EdgeId e) {
        return is_inner_edge(complex, e) &&
               surface::is_too_short(context.relative_length(e), context.parameters.interface_lengths);
    };
    std::vector<std::pair<double, EdgeId>> edges;
    for (const EdgeId e : candidates)
        if (is_short(e)) edges.emplace_back(context.relative_length(e), e);
    std::sort(edges.begin(), edges.end());
    for (const auto& [length, e] : edges)
        if (is_short(e)) context.report.counts.collapses += collapse(context, e) ? 1 : 0;
    context.region.settle(complex);
}

bool InterfaceControl::collapse(PassContext& context, EdgeId e) {
    const auto [a, b] = context.complex().vertices(e);
    const std::optional<Point3> place = surface::collapsed_position(
        ring_.gather(context.mesh, a), other_ring_.gather(context.mesh, b), context.parameters.interface_collapse);
    return place && collapse_to(context, e, *place);
}

bool InterfaceControl::collapse_to(PassContext& context, EdgeId e, const Point3& place) {
    const auto [a, b] = context.complex().vertices(e);
    // The end that is at the place, if one is, keeps its handle.
    const VertexId kept = place == context.mesh.position(b) ? b : a;
    const VertexId gone = kept == a ? b : a;
    if (!collapse_.collapse_at(context.mesh, e, kept, place, context.parameters.interface_quality)) return false;
    context.listener.on_interface_collapse(gone, kept);
    context.region.add_star(context.mesh, kept);
    return true;
}

// Thesis 4.3.2.1: what is shorter than this is no shape but an accident, of a contact as a rule.
void InterfaceControl::remove_degenerate_edges(PassContext& context, std::span<const EdgeId> candidates) {
    const Complex& complex = context.complex();
    for (const EdgeId e : candidates) {
        if (!is_inner_edge(complex, e) || context.relative_length(e) >= context.parameters.degenerate_edge) continue;
        const auto [a, b] = complex.vertices(e);
        const Point3 place = surface::dominant_position(
            ring_.gather(context.mesh, a), other_ring_.gather(context.mesh, b), context.parameters.interface_collapse);
        context.report.counts.collapses += collapse_to(context, e, place) ? 1 : 0;
    }
    context.region.settle(complex);
}

// Vertex by vertex from the ends. Where a thread is held its edges do not change, but it is behind its targets.
void InterfaceControl::retract_threads(PassContext& context, std::span<const VertexId> candidates) {
    std::vector<VertexId> waiting(candidates.begin(), candidates.end());
    for (const auto& late : context.report.unfinished) waiting.push_back(late.vertex);
    while (!waiting.empty()) {
        const VertexId end = waiting.back();
        waiting.pop_back();
        if (!thread_end_.find(context, end)) continue;
        const VertexId kept = collapse_thread_end(context, end);
        if (!kept.is_valid()) {
            pull_thread_end(context, end);
            continue;
        }
        ++context.report.counts.collapses;
        for (const TetId t : context.mesh.walker().star(kept)) {
            const TetVertices& corners = context.complex().vertices(t);
            waiting.insert(waiting.end(), corners.begin(), corners.end());
        }
    }
    context.region.settle(context.complex());
}

// Precondition of both: the thread end that was found last is `end`.
VertexId InterfaceControl::collapse_thread_end(PassContext& context, VertexId end) {
    for (const auto& [length, e] : thread_end_.spokes()) {
        const auto [a, b] = context.complex().vertices(e);
        const VertexId kept = a == end ? b : a;
        if (!context.complex().is_boundary(kept) && collapse_to(context, e, context.mesh.position(kept))) return kept;
    }
    return VertexId();
}

// Along the thread, as far as what is around it lets it go for now.
void InterfaceControl::pull_thread_end(PassContext& context, VertexId end) {
    const auto [a, b] = context.complex().vertices(thread_end_.shortest_along());
    const Point3 target = context.mesh.position(a == end ? b : a);
    move_to_link(context.mesh, end, target,
                 {.least_quality = context.parameters.interface_quality, .approach = context.parameters.approach});
    context.region.add_star(context.mesh, end);
}

// A triangle that is that low over its longest edge gives this edge up, bent as it may be.
void InterfaceControl::remove_caps(PassContext& context, std::span<const EdgeId> candidates) {
    const Complex& complex = context.complex();
    for (const EdgeId e : candidates) {
        if (!is_inner_edge(complex, e)) continue;
        const auto opposite = opposite_vertices(complex, e, edge_ring_);
        if (!opposite) continue;
        const Point3 &a = context.mesh.position(complex.vertices(e)[0]),
                     &b = context.mesh.position(complex.vertices(e)[1]);
        const Eigen::Vector3d along = (b - a).normalized();
        const double lowest = context.parameters.degenerate_height * (b - a).norm() / context.relative_length(e);
        const bool is_cap = std::any_of(opposite->begin(), opposite->end(), [&](VertexId v) {
            const Eigen::Vector3d side = context.mesh.position(v) - a;
            const double foot = side.dot(along);
            return foot > 0 && foot < (b - a).norm() && (side - foot * along).norm() < lowest;
        });
        if (is_cap) context.report.counts.flips += flip(context, e, context.parameters.interface_quality) ? 1 : 0;
    }
    context.region.settle(complex);
}

// The tetrahedra at e don't become worse than they are, or than this. Precondition: the last edge ring is that of e.
bool InterfaceControl::flip(PassContext& context, EdgeId e, double quality) {
    const auto [a, b] = context.complex().vertices(e);
    const double wanted = std::min(context.mesh.worst_quality(edge_ring_.tets), quality);
    if (!edge_removal_.propose_flip(context.mesh, e, proposal_, wanted) || !context.mesh.apply(proposal_)) return false;
    context.region.add_star(context.mesh, a);
    context.region.add_star(context.mesh, b);
    return true;
}

void InterfaceControl::split_long_edges(PassContext& context, std::span<const EdgeId> candidates) {
    const Complex& complex = context.complex();
    std::vector<std::pair<double, EdgeId>> edges;
    for (const EdgeId e : candidates) {
        if (!is_inner_edge(complex, e)) continue;
        const double length = context.relative_length(e);
        if (surface::is_too_long(length, context.parameters.interface_lengths)) edges.emplace_back(-length, e);
    }
    std::sort(edges.begin(), edges.end());
    for (const auto& [length, e] : edges) {
        const auto [a, b] = complex.vertices(e);
        const Point3 place = surface::split_position(ring_.gather(context.mesh, a), other_ring_.gather(context.mesh, b),
                                                     context.parameters.interface_split);
        VertexId m = context.mesh.split(e, place);
        if (!m.is_valid()) m = context.mesh.split(e, context.middle(e));
        if (!m.is_valid()) continue;
        context.wanted_length.set(m, 0.5 * (context.wanted_length.at(a) + context.wanted_length.at(b)));
        ++context.report.counts.edge_splits;
        context.listener.on_interface_split(m, a, b, 0.5);
        context.region.add_star(context.mesh, m);
    }
    context.region.settle(complex);
}

void InterfaceControl::flip_edges(PassContext& context, std::span<const EdgeId> candidates) {
    const Complex& complex = context.complex();
    for (const EdgeId e : candidates) {
        if (!is_inner_edge(complex, e)) continue;
        const auto opposite = opposite_vertices(complex, e, edge_ring_);
        if (!opposite) continue;
        const auto [a, b] = complex.vertices(e);
        const auto& p = context.mesh.mesh().positions();
        // Whichever way round: the gain is that of the pair.
        if (!surface::flip_gain(p[a], p[b], p[(*opposite)[0]], p[(*opposite)[1]], context.parameters.interface_flip))
            continue;
        context.report.counts.flips += flip(context, e, context.parameters.interface_quality) ? 1 : 0;
    }
    context.region.settle(complex);
}

void InterfaceControl::smooth_vertices(PassContext& context, std::span<const VertexId> candidates) {
    const Complex& complex = context.complex();
    for (const VertexId v : candidates) {
        if (complex.is_deleted(v) || !complex.is_interface(v) || complex.is_boundary(v)) continue;
        const std::optional<Point3> place =
            surface::smoothed_position(ring_.gather(context.mesh, v), context.parameters.interface_smoothing);
        if (!place) continue;
        const std::span<const TetId> star = context.mesh.walker().star(v);
        const double least = std::min(context.mesh.worst_quality(star), context.parameters.interface_quality);
        if (!context.mesh.move(v, *place, star, least)) continue;
        ++context.report.counts.smoothings;
        context.region.add(star);
    }
    context.region.settle(complex);
}

}  // namespace dsc::dsc3d
