// SPDX-License-Identifier: GPL-3.0-or-later
// A labelled tetrahedral mesh as plain arrays: what files hold, and what engines are made from and converted to.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace dsc::geometry {

struct TetData {
    std::vector<Eigen::Vector3d> vertices;
    /// Vertex indices; positive when det[b - a, c - a, d - a] > 0, which readers see to.
    std::vector<std::array<std::uint32_t, 4>> tets;
    /// Region of each tetrahedron; empty when there is only one, with label 0.
    std::vector<int> labels;

    int label(std::size_t tet) const { return labels.empty() ? 0 : labels[tet]; }
};

}  // namespace dsc::geometry
