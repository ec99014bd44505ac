// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of the cut locus share: surfaces, the certificate as a check, distances modulo the periods.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "apps/cutlocus/cutlocus.h"
#include "core/random.h"
#include "geodesic/expression_metric.h"
#include "geodesic/torus.h"

namespace dsc::tests {

using std::numbers::pi;
inline const geodesic::ChartPeriods torus_periods{2 * pi, 2 * pi};

inline cutlocus::CutLocus locus_of(const geodesic::Metric& metric, const geodesic::Point2& p,
                                   const cutlocus::CutLocusParameters& parameters = {}) {
    core::Observer silent;
    return cutlocus::cut_locus(metric, p, parameters, silent);
}

inline void check_certificate(const cutlocus::CutLocus& locus) {
    for (const std::string& failure : locus.graph.certificate.failures) FAIL_CHECK(failure);
    CHECK(locus.graph.certificate.holds());
    CHECK(locus.graph.certificate.components == 1);
    CHECK(locus.graph.certificate.betti1 == 2);
    CHECK(std::abs(locus.graph.certificate.relative_area_error()) <= 1e-8);
}

/// Distance in the chart modulo the periods.
inline double chart_distance(const geodesic::Metric& metric, const geodesic::Point2& a, const geodesic::Point2& b) {
    return metric.periods().wrapped(a - b).norm();
}

/// Difference of two angles modulo 2π.
inline double angle_between(double a, double b) { return std::abs(std::remainder(a - b, 2 * pi)); }

/// The vertices of one degree.
inline std::vector<cutlocus::CutVertex> vertices_of_degree(const cutlocus::CutGraph& graph, int degree) {
    std::vector<cutlocus::CutVertex> found;
    for (const cutlocus::CutVertex& vertex : graph.vertices)
        if (vertex.degree == degree) found.push_back(vertex);
    return found;
}

/// Distance in the chart from `x` to the nearest of `vertices`.
inline double distance_to_nearest(const geodesic::Metric& metric, const std::vector<cutlocus::CutVertex>& vertices,
                                  const geodesic::Point2& x) {
    double nearest = 1e300;
    for (const cutlocus::CutVertex& vertex : vertices) nearest = std::min(nearest, chart_distance(metric, vertex.x, x));
    return nearest;
}

inline std::vector<double> sorted_lengths(const cutlocus::CutGraph& graph) {
    std::vector<double> lengths;
    for (const cutlocus::CutArc& arc : graph.arcs) lengths.push_back(arc.length);
    std::sort(lengths.begin(), lengths.end());
    return lengths;
}

/// Torus with a section of radius 1 + 0.15 cos(2u + v): no symmetry.
inline const std::string bumpy_torus =
    "x=(2+(1+0.15*cos(2*u+v))*cos(v))*cos(u);y=(2+(1+0.15*cos(2*u+v))*cos(v))*sin(u);z=(1+0.15*cos(2*u+v))*sin(v)";
/// exp(2f) (du² + dv²) with f = 0.2 (cos u + cos v).
inline const std::string conformal_metric = "E=exp(0.4*(cos(u)+cos(v)));F=0;G=exp(0.4*(cos(u)+cos(v)))";
/// Has an end of the cut locus of `hidden_end_point` on an arc too short for the front to announce.
inline const std::string hidden_end_metric =
    "E=exp(0.009*cos(2*u+1*v+3.442)+-0.262*cos(2*u+0*v+4.994)+0.117*cos(2*u+0*v+4.170))*(1.0+-0.041*cos(2*u+1*v+4.424)"
    "+0.101*cos(2*u+1*v+1.663));F=0.2+0.091*cos(2*u+1*v+2.136)+0.016*cos(1*u+1*v+0.073);"
    "G=exp(0.009*cos(2*u+1*v+3.442)+-0.262*cos(2*u+0*v+4.994)+0.117*cos(2*u+0*v+4.170))*(1.5+-0.052*cos(2*u+1*v+1.719)"
    "+0.095*cos(2*u+1*v+4.066))";
inline const geodesic::Point2 hidden_end_point{1.7858, -0.9127};
/// Has an end next to which the integrator's errors jump enough to spoil a polynomial through the directions.
inline const std::string jumping_end_metric =
    "E=exp(0+(0.159244)*cos(2*u+(3)*v+4.024768)+(-0.270653)*cos(2*u+(-1)*v+3.757742)+(-0.348821)*cos(2*u"
    "+(1)*v+1.935203))*(1+0+(-0.296881)*cos(2*u+(3)*v+2.279517)+(-0.101019)*cos(3*u+(-3)*v+5.940059));"
    "F=0.2+0+(0.034134)*cos(2*u+(1)*v+3.235211)+(0.025979)*cos(3*u+(2)*v+0.261421);"
    "G=exp(0+(0.159244)*cos(2*u+(3)*v+4.024768)+(-0.270653)*cos(2*u+(-1)*v+3.757742)+(-0.348821)*cos(2*u"
    "+(1)*v+1.935203))*(1.5+0+(0.027243)*cos(0*u+(-1)*v+2.201472)+(0.339872)*cos(3*u+(1)*v+0.134766))";
inline const geodesic::Point2 jumping_end_point{2.71517141223728, 0.5032386334517884};

}  // namespace dsc::tests
