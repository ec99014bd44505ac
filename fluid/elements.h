// SPDX-License-Identifier: GPL-3.0-or-later
// The finite elements of the fluid: velocity is linear in each cell and given at the vertices, pressure is constant in
// each cell. Source: thesis 6.4, equation (6.1), and 6.4.2 (mass, divergence).
// The thesis gives a vertex a third of the mass of its tetrahedra; a cell of dimension d has d + 1 vertices, so that
// the share is 1 / (d + 1) and the masses sum to that of the fluid. Rows of the divergence are V_j grad phi_i, the
// derivative of the volume of cell j for a motion of vertex i: then D u is a rate of change of volume, and its
// multiplier a pressure. Cost: linear.
#pragma once

#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "fluid/simplex_mesh.h"

namespace dsc::fluid {

/// Rows are walked by the solver, so that they are stored together.
using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

template <int Dimension>
struct Elements {
    std::vector<double> volumes;
    /// Column i: V_j grad phi_i of the hat function of vertex i of the cell.
    std::vector<Eigen::Matrix<double, Dimension, Dimension + 1>> volume_gradients;

    explicit Elements(const SimplexMesh<Dimension>& mesh);

    double total_volume() const;
};

/// Of each vertex: its share of the cells around it. `densities`: of each phase.
template <int Dimension>
std::vector<double> lumped_masses(const SimplexMesh<Dimension>& mesh, const Elements<Dimension>& elements,
                                  std::span<const double> densities);

/// D: a row for each cell, a column for each coordinate of each vertex.
template <int Dimension>
SparseRows divergence_matrix(const SimplexMesh<Dimension>& mesh, const Elements<Dimension>& elements);

template <int Dimension>
Vector<Dimension> centroid(const SimplexMesh<Dimension>& mesh, std::size_t cell) {
    Vector<Dimension> sum = Vector<Dimension>::Zero();
    for (const std::uint32_t v : mesh.cells[cell]) sum += mesh.positions[v];
    return sum / (Dimension + 1);
}

}  // namespace dsc::fluid
