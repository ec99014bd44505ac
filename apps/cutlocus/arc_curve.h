// SPDX-License-Identifier: GPL-3.0-or-later
// One arc of a cut locus as a piecewise polynomial, from exact meetings at Chebyshev nodes of its parameter w (half the
// difference of the two directions; see geodesic/meeting.h), in w² next to a conjugate end, where the arc is even in w.
// Every panel is judged at points between its nodes by integrating both geodesics anew, and halved until they hit.
//
// Near a conjugate end, `middle` is ill-conditioned: an error e of the integrator, in the difference of two geodesics,
// moves it by about e / w³. That is harmless at the node itself, where the Jacobi field j is of the order of w², but
// the polynomial carries it to where j is larger. Halving does not help: e falls like w, so that the miss stays the
// same. Such a panel is first solved anew with a finer integrator.
#pragma once

#include <map>
#include <vector>

#include "apps/cutlocus/cut_graph.h"
#include "core/errors.h"
#include "geodesic/chebyshev.h"
#include "geodesic/meeting.h"

namespace dsc::cutlocus {

struct ArcParameters {
    double tolerance = 1e-10;   ///< largest miss of a re-integrated geodesic on the surface
    int degree = 32;            ///< of the polynomial of a panel; a power of two from 8 on
    double panel_length = 1.5;  ///< length of a panel on the surface at the start
    int max_halvings = 12;      ///< of a panel before the arc is given up
    /// Local error of the integrator's steps where a panel next to a conjugate end misses.
    double fine_step_tolerance = 1e-13;
};

/// The arc can't be followed from one of its meetings to the next: Newton's method fails, or a geodesic has passed a
/// conjugate point there.
class BrokenArc : public core::RunError {
public:
    BrokenArc(const geodesic::Meeting& before, const geodesic::Meeting& after);

    const geodesic::Meeting& before() const { return before_; }
    const geodesic::Meeting& after() const { return after_; }

private:
    geodesic::Meeting before_, after_;
};

class ArcCurve {
public:
    /// Solves the arc through `anchors`: meetings with ascending w, of which the first and the last are the arc's exact
    /// ends, the others may be approximate; a first one with w = 0 is a conjugate end. Throws
    /// BrokenArc, or core::RunError if a panel does not converge.
    ArcCurve(geodesic::GeodesicFlow& flow, const std::vector<geodesic::Meeting>& anchors,
             const ArcParameters& parameters = {});

    double length() const { return length_; }
    /// ∫ A dtheta over both sides of the arc, A the area of the sector per unit of theta.
    double sector_area() const { return sector_area_; }
    double residual() const { return residual_; }
    double smallest_j() const { return smallest_j_; }
    /// `count` + 1 points, evenly spaced on the surface, ends included.
    std::vector<CutSample> samples(int count) const;
    /// The point of smallest (`sign` = 1) or largest (-1) distance along the arc.
    Extremum extremum(double sign) const;

private:
    struct Panel {
        double begin = 0, end = 0;                        // w
        bool is_squared = false;                          // the parameter is w², not w
        Eigen::Matrix<double, Eigen::Dynamic, 4> values;  // rows: nodes; columns: middle, t, x
        // Sector areas A per unit of theta: A1 + A2 and, as the smooth function that it is, (A1 - A2) / 2w.
        Eigen::Matrix<double, Eigen::Dynamic, 2> sectors;
        Eigen::VectorXd arc_length;  // from the panel's begin to each node
        double offset = 0;           // arc length from the arc's start to the panel's begin

        double w(double x) const;
        CutSample sample(const geodesic::ChebyshevNodes& nodes, double x) const;
    };
    struct Anchor {
        geodesic::Meeting meeting;
        bool is_exact = false;  // or good enough for a first guess only
    };
    using Anchors = std::map<double, Anchor>;

    /// Solves the meetings at all nodes, coarse to fine; empty as soon as the mistake of a coarser polynomial shows
    /// that the panel is too long.
    std::optional<Panel> solve_panel(geodesic::GeodesicFlow& flow, double begin, double end, double tolerance,
                                     Anchors& anchors);
    /// The exact meeting at w, near `prediction` = (middle, t) or, without one, near what the anchors say.
    static const geodesic::Meeting& exact_meeting(geodesic::GeodesicFlow& flow, double w,
                                                  const std::optional<geodesic::Vector2>& prediction, Anchors& anchors);
    double sector_area_of(const Panel& panel) const;
    double miss(geodesic::GeodesicFlow& flow, const Panel& panel, const geodesic::LatticeVector& lattice) const;
    CutSample at_length(double s) const;

    geodesic::ChebyshevNodes nodes_;
    std::vector<geodesic::ChebyshevNodes> coarser_;  // of degree 4, 8, …, half of nodes_
    std::vector<Panel> panels_;
    double length_ = 0, sector_area_ = 0, residual_ = 0, smallest_j_ = 0;
};

}  // namespace dsc::cutlocus
