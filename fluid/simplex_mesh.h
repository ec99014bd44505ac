// SPDX-License-Identifier: GPL-3.0-or-later
// The cells that carry fluid, as plain arrays: triangles in the plane, tetrahedra in space. What lies outside of them
// is void (air without mass) or solid. Source: thesis 6.4, figure 6.2.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace dsc::fluid {

template <int Dimension>
using Vector = Eigen::Matrix<double, Dimension, 1>;

template <int Dimension>
struct SimplexMesh {
    std::vector<Vector<Dimension>> positions;
    /// Vertices of each cell; positive: the determinant of the edges from the first one to the others is > 0.
    std::vector<std::array<std::uint32_t, Dimension + 1>> cells;
    /// Of each cell, from 0 on.
    std::vector<int> phases;
};

}  // namespace dsc::fluid
