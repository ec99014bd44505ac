// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/rim_control.h"

#include <algorithm>
#include <cmath>

#include "core/sort_unique.h"

namespace dsc::dsc3d {

namespace {

// Contact lines that turn by more have a corner there: the cosine of 40 degrees, as sharp edges are judged.
constexpr double corner_cosine = 0.77;

// ... and those that turn back by so much that 50 degrees are left between their edges, a spike.
constexpr double spike_cosine = 0.64;

bool is_at_wall(const Complex& complex, EdgeId e) {
    if (complex.is_deleted(e) || !complex.is_interface(e)) return false;
    const auto [a, b] = complex.vertices(e);
    return complex.is_boundary(a) || complex.is_boundary(b);
}

bool is_rim(const Complex& complex, EdgeId e) { return complex.is_boundary(e) && complex.is_interface(e); }

VertexMotion motion_at_wall(const PassContext& context, VertexId v) {
    return context.complex().is_boundary(v) ? context.mesh.surface().freedom(v).motion : VertexMotion::free;
}

}  // namespace

void RimControl::run(PassContext& context, std::span<const EdgeId> edges) {
    collapse_short_edges(context, edges);
    remove_spikes(context, edges);
    split_long_edges(context, edges);
    space_evenly(context, edges);
    context.region.settle(context.complex());
}

std::optional<std::array<VertexId, 2>> RimControl::neighbours(PassContext& context, VertexId v) {
    const Complex& complex = context.complex();
    along_.clear();
    for (const TetId t : context.mesh.walker().star(v))
        for (const EdgeId e : complex.edges(t)) {
            const auto [a, b] = complex.vertices(e);
            if ((a == v || b == v) && is_rim(complex, e)) along_.push_back(a == v ? b : a);
        }
    core::sort_unique(along_);
    if (along_.size() != 2 || context.mesh.surface().freedom(v).motion != VertexMotion::plane) return std::nullopt;
    return std::array{along_[0], along_[1]};
}

std::optional<double> RimControl::cosine_at(PassContext& context, VertexId v) {
    const auto ends = neighbours(context, v);
    if (!ends) return std::nullopt;
    const Point3& p = context.mesh.position(v);
    const Eigen::Vector3d a = context.mesh.position((*ends)[0]) - p, b = context.mesh.position((*ends)[1]) - p;
    return a.dot(b) / (a.norm() * b.norm());
}

bool RimControl::is_corner(PassContext& context, VertexId v) {
    return cosine_at(context, v).value_or(1) > -corner_cosine;
}

void RimControl::collapse_short_edges(PassContext& context, std::span<const EdgeId> candidates) {
    const Complex& complex = context.complex();
    const auto is_short = [&](EdgeId e) {
        return is_at_wall(complex, e) &&
               surface::is_too_short(context.relative_length(e), context.parameters.contact_line_lengths);
    };
    std::vector<std::pair<double, EdgeId>> edges;
    for (const EdgeId e : candidates)
        if (is_short(e)) edges.emplace_back(context.relative_length(e), e);
    std::sort(edges.begin(), edges.end());
    for (const auto& [length, e] : edges)
        if (is_short(e)) context.report.counts.collapses += collapse(context, e) ? 1 : 0;
}

// Of a line inside a wall any vertex may go that is no corner of it; to the wall, any that lies inside where that
// leaves the shape of the sheet.
bool RimControl::collapse(PassContext& context, EdgeId e) {
    const Complex& complex = context.complex();
    auto [kept, gone] = complex.vertices(e);
    if (motion_at_wall(context, kept) < motion_at_wall(context, gone)) std::swap(kept, gone);
    const bool is_degenerate = context.relative_length(e) < context.parameters.degenerate_edge;
    Point3 place = context.mesh.position(kept);
    if (complex.is_boundary(gone)) {
        if (!is_rim(complex, e) || motion_at_wall(context, gone) != VertexMotion::plane) return false;
        const bool kept_is_corner = is_corner(context, kept);
        if (is_corner(context, gone)) {
            if (kept_is_corner && !is_degenerate) return false;
            if (!kept_is_corner && motion_at_wall(context, kept) == VertexMotion::plane) {
                std::swap(kept, gone);
                place = context.mesh.position(kept);
            }
        } else if (!kept_is_corner) {
            place = context.middle(e);
        }
    } else if (!is_degenerate) {
        // As the shape of the sheets would have it; but the line stays where it is.
        if (!surface::collapsed_position(ring_.gather(context.mesh, kept), other_ring_.gather(context.mesh, gone),
                                         context.parameters.interface_collapse))
            return false;
    }
    return collapse_to(context, e, kept, place);
}

bool RimControl::collapse_to(PassContext& context, EdgeId e, VertexId kept, const Point3& place) {
    const auto [a, b] = context.complex().vertices(e);
    const VertexId gone = a == kept ? b : a;
    if (!collapse_.collapse_at(context.mesh, e, kept, place, context.parameters.interface_quality)) return false;
    context.listener.on_interface_collapse(gone, kept);
    context.region.add_star(context.mesh, kept);
    return true;
}

// Where the line turns back on itself, its tip gives way along the shorter of its two edges.
void RimControl::remove_spikes(PassContext& context, std::span<const EdgeId> candidates) {
    const Complex& complex = context.complex();
    for (const EdgeId e : candidates) {
        if (complex.is_deleted(e) || !is_rim(complex, e)) continue;
        for (const VertexId tip : EdgeVertices(complex.vertices(e))) {
            if (cosine_at(context, tip).value_or(-1) < spike_cosine) continue;
            const std::array<VertexId, 2> ends = *neighbours(context, tip);
            const auto distance = [&](VertexId v) {
                return (context.mesh.position(v) - context.mesh.position(tip)).norm();
            };
            const VertexId kept = distance(ends[0]) < distance(ends[1]) ? ends[0] : ends[1];
            const EdgeId edge = context.mesh.walker().edge_between(tip, kept);
            if (!collapse_to(context, edge, kept, context.mesh.position(kept))) continue;
            ++context.report.counts.collapses;
            break;
        }
    }
}

void RimControl::split_long_edges(PassContext& context, std::span<const EdgeId> candidates) {
    const Complex& complex = context.complex();
    std::vector<std::pair<double, EdgeId>> edges;
    for (const EdgeId e : candidates) {
        if (!is_at_wall(complex, e)) continue;
        const double length = context.relative_length(e);
        if (surface::is_too_long(length, context.parameters.contact_line_lengths)) edges.emplace_back(-length, e);
    }
    std::sort(edges.begin(), edges.end());
    for (const auto& [length, e] : edges) {
        const auto [a, b] = complex.vertices(e);
        const VertexId m = context.mesh.split(e, context.middle(e));
        if (!m.is_valid()) continue;
        context.wanted_length.set(m, 0.5 * (context.wanted_length.at(a) + context.wanted_length.at(b)));
        ++context.report.counts.edge_splits;
        context.listener.on_interface_split(m, a, b, 0.5);
        context.region.add_star(context.mesh, m);
    }
}

// Half-way to the middle between its neighbours, along the line that joins them.
void RimControl::space_evenly(PassContext& context, std::span<const EdgeId> edges) {
    const Complex& complex = context.complex();
    std::vector<VertexId> vertices;
    for (const EdgeId e : edges) {
        if (complex.is_deleted(e) || !is_rim(complex, e)) continue;
        const auto [a, b] = complex.vertices(e);
        vertices.insert(vertices.end(), {a, b});
    }
    core::sort_unique(vertices);
    for (const VertexId v : vertices) {
        if (is_corner(context, v)) continue;
        const auto ends = neighbours(context, v);
        const Point3 &p = context.mesh.position(v), &a = context.mesh.position((*ends)[0]),
                     &b = context.mesh.position((*ends)[1]);
        const Eigen::Vector3d along = (b - a).normalized();
        const Point3 place = context.mesh.on_boundary(v, p + 0.5 * along.dot(0.5 * (a + b) - p) * along);
        const std::span<const TetId> star = context.mesh.walker().star(v);
        const double least = std::min(context.mesh.worst_quality(star), context.parameters.interface_quality);
        if (!context.mesh.move(v, place, star, least)) continue;
        ++context.report.counts.smoothings;
        context.region.add(star);
    }
}

}  // namespace dsc::dsc3d
