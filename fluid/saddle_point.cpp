// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/saddle_point.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "core/assert.h"
#include "core/errors.h"

namespace dsc::fluid {

namespace {

using Matrix = Eigen::SparseMatrix<double>;

// Pressure of a fluid without free surface is known up to a constant, and the Laplacian singular: this share of the
// diagonal makes it definite without changing what it is like.
constexpr double definite_share = 1e-8;

struct Operator {
    const SaddlePoint& problem;

    Eigen::VectorXd operator()(const Eigen::VectorXd& pressure) const {
        Eigen::VectorXd result = problem.divergence * problem.mass.solved(problem.divergence.transpose() * pressure);
        result += problem.stabilization * pressure;
        return result;
    }
};

}  // namespace

// A sparse Cholesky factorization that knows the pattern of its symbolic part.
class SaddlePointSolver::Factorization {
public:
    bool compute(const Matrix& matrix) {
        std::vector<int> pattern(matrix.outerIndexPtr(), matrix.outerIndexPtr() + matrix.outerSize() + 1);
        pattern.insert(pattern.end(), matrix.innerIndexPtr(), matrix.innerIndexPtr() + matrix.nonZeros());
        if (pattern != pattern_) {
            cholesky_.analyzePattern(matrix);
            pattern_ = std::move(pattern);
        }
        cholesky_.factorize(matrix);
        return cholesky_.info() == Eigen::Success;
    }
    Eigen::VectorXd solved(const Eigen::VectorXd& b) const { return cholesky_.solve(b); }

private:
    Eigen::SimplicialLDLT<Matrix> cholesky_;
    std::vector<int> pattern_;
};

EffectiveMass::EffectiveMass(Eigen::VectorXd diagonal) : diagonal_(std::move(diagonal)) {}

EffectiveMass::EffectiveMass(Eigen::VectorXd diagonal, const Matrix& matrix) : diagonal_(std::move(diagonal)) {
    const auto cholesky = std::make_shared<Eigen::SimplicialLLT<Matrix>>(matrix);
    if (cholesky->info() != Eigen::Success) throw core::RunError("the masses of the fluid are not positive");
    cholesky_ = cholesky;
}

Eigen::VectorXd EffectiveMass::solved(const Eigen::VectorXd& b) const {
    if (is_diagonal()) return b.cwiseQuotient(diagonal_);
    return cholesky_->solve(b);
}

void SolverParameters::validate() const {
    if (!(tolerance > 0 && tolerance < 1)) throw core::UsageError("tolerance: has to be in (0, 1)");
    if (max_iterations <= 0) throw core::UsageError("max_iterations: has to be positive");
}

SaddlePointSolver::SaddlePointSolver(const SolverParameters& parameters)
    : parameters_(parameters),
      schur_(std::make_shared<Factorization>()),
      preconditioner_(std::make_shared<Factorization>()) {
    parameters.validate();
}

SolveReport SaddlePointSolver::solve(const SaddlePoint& problem, Eigen::VectorXd& velocity, Eigen::VectorXd& pressure) {
    DSC_ASSERT(pressure.size() == problem.divergence.rows());
    const Eigen::VectorXd free_fall = problem.mass.solved(problem.force);
    const Eigen::VectorXd rhs = problem.growth - problem.divergence * free_fall;
    const SolveReport report = parameters_.solver == PressureSolver::cholesky
                                   ? solve_by_cholesky(problem, rhs, pressure)
                                   : solve_by_conjugate_gradients(problem, rhs, pressure);
    velocity = problem.mass.solved(problem.force + problem.divergence.transpose() * pressure);
    return report;
}

SolveReport SaddlePointSolver::solve_by_cholesky(const SaddlePoint& problem, const Eigen::VectorXd& rhs,
                                                 Eigen::VectorXd& pressure) {
    DSC_ASSERT(problem.mass.is_diagonal());
    const Matrix d = problem.divergence;
    const Matrix weighted = problem.mass.diagonal().cwiseInverse().asDiagonal() * Matrix(d.transpose());
    const Matrix schur = Matrix(d * weighted) + problem.stabilization;
    SolveReport report;
    if (!schur_->compute(schur)) return report;
    pressure = schur_->solved(rhs);
    const double norm = rhs.norm();
    report.residual = norm > 0 ? (rhs - schur * pressure).norm() / norm : 0;
    report.iterations = 1;
    report.is_converged = report.residual <= std::max(parameters_.tolerance, 1e-9);
    return report;
}

// Hestenes and Stiefel, preconditioned by the Laplacian.
SolveReport SaddlePointSolver::solve_by_conjugate_gradients(const SaddlePoint& problem, const Eigen::VectorXd& rhs,
                                                            Eigen::VectorXd& pressure) {
    SolveReport report;
    const double norm = rhs.norm();
    if (!std::isfinite(norm)) return report;
    if (norm == 0) {
        pressure.setZero();
        report.is_converged = true;
        return report;
    }
    Matrix laplacian = problem.laplacian;
    for (Eigen::Index i = 0; i < laplacian.rows(); ++i) laplacian.coeffRef(i, i) *= 1 + definite_share;
    if (!preconditioner_->compute(laplacian)) return report;
    const Operator times{problem};
    Eigen::VectorXd residual = rhs - times(pressure);
    Eigen::VectorXd direction = preconditioner_->solved(residual);
    double product = residual.dot(direction);
    while (report.iterations < parameters_.max_iterations) {
        report.residual = residual.norm() / norm;
        if (!std::isfinite(report.residual)) return report;
        report.is_converged = report.residual <= parameters_.tolerance;
        if (report.is_converged) return report;
        ++report.iterations;
        const Eigen::VectorXd image = times(direction);
        const double curvature = direction.dot(image);
        if (!(curvature > 0)) return report;
        const double step = product / curvature;
        pressure += step * direction;
        residual -= step * image;
        const Eigen::VectorXd preconditioned = preconditioner_->solved(residual);
        const double next = residual.dot(preconditioned);
        direction = preconditioned + (next / product) * direction;
        product = next;
    }
    return report;
}

}  // namespace dsc::fluid
