// SPDX-License-Identifier: GPL-3.0-or-later
// The geodesics that end in the vertices of the front: a new one, one between two neighbours, one pushed on to a larger
// distance. Two ways to keep them: integrated with their Jacobi field, a state per vertex; or, as in the thesis (5.2.2
// to 5.2.4), a polyline per vertex, corrected by the two-point solver at every step.
#pragma once

#include <memory>

#include "dsc2d/complex.h"
#include "geodesic/geodesic_flow.h"

namespace dsc::cutlocus {

class FrontGeodesics {
public:
    virtual ~FrontGeodesics() = default;

    /// The geodesic of `v` in direction `theta`, up to distance t.
    virtual void start(core::VertexId v, double theta, double t) = 0;
    /// The geodesic of `v` between those of a (s = 0) and b (s = 1), up to distance t.
    virtual void insert(core::VertexId v, core::VertexId a, core::VertexId b, double s, double t) = 0;
    /// Pushes the end of v's geodesic on to distance t.
    virtual void advance(core::VertexId v, double t) = 0;
    /// The end of v's geodesic. j is positive as long as no conjugate point has been passed, as far as that is known.
    virtual const geodesic::GeodesicState& state(core::VertexId v) const = 0;
};

std::unique_ptr<FrontGeodesics> integrated_geodesics(const dsc2d::Complex& complex, const geodesic::Metric& metric,
                                                     const geodesic::Point2& origin, double tolerance);

/// Polylines with segments no longer than `segment_length`; a corrected end lies within `tolerance` of the distance
/// asked for.
std::unique_ptr<FrontGeodesics> two_point_geodesics(const dsc2d::Complex& complex, const geodesic::Metric& metric,
                                                    const geodesic::Point2& origin, double segment_length,
                                                    double tolerance);

}  // namespace dsc::cutlocus
