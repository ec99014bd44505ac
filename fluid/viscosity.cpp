// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/viscosity.h"

namespace dsc::fluid {

template <int Dimension>
void add_viscosity_matrix(const SimplexMesh<Dimension>& mesh, const Elements<Dimension>& elements,
                          std::span<const double> viscosities, double scale,
                          std::vector<Eigen::Triplet<double, int>>& entries) {
    using Block = Eigen::Matrix<double, Dimension, Dimension>;
    for (std::size_t j = 0; j < mesh.cells.size(); ++j) {
        const double viscosity = viscosities[static_cast<std::size_t>(mesh.phases[j])];
        if (viscosity == 0) continue;
        const auto& gradients = elements.volume_gradients[j];  // V times those of the hat functions
        for (int a = 0; a <= Dimension; ++a) {
            for (int b = 0; b <= Dimension; ++b) {
                const Block block = scale * viscosity / elements.volumes[j] *
                                    (gradients.col(a).dot(gradients.col(b)) * Block::Identity() +
                                     gradients.col(b) * gradients.col(a).transpose());
                const int row = Dimension * static_cast<int>(mesh.cells[j][static_cast<std::size_t>(a)]);
                const int column = Dimension * static_cast<int>(mesh.cells[j][static_cast<std::size_t>(b)]);
                for (int k = 0; k < Dimension; ++k)
                    for (int l = 0; l < Dimension; ++l) entries.emplace_back(row + k, column + l, block(k, l));
            }
        }
    }
}

template void add_viscosity_matrix(const SimplexMesh<2>&, const Elements<2>&, std::span<const double>, double,
                                   std::vector<Eigen::Triplet<double, int>>&);
template void add_viscosity_matrix(const SimplexMesh<3>&, const Elements<3>&, std::span<const double>, double,
                                   std::vector<Eigen::Triplet<double, int>>&);

}  // namespace dsc::fluid
