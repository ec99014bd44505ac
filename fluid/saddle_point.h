// SPDX-License-Identifier: GPL-3.0-or-later
// The quadratic program of a step: minimize u^T M u / 2 - b^T u subject to D u + S p = c, p being the multiplier that
// is a pressure: M u = b + D^T p. It is solved by its Schur complement (D M^-1 D^T + S) p = c - D M^-1 b. Source:
// thesis 6.4.3 and 6.4.4, equations (6.9), (6.10), with the sign that makes p a pressure. Guarantee: the answer, or a
// report that says that there is none; where the Schur complement is singular (S = 0 and more cells than coordinates,
// or no free surface), conjugate gradients find a solution of the consistent system. Cost: with conjugate gradients,
// some tens of products with D, whatever the size of the mesh, when S is not zero.
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <memory>

#include "fluid/elements.h"

namespace dsc::fluid {

enum class PressureSolver {
    conjugate_gradients,
    cholesky,  ///< of the assembled Schur complement; for diagonal masses and S that is not zero
};

/// A symmetric positive definite M by what is asked of it. Diagonal without viscosity and Hessian of the surface.
class EffectiveMass {
public:
    explicit EffectiveMass(Eigen::VectorXd diagonal);
    /// Throws core::RunError when the matrix is not positive definite.
    EffectiveMass(Eigen::VectorXd diagonal, const Eigen::SparseMatrix<double>& matrix);

    bool is_diagonal() const { return cholesky_ == nullptr; }
    const Eigen::VectorXd& diagonal() const { return diagonal_; }
    /// M^-1 b.
    Eigen::VectorXd solved(const Eigen::VectorXd& b) const;

private:
    Eigen::VectorXd diagonal_;
    std::shared_ptr<const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>>> cholesky_;
};

struct SaddlePoint {
    const SparseRows& divergence;                      ///< D
    const EffectiveMass& mass;                         ///< M
    const Eigen::SparseMatrix<double>& stabilization;  ///< S
    const Eigen::SparseMatrix<double>& laplacian;      ///< like the Schur complement: for preconditioning
    const Eigen::VectorXd& force;                      ///< b
    const Eigen::VectorXd& growth;                     ///< c
};

struct SolverParameters {
    PressureSolver solver = PressureSolver::conjugate_gradients;
    /// Residual over that of p = 0, in the Euclidean norm. In (0, 1).
    double tolerance = 1e-10;
    /// > 0.
    int max_iterations = 3000;

    /// Throws core::UsageError that names the first field out of its range.
    void validate() const;
};

struct SolveReport {
    bool is_converged = false;
    int iterations = 0;
    double residual = 0;  ///< relative
};

/// Keeps symbolic factorizations from one solve to the next, for as long as the pattern stays.
class SaddlePointSolver {
public:
    /// Throws core::UsageError for invalid parameters.
    explicit SaddlePointSolver(const SolverParameters& parameters);

    /// `pressure` is where the iteration begins, and the answer.
    SolveReport solve(const SaddlePoint& problem, Eigen::VectorXd& velocity, Eigen::VectorXd& pressure);

private:
    class Factorization;

    SolveReport solve_by_cholesky(const SaddlePoint& problem, const Eigen::VectorXd& rhs, Eigen::VectorXd& pressure);
    SolveReport solve_by_conjugate_gradients(const SaddlePoint& problem, const Eigen::VectorXd& rhs,
                                             Eigen::VectorXd& pressure);

    SolverParameters parameters_;
    std::shared_ptr<Factorization> schur_;
    std::shared_ptr<Factorization> preconditioner_;
};

}  // namespace dsc::fluid
