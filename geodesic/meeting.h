// SPDX-License-Identifier: GPL-3.0-or-later
// Exact points of a cut locus: where two geodesics of equal length meet, where three or more do (branch points), and
// where a geodesic is conjugate for the first time along its neighbours (end points). Newton's method on the
// exponential map E(theta, t) in the universal cover; thesis 5.4.1 names exact collisions as what its method lacks.
//
// Along an arc of a cut locus one of the two directions turns left and the other right, so that half of their
// difference, w, is a parameter of the whole arc; it is 0 at a conjugate end, where the arc is a regular (even)
// function of it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geodesic/geodesic_flow.h"

namespace dsc::geodesic {

/// Two geodesics of equal length t in directions middle + w and middle - w that end in the same point of the surface:
/// first.x = second.x + translation(lattice).
struct Meeting {
    double w = 0;
    double middle = 0;
    double t = 0;
    LatticeVector lattice{0, 0};
    GeodesicState first, second;
    double middle_w = 0;     ///< d middle / dw along the arc
    double t_w = 0;          ///< dt / dw along the arc
    double sensitivity = 0;  ///< change of `middle` per unit of error in position; large next to a conjugate end

    double theta1() const { return middle + w; }
    double theta2() const { return middle - w; }
    /// Length on the surface per unit of w along the arc.
    double speed() const;
};

struct MeetingParameters {
    double tolerance = 1e-11;    ///< largest remaining Newton correction at a vertex, a length on the surface
    double linear_step = 1e-7;   ///< a last correction this small (length on the surface) is done without new geodesics
    int max_iterations = 15;     ///< Newton steps before giving up
    double largest_step = 0.25;  ///< a Newton step is shortened to move no geodesic's end further, in units of t
};

/// The meeting at half difference `w` != 0 near (`middle`, `t`); empty if Newton does not converge.
std::optional<Meeting> meet(GeodesicFlow& flow, double w, const LatticeVector& lattice, double middle, double t,
                            const MeetingParameters& parameters = {});

/// The meeting nearest, on the surface, to the ends of two geodesics of length about t in directions `theta1` and
/// `theta2`. Unlike meet() it is free to change w, by which whole arcs are missed where geodesics spread fast; next to
/// a conjugate end, where nothing else determines it, w is kept. Empty if Newton does not converge.
std::optional<Meeting> nearest_meeting(GeodesicFlow& flow, double theta1, double theta2, double t,
                                       const LatticeVector& lattice, const MeetingParameters& parameters = {});

/// A geodesic that arrives at a branch point: its end is that of the first one plus translation(lattice).
struct Arrival {
    double theta = 0;
    LatticeVector lattice{0, 0};
};

struct BranchPoint {
    std::vector<GeodesicState> arrivals;  ///< in the order of the input
    double t = 0;
    double residual = 0;  ///< largest distance on the surface between two ends
};

/// The common end of all `arrivals` (three or more) near length t: the least-squares solution when there are more
/// than three, to be judged by its residual. Empty if Gauss-Newton does not converge.
std::optional<BranchPoint> branch_point(GeodesicFlow& flow, std::span<const Arrival> arrivals, double t,
                                        const MeetingParameters& parameters = {});

/// Where j = ∂j/∂theta = 0 near (`theta`, `t`): a cusp of the conjugate locus. Empty if Newton does not converge.
std::optional<GeodesicState> conjugate_end(GeodesicFlow& flow, double theta, double t,
                                           const MeetingParameters& parameters = {});

}  // namespace dsc::geodesic
