// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/surface_energy.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace dsc::fluid {

namespace {

template <int Dimension>
using ElementVector = Eigen::Matrix<double, Dimension * Dimension, 1>;
template <int Dimension>
using ElementMatrix = Eigen::Matrix<double, Dimension * Dimension, Dimension * Dimension>;

double area(const std::array<Vector<2>, 2>& p) { return (p[1] - p[0]).norm(); }
double area(const std::array<Vector<3>, 3>& p) { return 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm(); }

ElementVector<2> area_gradient(const std::array<Vector<2>, 2>& p) {
    ElementVector<2> gradient;
    const Vector<2> tangent = (p[1] - p[0]).normalized();
    gradient << -tangent, tangent;
    return gradient;
}

ElementVector<3> area_gradient(const std::array<Vector<3>, 3>& p) {
    ElementVector<3> gradient;
    const Vector<3> normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
    for (std::size_t i = 0; i < 3; ++i)
        gradient.segment<3>(3 * static_cast<Eigen::Index>(i)) = 0.5 * normal.cross(p[(i + 2) % 3] - p[(i + 1) % 3]);
    return gradient;
}

ElementMatrix<2> area_hessian(const std::array<Vector<2>, 2>& p) {
    const Vector<2> along = p[1] - p[0];
    const double length = along.norm();
    const Eigen::Matrix2d across =
        (Eigen::Matrix2d::Identity() - along * along.transpose() / (length * length)) / length;
    ElementMatrix<2> hessian;
    hessian << across, -across, -across, across;
    return hessian;
}

Eigen::Matrix3d cross_matrix(const Vector<3>& v) {
    Eigen::Matrix3d matrix;
    matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return matrix;
}

// With w = (b - a) x (c - a) and area |w| / 2: the derivative of w for corner i is the cross product with its opposite
// edge, and that of |w| brings the part of it across w.
ElementMatrix<3> area_hessian(const std::array<Vector<3>, 3>& p) {
    const Vector<3> w = (p[1] - p[0]).cross(p[2] - p[0]);
    const double norm = w.norm();
    const Vector<3> normal = w / norm;
    const Eigen::Matrix3d across = (Eigen::Matrix3d::Identity() - normal * normal.transpose()) / norm;
    Eigen::Matrix<double, 3, 9> derivative;
    for (std::size_t i = 0; i < 3; ++i)
        derivative.block<3, 3>(0, 3 * static_cast<Eigen::Index>(i)) = cross_matrix(p[(i + 2) % 3] - p[(i + 1) % 3]);
    ElementMatrix<3> hessian = derivative.transpose() * across * derivative;
    // w is bilinear: w = a x b + b x c + c x a; its second derivative for corners i, i + 1 is the cross product itself.
    const Eigen::Matrix3d turn = cross_matrix(normal);
    for (Eigen::Index i = 0; i < 3; ++i) {
        const Eigen::Index next = (i + 1) % 3;
        hessian.block<3, 3>(3 * i, 3 * next) -= turn;
        hessian.block<3, 3>(3 * next, 3 * i) += turn;
    }
    return 0.5 * hessian;
}

template <int Dimension>
std::array<Vector<Dimension>, Dimension> corners(const std::vector<Vector<Dimension>>& positions,
                                                 const SurfaceElement<Dimension>& element) {
    std::array<Vector<Dimension>, Dimension> result;
    for (std::size_t i = 0; i < Dimension; ++i) result[i] = positions[element.vertices[i]];
    return result;
}

template <int Dimension>
ElementMatrix<Dimension> positive_part(const ElementMatrix<Dimension>& matrix) {
    const Eigen::SelfAdjointEigenSolver<ElementMatrix<Dimension>> eigen(matrix);
    return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() * eigen.eigenvectors().transpose();
}

}  // namespace

template <int Dimension>
double surface_energy(const std::vector<Vector<Dimension>>& positions,
                      std::span<const SurfaceElement<Dimension>> surface) {
    double sum = 0;
    for (const auto& element : surface) sum += element.tension * area(corners(positions, element));
    return sum;
}

template <int Dimension>
Eigen::VectorXd surface_energy_gradient(const std::vector<Vector<Dimension>>& positions,
                                        std::span<const SurfaceElement<Dimension>> surface) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(positions.size()) * Dimension);
    for (const auto& element : surface) {
        const ElementVector<Dimension> gradient = element.tension * area_gradient(corners(positions, element));
        for (int i = 0; i < Dimension; ++i)
            sum.template segment<Dimension>(Dimension * element.vertices[static_cast<std::size_t>(i)]) +=
                gradient.template segment<Dimension>(Dimension * i);
    }
    return sum;
}

template <int Dimension>
void add_surface_energy_hessian(const std::vector<Vector<Dimension>>& positions,
                                std::span<const SurfaceElement<Dimension>> surface, HessianPart part, double scale,
                                std::vector<Eigen::Triplet<double, int>>& entries) {
    for (const auto& element : surface) {
        ElementMatrix<Dimension> hessian = scale * element.tension * area_hessian(corners(positions, element));
        if (part == HessianPart::positive) hessian = positive_part<Dimension>(hessian);
        for (int i = 0; i < Dimension * Dimension; ++i)
            for (int k = 0; k < Dimension * Dimension; ++k)
                entries.emplace_back(
                    Dimension * static_cast<int>(element.vertices[static_cast<std::size_t>(i / Dimension)]) +
                        i % Dimension,
                    Dimension * static_cast<int>(element.vertices[static_cast<std::size_t>(k / Dimension)]) +
                        k % Dimension,
                    hessian(i, k));
    }
}

#define DSC_INSTANTIATE(D)                                                                                      \
    template double surface_energy(const std::vector<Vector<D>>&, std::span<const SurfaceElement<D>>);          \
    template Eigen::VectorXd surface_energy_gradient(const std::vector<Vector<D>>&,                             \
                                                     std::span<const SurfaceElement<D>>);                       \
    template void add_surface_energy_hessian(const std::vector<Vector<D>>&, std::span<const SurfaceElement<D>>, \
                                             HessianPart, double, std::vector<Eigen::Triplet<double, int>>&);
DSC_INSTANTIATE(2)
DSC_INSTANTIATE(3)
#undef DSC_INSTANTIATE

}  // namespace dsc::fluid
