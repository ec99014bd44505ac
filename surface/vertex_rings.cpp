// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/vertex_rings.h"

#include "core/assert.h"

namespace dsc::surface {

VertexRings::VertexRings(const geometry::SurfaceData& surface)
    : surface_(surface), begin_(surface.vertices.size() + 1), triangles_(3 * surface.triangles.size()) {
    for (const auto& triangle : surface.triangles) {
        for (const std::uint32_t v : triangle) {
            DSC_ASSERT(v < surface.vertices.size());
            ++begin_[v + 1];
        }
    }
    for (std::size_t v = 1; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
        for (const std::uint32_t v : surface.triangles[t]) triangles_[next[v]++] = t;
    }
}

OneRing VertexRings::ring(std::uint32_t v, std::vector<RingTriangle>& buffer) const {
    buffer.clear();
    for (const std::uint32_t t : triangles(v)) {
        const auto& corners = surface_.triangles[t];
        const std::size_t i = corners[0] == v ? 0 : corners[1] == v ? 1 : 2;
        buffer.push_back({surface_.vertices[corners[(i + 1) % 3]], surface_.vertices[corners[(i + 2) % 3]]});
    }
    return {surface_.vertices[v], buffer};
}

}  // namespace dsc::surface
