// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/surface_link.h"

#include <algorithm>

namespace dsc::dsc3d {

void SurfaceLink::gather(const Complex& complex, std::span<const TetId> star, VertexId v) {
    edges_.clear();
    for (const TetId t : star) {
        const int place = complex.index_of(t, v);
        for (int i = 0; i < 4; ++i) {
            const FaceId f = complex.faces(t)[static_cast<std::size_t>(i)];
            if (i == place || !complex.is_surface(f)) continue;
            EdgeVertices edge;
            std::size_t count = 0;
            for (const VertexId u : complex.vertices(f))
                if (u != v) edge[count++] = u;
            edges_.push_back(edge[0] < edge[1] ? edge : EdgeVertices{edge[1], edge[0]});
        }
    }
    // An interface face was seen from both sides.
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());

    arcs_.clear();
    for (const auto& [x, y] : edges_) {
        arcs_.push_back({x, y});
        arcs_.push_back({y, x});
    }
    std::sort(arcs_.begin(), arcs_.end());
    vertices_.clear();
    seams_.clear();
    for (std::size_t begin = 0, end = 0; begin < arcs_.size(); begin = end) {
        while (end < arcs_.size() && arcs_[end][0] == arcs_[begin][0]) ++end;
        vertices_.push_back(arcs_[begin][0]);
        if (end - begin != 2) seams_.push_back(arcs_[begin][0]);
    }
}

std::span<const EdgeVertices> SurfaceLink::arcs_at(VertexId x) const {
    const auto [begin, end] = std::equal_range(arcs_.begin(), arcs_.end(), EdgeVertices{x, x},
                                               [](const auto& a, const auto& b) { return a[0] < b[0]; });
    return {begin, end};
}

// Follows an arc of the link from `from` to the next seam, or around to `from`; returns the number of its edges.
std::size_t SurfaceLink::walk(VertexId from, EdgeVertices along, VertexId& end) const {
    std::size_t length = 1;
    while (along[1] != from && !std::binary_search(seams_.begin(), seams_.end(), along[1])) {
        const std::span<const EdgeVertices> ways = arcs_at(along[1]);
        along = ways[0][1] == along[0] ? ways[1] : ways[0];
        ++length;
    }
    end = along[1];
    return length;
}

SurfacePlace SurfaceLink::place() const {
    VertexId end;
    if (seams_.empty())
        return walk(arcs_[0][0], arcs_[0], end) == edges_.size() ? SurfacePlace::sheet : SurfacePlace::corner;
    if (seams_.size() != 2) return SurfacePlace::corner;
    std::size_t length = 0;
    for (const EdgeVertices& arc : arcs_at(seams_[0])) {
        length += walk(seams_[0], arc, end);
        if (end != seams_[1]) return SurfacePlace::corner;
    }
    return length == edges_.size() ? SurfacePlace::seam : SurfacePlace::corner;
}

}  // namespace dsc::dsc3d
