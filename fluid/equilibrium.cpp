// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/equilibrium.h"

#include <Eigen/Geometry>
#include <Eigen/SparseLU>
#include <algorithm>

#include "core/errors.h"
#include "fluid/facets.h"
#include "fluid/integrals.h"

namespace dsc::fluid {

namespace {

using Entries = std::vector<Eigen::Triplet<double, int>>;

template <int Dimension>
double volume(const std::vector<Vector<Dimension>>& positions, std::span<const SurfaceElement<Dimension>> surface) {
    double sum = 0;
    for (const auto& element : surface)
        sum += area_vector<Dimension>(positions, element.vertices).dot(positions[element.vertices[0]]) / Dimension;
    return sum;
}

// The derivative of the volume of a cone over an element by a vertex is a sum over its other vertices; over a closed
// surface it adds up to the area vectors around the vertex.
template <int Dimension>
Eigen::VectorXd volume_gradient(const std::vector<Vector<Dimension>>& positions,
                                std::span<const SurfaceElement<Dimension>> surface) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(positions.size()) * Dimension);
    for (const auto& element : surface)
        for (const std::uint32_t v : element.vertices)
            sum.template segment<Dimension>(Dimension * static_cast<Eigen::Index>(v)) +=
                area_vector<Dimension>(positions, element.vertices) / Dimension;
    return sum;
}

void add_block(Entries& entries, int row, int column, const Eigen::MatrixXd& block) {
    for (int i = 0; i < block.rows(); ++i)
        for (int k = 0; k < block.cols(); ++k) {
            entries.emplace_back(row + i, column + k, block(i, k));
            entries.emplace_back(column + k, row + i, block(i, k));
        }
}

void add_volume_hessian(const std::vector<Vector<2>>&, const SurfaceElement<2>& element, double scale,
                        Entries& entries) {
    Eigen::Matrix2d turn;
    turn << 0, 0.5, -0.5, 0;
    add_block(entries, 2 * static_cast<int>(element.vertices[0]), 2 * static_cast<int>(element.vertices[1]),
              scale * turn);
}

// V = a . (b x c) / 6.
void add_volume_hessian(const std::vector<Vector<3>>& positions, const SurfaceElement<3>& element, double scale,
                        Entries& entries) {
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector<3>& third = positions[element.vertices[(i + 2) % 3]];
        Eigen::Matrix3d cross;
        cross << 0, -third.z(), third.y(), third.z(), 0, -third.x(), -third.y(), third.x(), 0;
        add_block(entries, 3 * static_cast<int>(element.vertices[i]),
                  3 * static_cast<int>(element.vertices[(i + 1) % 3]), -scale / 6 * cross);
    }
}

// Newton's system in the vertices of the surface, the multiplier of the volume, and those of the rigid motions.
template <int Dimension>
class Newton {
public:
    Newton(std::vector<Vector<Dimension>> positions, std::span<const SurfaceElement<Dimension>> surface)
        : positions_(std::move(positions)), surface_(surface.begin(), surface.end()) {
        std::vector<std::uint32_t> place(positions_.size(), 0);
        for (const auto& element : surface_)
            for (const std::uint32_t v : element.vertices) place[v] = 1;
        std::vector<Vector<Dimension>> used;
        for (std::uint32_t v = 0; v < place.size(); ++v) {
            if (place[v] == 0) continue;
            place[v] = static_cast<std::uint32_t>(vertices_.size());
            vertices_.push_back(v);
            used.push_back(positions_[v]);
        }
        for (auto& element : surface_) {
            element.tension = 1;
            for (std::uint32_t& v : element.vertices) v = place[v];
        }
        places_ = std::move(used);
        volume_ = volume<Dimension>(places_, surface_);
        pressure_ = best_pressure();
    }

    std::vector<Vector<Dimension>> solved(const EquilibriumParameters& parameters) {
        double residual = this->residual();
        for (int i = 0; i < parameters.max_iterations; ++i) {
            if (residual <= parameters.tolerance) {
                for (std::size_t k = 0; k < vertices_.size(); ++k) positions_[vertices_[k]] = places_[k];
                return positions_;
            }
            const Eigen::VectorXd way = direction();
            const std::vector<Vector<Dimension>> start = places_;
            const double start_pressure = pressure_, start_residual = residual;
            double share = 1;
            for (int halvings = 0; halvings < 20; ++halvings, share /= 2) {
                for (std::size_t k = 0; k < places_.size(); ++k)
                    places_[k] = start[k] + share * way.segment<Dimension>(Dimension * static_cast<Eigen::Index>(k));
                pressure_ = start_pressure + share * way[size()];
                residual = this->residual();
                if (residual < start_residual) break;
            }
        }
        throw core::RunError("no shape of least surface was found");
    }

private:
    Eigen::Index size() const { return Dimension * static_cast<Eigen::Index>(places_.size()); }
    Eigen::VectorXd area_gradient() const { return surface_energy_gradient<Dimension>(places_, surface_); }
    double best_pressure() const {
        const Eigen::VectorXd gradient = volume_gradient<Dimension>(places_, surface_);
        return gradient.dot(area_gradient()) / gradient.squaredNorm();
    }
    double volume_error() const { return volume<Dimension>(places_, surface_) / volume_ - 1; }
    double residual() const {
        const Eigen::VectorXd gradient = area_gradient();
        return (gradient - pressure_ * volume_gradient<Dimension>(places_, surface_)).norm() / gradient.norm() +
               std::abs(volume_error());
    }

    Eigen::VectorXd direction() const {
        constexpr int rotations = Rotation<Dimension>::RowsAtCompileTime;
        const Eigen::Index n = size(), all = n + 1 + Dimension + rotations;
        Entries entries;
        add_surface_energy_hessian<Dimension>(places_, surface_, HessianPart::whole, 1, entries);
        for (const auto& element : surface_) add_volume_hessian(places_, element, -pressure_, entries);
        const Eigen::VectorXd normal = volume_gradient<Dimension>(places_, surface_);
        const auto border = [&](Eigen::Index row, Eigen::Index at, double value) {
            entries.emplace_back(static_cast<int>(row), static_cast<int>(at), value);
            entries.emplace_back(static_cast<int>(at), static_cast<int>(row), value);
        };
        for (Eigen::Index k = 0; k < n; ++k) border(n, k, -normal[k]);
        for (std::size_t i = 0; i < places_.size(); ++i) {
            const auto at = Dimension * static_cast<Eigen::Index>(i);
            for (int k = 0; k < Dimension; ++k) border(n + 1 + k, at + k, 1);
            for (int k = 0; k < rotations; ++k) {
                const Vector<Dimension> turn = rotational_velocity<Dimension>(Rotation<Dimension>::Unit(k), places_[i]);
                for (int l = 0; l < Dimension; ++l) border(n + 1 + Dimension + k, at + l, turn[l]);
            }
        }
        Eigen::SparseMatrix<double> matrix(all, all);
        matrix.setFromTriplets(entries.begin(), entries.end());
        Eigen::VectorXd rhs = Eigen::VectorXd::Zero(all);
        rhs.head(n) = pressure_ * normal - area_gradient();
        rhs[n] = volume_ * volume_error();
        Eigen::SparseLU<Eigen::SparseMatrix<double>> lu(matrix);
        if (lu.info() != Eigen::Success) throw core::RunError("no shape of least surface was found");
        return lu.solve(rhs);
    }

    std::vector<Vector<Dimension>> positions_;
    std::vector<SurfaceElement<Dimension>> surface_;
    std::vector<std::uint32_t> vertices_;
    std::vector<Vector<Dimension>> places_;
    double volume_ = 0;
    double pressure_ = 0;
};

}  // namespace

template <int Dimension>
std::vector<Vector<Dimension>> equilibrium(std::vector<Vector<Dimension>> positions,
                                           std::span<const SurfaceElement<Dimension>> surface,
                                           const EquilibriumParameters& parameters) {
    return Newton<Dimension>(std::move(positions), surface).solved(parameters);
}

template std::vector<Vector<2>> equilibrium(std::vector<Vector<2>>, std::span<const SurfaceElement<2>>,
                                            const EquilibriumParameters&);
template std::vector<Vector<3>> equilibrium(std::vector<Vector<3>>, std::span<const SurfaceElement<3>>,
                                            const EquilibriumParameters&);

}  // namespace dsc::fluid
