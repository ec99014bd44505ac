// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/curve/curvature_step.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "core/assert.h"
#include "core/errors.h"

namespace dsc::dsc2d {

namespace {

using Displacements = Eigen::Matrix<double, Eigen::Dynamic, 2>;

class CurvatureFlow {
public:
    CurvatureFlow(const Interface& interface, std::span<const std::uint8_t> is_fixed,
                  const CurvatureParameters& parameters)
        : interface_(interface),
          is_fixed_(is_fixed),
          parameters_(parameters),
          size_(static_cast<Eigen::Index>(interface.vertices.size())) {}

    Displacements run(double dt) {
        Displacements moved = Displacements::Zero(size_, 2);
        const double shortest_step = dt / parameters_.max_substeps;
        double time = 0, step = dt;
        while (time < dt) {
            step = std::min(step, dt - time);
            const Displacements whole = substep(moved, step);
            const Displacements first = substep(moved, step / 2);
            const Displacements halves = first + substep(moved + first, step / 2);
            const double error = relative_difference(moved, whole, halves);
            if (error > parameters_.tolerance && step > shortest_step) {
                step = std::max(shortest_step, step / 2);
                continue;
            }
            moved += 2 * halves - whole;
            time += step;
            if (error < parameters_.tolerance / 4) step *= 1.5;
        }
        return moved;
    }

private:
    double counted_length(const Point2& vector) const { return std::max(vector.norm(), parameters_.shortest_edge); }

    Point2 vector(const InterfaceSegment& s, const Displacements& moved) const {
        return s.vector + (moved.row(s.b) - moved.row(s.a)).transpose();
    }

    Displacements substep(const Displacements& moved, double h) {
        Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(size_);
        Displacements force = Displacements::Zero(size_, 2);
        entries_.clear();
        for (const InterfaceSegment& s : interface_.segments) {
            const Point2 way = vector(s, moved);
            const double length = counted_length(way), weight = h / length;
            for (const std::uint32_t v : {s.a, s.b}) diagonal[v] += length / 2 + weight;
            force.row(s.a) += weight * way.transpose();
            force.row(s.b) -= weight * way.transpose();
            // Only the lower half of the symmetric matrix is read; what is fixed moves by zero.
            if (is_fixed(s.a) || is_fixed(s.b)) continue;
            entries_.emplace_back(std::max(s.a, s.b), std::min(s.a, s.b), -weight);
        }
        for (Eigen::Index v = 0; v < size_; ++v) {
            if (is_fixed(v)) force.row(v).setZero();
            entries_.emplace_back(v, v, diagonal[v]);
        }
        Eigen::SparseMatrix<double> matrix(size_, size_);
        matrix.setFromTriplets(entries_.begin(), entries_.end());
        if (!is_analyzed_) solver_.analyzePattern(matrix);
        is_analyzed_ = true;
        solver_.factorize(matrix);
        if (solver_.info() != Eigen::Success) throw core::RunError("the step of curvature flow can't be solved");
        return solver_.solve(force);
    }

    double relative_difference(const Displacements& moved, const Displacements& whole,
                               const Displacements& halves) const {
        double largest = 0;
        for (const InterfaceSegment& s : interface_.segments) {
            const double length = counted_length(vector(s, moved));
            for (const std::uint32_t v : {s.a, s.b})
                largest = std::max(largest, (halves.row(v) - whole.row(v)).norm() / length);
        }
        return largest;
    }

    bool is_fixed(Eigen::Index v) const { return is_fixed_[static_cast<std::size_t>(v)] != 0; }

    const Interface& interface_;
    std::span<const std::uint8_t> is_fixed_;
    const CurvatureParameters& parameters_;
    Eigen::Index size_;
    std::vector<Eigen::Triplet<double>> entries_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
    bool is_analyzed_ = false;
};

}  // namespace

void CurvatureParameters::validate() const {
    if (!(shortest_edge > 0)) throw core::UsageError("shortest_edge: has to be positive");
    if (!(tolerance > 0)) throw core::UsageError("tolerance: has to be positive");
    if (max_substeps < 1) throw core::UsageError("max_substeps: has to be at least 1");
}

std::vector<Point2> curvature_displacements(const Interface& interface, double dt,
                                            std::span<const std::uint8_t> is_fixed,
                                            const CurvatureParameters& parameters) {
    parameters.validate();
    DSC_ASSERT(dt > 0 && is_fixed.size() == interface.vertices.size());
    const Displacements moved = CurvatureFlow(interface, is_fixed, parameters).run(dt);
    std::vector<Point2> result;
    for (Eigen::Index v = 0; v < moved.rows(); ++v) result.emplace_back(moved.row(v));
    return result;
}

}  // namespace dsc::dsc2d
