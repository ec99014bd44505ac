// SPDX-License-Identifier: GPL-3.0-or-later
// The front of points at equal distance from p, which grows in a deformable simplicial complex on the chart and stops
// where it is about to meet itself: thesis 5.2, the contacts are the raw material of the cut locus.
// Guarantee: the complex is valid after every step and the topology of the front is that of a circle. Cost: steps times
// vertices of the front.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "apps/cutlocus/gluing.h"
#include "core/observer.h"
#include "dsc2d/domain.h"
#include "geodesic/metric.h"

namespace dsc::cutlocus {

enum class FrontMethod {
    integrated,  ///< geodesics integrated with their Jacobi field
    two_point    ///< polylines and the two-point solver, as in the thesis
};

struct FrontParameters {
    double spacing = 0.1;     ///< largest distance of neighbours on the surface; > 0
    double time_step = 0.05;  ///< growth of the radius per step; in (0, 2 spacings]
    FrontMethod method = FrontMethod::integrated;
    std::optional<double> max_distance;  ///< the front stops there; needed unless the chart is a torus
    int initial_vertices = 24;           ///< of the first front (5.2.4), a circle of this many spacings; >= 8
    /// The front edge and the geodesics of its ends count as tangent (5.2.2) below this sine of the angle between them.
    double tangent_sine = 0.2;
    double longest_lag = 3;       ///< a vertex so far behind its geodesic is stopped; in spacings
    double shortest_edge = 0.35;  ///< shorter edges of the front merge; in spacings of the complex, in [0, 0.5)
    double merging_steps = 12;    ///< ... unless the geodesics of their ends cross within so many steps; >= 1
    /// The motion of a step is made in so many parts: of two parts of the front that run into each other, the one that
    /// is moved first gets past the middle of the gap by half of such a part at most; >= 1.
    int motion_parts = 1;
    /// Vertices in contact go on while their geodesics are more than so many steps from meeting; nothing: any contact
    /// stops its vertices. >= 0.
    std::optional<double> contact_steps;
    int snapshots = 60;  ///< about this many fronts are kept for pictures; 0: none
};

/// The method of the thesis with steps of this length. Its vertices stop less than a step from the cut locus, and none
/// of its points is further than a step from one of them, in the chart and times the largest speed there (5.4.1).
FrontParameters plain_front(double time_step);

/// Two vertices of the front that were stopped because they were about to meet.
struct FrontContact {
    DirectionPair pair;
    geodesic::Point2 place1, place2;  ///< of the two vertices, in the chart, each in its own period
};

/// A vertex of the front that was stopped alone: past a conjugate point, or in a cusp.
struct LocalStop {
    double theta = 0;
    double t = 0;
    geodesic::Point2 place;
};

struct FrontSnapshot {
    double t = 0;
    std::vector<geodesic::Point2> points;  ///< closed polygon in the universal cover of the chart
};

struct FrontResult {
    std::vector<FrontContact> contacts;
    std::vector<LocalStop> local_stops;
    std::vector<double> free_directions;  ///< of the vertices that reached max_distance
    std::vector<FrontSnapshot> snapshots;
    double distance = 0;  ///< radius at which the last vertex stopped
    int steps = 0;
    std::size_t vertices = 0;  ///< of the last front
};

/// Algorithm of thesis 5.2.2. Throws core::Cancelled, core::RunError when the front does not come to an end, and
/// core::UsageError for parameters out of range.
FrontResult grow_front(const geodesic::Metric& metric, const geodesic::Point2& origin,
                       const FrontParameters& parameters, core::Observer& observer);

}  // namespace dsc::cutlocus
