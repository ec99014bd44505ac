// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/elements.h"

#include <Eigen/LU>
#include <numeric>

#include "core/assert.h"

namespace dsc::fluid {

template <int Dimension>
Elements<Dimension>::Elements(const SimplexMesh<Dimension>& mesh) {
    constexpr double cells_of_a_box = Dimension == 2 ? 2 : 6;
    volumes.reserve(mesh.cells.size());
    volume_gradients.reserve(mesh.cells.size());
    for (const auto& cell : mesh.cells) {
        Eigen::Matrix<double, Dimension, Dimension> edges;
        for (int k = 0; k < Dimension; ++k)
            edges.col(k) = mesh.positions[cell[static_cast<std::size_t>(k) + 1]] - mesh.positions[cell[0]];
        const double volume = edges.determinant() / cells_of_a_box;
        const Eigen::Matrix<double, Dimension, Dimension> inverse = edges.inverse();
        auto& gradients = volume_gradients.emplace_back();
        for (int k = 0; k < Dimension; ++k) gradients.col(k + 1) = volume * inverse.row(k).transpose();
        gradients.col(0) = -gradients.template rightCols<Dimension>().rowwise().sum();
        volumes.push_back(volume);
    }
}

template <int Dimension>
double Elements<Dimension>::total_volume() const {
    return std::accumulate(volumes.begin(), volumes.end(), 0.0);
}

template <int Dimension>
std::vector<double> lumped_masses(const SimplexMesh<Dimension>& mesh, const Elements<Dimension>& elements,
                                  std::span<const double> densities) {
    std::vector<double> masses(mesh.positions.size(), 0.0);
    for (std::size_t j = 0; j < mesh.cells.size(); ++j) {
        const double share =
            densities[static_cast<std::size_t>(mesh.phases[j])] * elements.volumes[j] / (Dimension + 1);
        for (const std::uint32_t v : mesh.cells[j]) masses[v] += share;
    }
    return masses;
}

template <int Dimension>
SparseRows divergence_matrix(const SimplexMesh<Dimension>& mesh, const Elements<Dimension>& elements) {
    std::vector<Eigen::Triplet<double, int>> entries;
    entries.reserve(mesh.cells.size() * (Dimension + 1) * Dimension);
    for (std::size_t j = 0; j < mesh.cells.size(); ++j)
        for (int i = 0; i <= Dimension; ++i)
            for (int k = 0; k < Dimension; ++k)
                entries.emplace_back(static_cast<int>(j),
                                     Dimension * static_cast<int>(mesh.cells[j][static_cast<std::size_t>(i)]) + k,
                                     elements.volume_gradients[j](k, i));
    SparseRows matrix(static_cast<Eigen::Index>(mesh.cells.size()),
                      static_cast<Eigen::Index>(mesh.positions.size()) * Dimension);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

template struct Elements<2>;
template struct Elements<3>;
template std::vector<double> lumped_masses(const SimplexMesh<2>&, const Elements<2>&, std::span<const double>);
template std::vector<double> lumped_masses(const SimplexMesh<3>&, const Elements<3>&, std::span<const double>);
template SparseRows divergence_matrix(const SimplexMesh<2>&, const Elements<2>&);
template SparseRows divergence_matrix(const SimplexMesh<3>&, const Elements<3>&);

}  // namespace dsc::fluid
