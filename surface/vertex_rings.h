// SPDX-License-Identifier: GPL-3.0-or-later
// The one-rings of a surface given as arrays. Cost: linear to make, linear in the ring to ask for; memory: 12 bytes per
// triangle.
//
//     const surface::VertexRings rings(data);
//     std::vector<surface::RingTriangle> buffer;
//     const Vector3 velocity = surface::curvature(rings.ring(v, buffer)).vector;
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/surface_data.h"
#include "surface/one_ring.h"

namespace dsc::surface {

class VertexRings {
public:
    /// The surface has to outlive the rings; its positions may change. Every index has to be one of a vertex.
    explicit VertexRings(const geometry::SurfaceData& surface);

    /// The ring of v, with its triangles in `buffer`, which it replaces.
    OneRing ring(std::uint32_t v, std::vector<RingTriangle>& buffer) const;
    /// The triangles at v, in increasing order.
    std::span<const std::uint32_t> triangles(std::uint32_t v) const {
        return std::span(triangles_).subspan(begin_[v], begin_[v + 1] - begin_[v]);
    }

private:
    const geometry::SurfaceData& surface_;
    std::vector<std::uint32_t> begin_;  ///< by vertex, of its triangles
    std::vector<std::uint32_t> triangles_;
};

}  // namespace dsc::surface
