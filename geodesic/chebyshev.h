// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomial interpolation in Chebyshev points of the second kind on [0, 1]: barycentric evaluation, differentiation
// and integration of functions known at the nodes (Trefethen, Approximation Theory and Approximation Practice, 2013).
// Guarantee: error of the order of the function's best polynomial approximation; spectral for analytic functions.
#pragma once

#include <Eigen/Core>

namespace dsc::geodesic {

class ChebyshevNodes {
public:
    /// `degree` + 1 nodes, ascending from 0 to 1. Precondition: degree >= 2.
    explicit ChebyshevNodes(int degree);

    int degree() const { return static_cast<int>(nodes_.size()) - 1; }
    const Eigen::VectorXd& nodes() const { return nodes_; }

    /// Row of weights w with f(x) = w · values; x in [0, 1].
    Eigen::RowVectorXd interpolation_row(double x) const;
    /// Matrix that takes values at the nodes to derivatives at the nodes.
    const Eigen::MatrixXd& differentiation() const { return differentiation_; }
    /// Matrix that takes values at the nodes to integrals from 0 to each node.
    const Eigen::MatrixXd& integration() const { return integration_; }

private:
    Eigen::VectorXd nodes_;
    Eigen::VectorXd weights_;
    Eigen::MatrixXd differentiation_;
    Eigen::MatrixXd integration_;
};

}  // namespace dsc::geodesic
