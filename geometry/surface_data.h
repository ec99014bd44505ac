// SPDX-License-Identifier: GPL-3.0-or-later
// A labelled triangle surface as plain arrays: what files hold, and what engines are made from and converted to.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace dsc::geometry {

struct SurfaceData {
    std::vector<Eigen::Vector3d> vertices;
    /// Vertex indices, counterclockwise seen from the side the normal points to: outside, when the surface is closed.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    /// Patch of each triangle; empty when there is only one, with label 0.
    std::vector<int> labels;

    int label(std::size_t triangle) const { return labels.empty() ? 0 : labels[triangle]; }
};

}  // namespace dsc::geometry
