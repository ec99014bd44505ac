// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic/chebyshev.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/assert.h"

namespace dsc::geodesic {

namespace {

/// Integrals from 0 to each node of the shifted Chebyshev polynomials T_k(2x - 1), k = 0, …, degree.
Eigen::MatrixXd integrated_polynomials(const Eigen::VectorXd& nodes) {
    const Eigen::Index count = nodes.size();
    const auto chebyshev = [](Eigen::Index k, double y) {
        return std::cos(static_cast<double>(k) * std::acos(std::min(1.0, std::max(-1.0, y))));
    };
    const auto antiderivative = [&](Eigen::Index k, double y) {
        if (k == 0) return y;
        if (k == 1) return y * y / 2;
        const auto order = static_cast<double>(k);
        return chebyshev(k + 1, y) / (2 * (order + 1)) - chebyshev(k - 1, y) / (2 * (order - 1));
    };
    Eigen::MatrixXd integrals(count, count);
    for (Eigen::Index i = 0; i < count; ++i)
        for (Eigen::Index k = 0; k < count; ++k)
            integrals(i, k) = (antiderivative(k, 2 * nodes[i] - 1) - antiderivative(k, -1)) / 2;
    return integrals;
}

}  // namespace

ChebyshevNodes::ChebyshevNodes(int degree) : nodes_(degree + 1), weights_(degree + 1) {
    DSC_ASSERT(degree >= 2);
    const Eigen::Index count = degree + 1;
    for (Eigen::Index i = 0; i < count; ++i) {
        const double half_angle = std::numbers::pi * static_cast<double>(i) / (2.0 * degree);
        nodes_[i] = std::sin(half_angle) * std::sin(half_angle);
        weights_[i] = (i % 2 == 0 ? 1.0 : -1.0) * (i == 0 || i == degree ? 0.5 : 1.0);
    }
    differentiation_.setZero(count, count);
    for (Eigen::Index i = 0; i < count; ++i) {
        for (Eigen::Index k = 0; k < count; ++k)
            if (i != k) differentiation_(i, k) = weights_[k] / weights_[i] / (nodes_[i] - nodes_[k]);
        differentiation_(i, i) = -differentiation_.row(i).sum();
    }
    Eigen::MatrixXd polynomials(count, count);
    for (Eigen::Index i = 0; i < count; ++i)
        for (Eigen::Index k = 0; k < count; ++k)
            polynomials(i, k) =
                std::cos(static_cast<double>(k) * std::numbers::pi * (1 - static_cast<double>(i) / degree));
    integration_ = integrated_polynomials(nodes_) * polynomials.inverse();
}

Eigen::RowVectorXd ChebyshevNodes::interpolation_row(double x) const {
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(nodes_.size());
    for (Eigen::Index i = 0; i < nodes_.size(); ++i) {
        if (x == nodes_[i]) {
            row.setZero();
            row[i] = 1;
            return row;
        }
        row[i] = weights_[i] / (x - nodes_[i]);
    }
    return row / row.sum();
}

}  // namespace dsc::geodesic
