// SPDX-License-Identifier: GPL-3.0-or-later
// The geodesic between two points by finite differences and Newton's method: thesis 5.2.3, equations (5.4) to (5.6).
// The matrix of (5.6) is block tridiagonal with 2 x 2 blocks and is eliminated as such, where the thesis (5.4.1) pays
// for a general solver.
//
//   TwoPointSolver solver(torus);
//   std::vector<Point2> nodes = straight_polyline({0, 0}, {1, 2}, 100);
//   const TwoPointReport report = solver.solve(nodes);      // nodes and report.length are of order 2 in 1/100
//
// Guarantee: Newton's method with exact derivatives, quadratic near the solution; a polyline too rough for it is
// smoothed by a fixed-point step of (5.4). The result is a discrete geodesic near the initial polyline, which minimizes
// length only if the polyline was near enough to a minimizing one. Cost: O(nodes) per iteration: one connection_jet()
// and some 60 multiplications per node; no allocation once a solver has seen as many nodes. Not thread-safe: one solver
// per thread.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "geodesic/metric.h"

namespace dsc::geodesic {

struct TwoPointParameters {
    double tolerance = 1e-11;  ///< largest last Newton correction of a node, in the chart; > 0
    int max_iterations = 30;   ///< before giving up; >= 1
};

struct TwoPointReport {
    bool is_converged = false;
    int iterations = 0;               ///< made, smoothing steps included
    double length = 0;                ///< of the polyline by the midpoint rule, order 2
    Vector2 initial_direction{0, 0};  ///< unit tangent at the first node, order 2; zero if all nodes coincide
    Vector2 final_direction{0, 0};    ///< unit tangent at the last node, pointing onwards, order 2
};

class TwoPointSolver {
public:
    /// `metric` must outlive the solver.
    explicit TwoPointSolver(const Metric& metric, const TwoPointParameters& parameters = {});

    /// Moves the inner nodes of a polyline in the universal cover onto the discrete geodesic between its ends.
    /// Precondition: two nodes or more. If it does not converge, `nodes` hold the last iterate.
    TwoPointReport solve(std::span<Point2> nodes);

    /// The largest correction of a node in each iteration of the last solve().
    std::span<const double> corrections() const { return corrections_; }

private:
    void assemble(std::span<const Point2> nodes);
    double eliminate();
    void hold_symbols();

    /// Row p of the linear system: lower·δ⁻ + diagonal·δ + upper·δ⁺ = -residual.
    struct BlockRow {
        Eigen::Matrix2d lower, diagonal, upper;
        Vector2 residual;
    };

    const Metric& metric_;
    TwoPointParameters parameters_;
    std::vector<BlockRow> rows_;
    std::vector<Vector2> correction_;
    std::vector<double> corrections_;
};

/// The straight line in the chart, as `segments` + 1 nodes.
std::vector<Point2> straight_polyline(const Point2& from, const Point2& to, int segments);

/// Length of a polyline by the midpoint rule.
double length(const Metric& metric, std::span<const Point2> nodes);

}  // namespace dsc::geodesic
