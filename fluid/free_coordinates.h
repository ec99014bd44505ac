// SPDX-License-Identifier: GPL-3.0-or-later
// Velocities in local coordinates: a vertex that touches a solid has the velocity of the solid along the normal and is
// free along the tangents. Source: thesis 6.4.2, equations (6.4) to (6.6), here as u = Z u_f + u_c with orthonormal
// columns in Z. Guarantee: several contacts at a vertex (an edge or a corner of the solid) leave fewer free
// coordinates, those that agree with all of them; normals that are nearly parallel count as one. Cost: linear.
#pragma once

#include <Eigen/SparseCore>
#include <span>

#include "fluid/simplex_mesh.h"

namespace dsc::fluid {

template <int Dimension>
struct WallContact {
    std::uint32_t vertex;
    Vector<Dimension> normal;  ///< of unit length
    double speed;              ///< of the solid along it
    int wall = 0;              ///< its number
};

struct FreeCoordinates {
    Eigen::SparseMatrix<double> basis;  ///< Z: a column for each free coordinate
    Eigen::VectorXd constrained;        ///< u_c, orthogonal to the columns of Z
    std::vector<std::uint32_t> vertex;  ///< of each free coordinate
};

/// Contacts may come in any order of vertices; those of one vertex count in the order given.
template <int Dimension>
FreeCoordinates free_coordinates(std::size_t vertex_count, std::span<const WallContact<Dimension>> contacts);

}  // namespace dsc::fluid
