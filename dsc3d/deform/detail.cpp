// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/detail.h"

#include <algorithm>
#include <limits>

namespace dsc::dsc3d {

void DetailControl::update_lengths(PassContext& context) {
    const std::vector<VertexId> vertices = context.region.vertices(context.complex());
    context.wanted_length.update(context.mesh, vertices);
    // What a collapse makes must not have to be split again.
    for (const VertexId v : vertices)
        context.mesh.set_longest_edge(v, context.parameters.max_edge * context.wanted_length.at(v));
}

void DetailControl::split_long_edges(PassContext& context) {
    const Complex& complex = context.complex();
    std::vector<std::pair<double, EdgeId>> edges;
    for (const EdgeId e : context.region.edges_off_interface(complex)) {
        const double length = context.relative_length(e);
        if (length > context.parameters.max_edge) edges.emplace_back(-length, e);
    }
    if (edges.empty()) return;
    std::sort(edges.begin(), edges.end());
    std::vector<VertexId> ends;
    for (const auto& [length, e] : edges) {
        const auto [a, b] = complex.vertices(e);
        if (!context.mesh.split(e, context.middle(e)).is_valid()) continue;
        ++context.report.counts.edge_splits;
        ends.insert(ends.end(), {a, b});
    }
    for (const VertexId v : ends) context.region.add_star(context.mesh, v);
    context.region.settle(complex);
    update_lengths(context);
}

void DetailControl::collapse_short_edges(PassContext& context) {
    collapse_edges(context, context.parameters.min_edge, std::numeric_limits<double>::infinity());
}

void DetailControl::collapse_edges(PassContext& context, double relative_length, double length) {
    const Complex& complex = context.complex();
    for (const EdgeId e : context.region.edges_off_interface(complex)) {
        if (complex.is_deleted(e) || context.relative_length(e) >= relative_length) continue;
        if (context.length(e) > length) continue;
        for (const VertexId kept : EdgeVertices(complex.vertices(e))) {
            if (!collapse_.propose(context.mesh, e, kept, context.parameters.collapse_quality, proposal_)) continue;
            if (!context.mesh.apply(proposal_)) continue;
            ++context.report.counts.collapses;
            context.region.add_star(context.mesh, kept);
            break;
        }
    }
    context.region.settle(complex);
}

}  // namespace dsc::dsc3d
