// SPDX-License-Identifier: GPL-3.0-or-later
// The cut locus as a graph: end and branch points, arcs, and samples of the arcs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/cutlocus/gluing.h"
#include "geodesic/metric.h"

namespace dsc::cutlocus {

using geodesic::LatticeVector;
using geodesic::Point2;

/// A point of the cut locus and the two minimising geodesics that meet there.
struct CutSample {
    Point2 x{0, 0};  ///< end of the geodesic in direction theta1, in the universal cover of the chart
    double distance = 0;
    double theta1 = 0, theta2 = 0;
};

enum class VertexKind {
    end,      ///< conjugate to p along its one minimising geodesic
    branch,   ///< reached by three or more minimising geodesics
    frontier  ///< where an arc passes the largest distance asked for
};

struct CutVertex {
    VertexKind kind = VertexKind::branch;
    Point2 x{0, 0};  ///< in the universal cover: end of the first arriving geodesic
    double distance = 0;
    std::vector<double> thetas;  ///< directions of all minimising geodesics that arrive, ascending in [-π, π)
    int degree = 0;              ///< number of arc ends
    double residual = 0;         ///< largest distance between the ends of the arriving geodesics
};

struct CutArc {
    int start = 0, end = 0;       ///< vertices
    LatticeVector lattice{0, 0};  ///< E(theta1) - E(theta2) along the arc, in periods
    double length = 0;            ///< on the surface
    bool is_announced = true;     ///< false if no contact of the front lies on it
    std::vector<CutSample> samples;
};

struct Extremum {
    double distance = 0;
    Point2 x{0, 0};
};

/// What proves a cut locus: see certify().
struct Certificate {
    int components = 0;
    int betti1 = 0;
    double sector_area = 0;            ///< ∮ ∫₀^{t_cut} j dt dtheta
    std::optional<double> total_area;  ///< area of the surface, if it is closed
    double direction_gap = 0;          ///< largest gap or overlap of the arcs' sides on the circle of directions
    double residual = 0;    ///< largest miss of a geodesic integrated anew to a point between the solved ones
    double smallest_j = 0;  ///< smallest Jacobi field on an arc away from its conjugate ends; positive
    std::vector<std::string> failures;  ///< empty: the certificate holds

    double relative_area_error() const { return total_area ? sector_area / *total_area - 1 : 0; }
    bool holds() const { return failures.empty(); }
};

/// A doubtful interval of directions: where the front has to be refined.
struct Doubt {
    double theta = 0;
    std::string reason;
};

struct CutGraph {
    std::vector<CutVertex> vertices;
    std::vector<CutArc> arcs;
    double length = 0;
    Extremum nearest, farthest;
    Certificate certificate;
    std::vector<Doubt> doubts;
};

}  // namespace dsc::cutlocus
