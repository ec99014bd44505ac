// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/stabilization.h"

#include "fluid/elements.h"

namespace dsc::fluid {

namespace {

class Couplings {
public:
    void couple(std::uint32_t i, std::uint32_t j, double weight) {
        hold(i, weight);
        hold(j, weight);
        entries_.emplace_back(static_cast<int>(i), static_cast<int>(j), -weight);
        entries_.emplace_back(static_cast<int>(j), static_cast<int>(i), -weight);
    }
    void hold(std::uint32_t i, double weight) {
        entries_.emplace_back(static_cast<int>(i), static_cast<int>(i), weight);
    }
    Eigen::SparseMatrix<double> matrix(std::size_t size) const {
        Eigen::SparseMatrix<double> result(static_cast<Eigen::Index>(size), static_cast<Eigen::Index>(size));
        result.setFromTriplets(entries_.begin(), entries_.end());
        return result;
    }

private:
    std::vector<Eigen::Triplet<double, int>> entries_;
};

template <int Dimension>
Vector<Dimension> facet_centre(const SimplexMesh<Dimension>& mesh, const Facet<Dimension>& facet) {
    Vector<Dimension> sum = Vector<Dimension>::Zero();
    for (const std::uint32_t v : facet.vertices) sum += mesh.positions[v];
    return sum / Dimension;
}

}  // namespace

template <int Dimension>
Eigen::SparseMatrix<double> stabilization_matrix(const SimplexMesh<Dimension>& mesh,
                                                 std::span<const Facet<Dimension>> facets,
                                                 std::span<const double> densities) {
    Couplings couplings;
    for (const Facet<Dimension>& facet : facets) {
        if (!facet.opposite || mesh.phases[facet.cell] != mesh.phases[*facet.opposite]) continue;
        const double density = densities[static_cast<std::size_t>(mesh.phases[facet.cell])];
        const double distance = (centroid(mesh, facet.cell) - centroid(mesh, *facet.opposite)).norm();
        couplings.couple(facet.cell, *facet.opposite,
                         area_vector<Dimension>(mesh.positions, facet.vertices).norm() / (density * distance));
    }
    return couplings.matrix(mesh.cells.size());
}

template <int Dimension>
Eigen::SparseMatrix<double> pressure_laplacian(const SimplexMesh<Dimension>& mesh,
                                               std::span<const Facet<Dimension>> facets,
                                               std::span<const double> densities, const std::vector<char>& is_closed) {
    Couplings couplings;
    for (std::size_t f = 0; f < facets.size(); ++f) {
        const Facet<Dimension>& facet = facets[f];
        const Vector<Dimension> centre = facet_centre(mesh, facet);
        const auto resistance = [&](std::uint32_t cell) {
            return densities[static_cast<std::size_t>(mesh.phases[cell])] * (centroid(mesh, cell) - centre).norm();
        };
        const double area = area_vector<Dimension>(mesh.positions, facet.vertices).norm();
        if (facet.opposite)
            couplings.couple(facet.cell, *facet.opposite,
                             area / (resistance(facet.cell) + resistance(*facet.opposite)));
        else if (is_closed[f] == 0)
            couplings.hold(facet.cell, area / resistance(facet.cell));
    }
    return couplings.matrix(mesh.cells.size());
}

#define DSC_INSTANTIATE(D)                                                                                      \
    template Eigen::SparseMatrix<double> stabilization_matrix(const SimplexMesh<D>&, std::span<const Facet<D>>, \
                                                              std::span<const double>);                         \
    template Eigen::SparseMatrix<double> pressure_laplacian(const SimplexMesh<D>&, std::span<const Facet<D>>,   \
                                                            std::span<const double>, const std::vector<char>&);
DSC_INSTANTIATE(2)
DSC_INSTANTIATE(3)
#undef DSC_INSTANTIATE

}  // namespace dsc::fluid
