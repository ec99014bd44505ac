// SPDX-License-Identifier: GPL-3.0-or-later
// An arc is followed from its conjugate end where the integrator's errors make the directions uncertain.
#include "apps/cutlocus/arc_curve.h"

#include "geodesic/scaled_metric.h"
#include "tests/apps/cutlocus/independent_geodesic.h"
#include "tests/apps/cutlocus/support.h"

using namespace dsc;
using namespace dsc::cutlocus;
using namespace dsc::geodesic;
using namespace dsc::tests;

namespace {

/// The arc from the conjugate end near (theta, t) to the half difference w of its directions.
ArcCurve arc_from_end(const Metric& metric, const Point2& p, double theta, double t, double w, double tolerance) {
    GeodesicFlow flow(metric, p, tolerance / 10);
    const auto end = conjugate_end(flow, theta, t);
    REQUIRE(end);
    Meeting first;
    first.middle = end->theta, first.t = end->t, first.first = first.second = *end;
    // In steps: the meeting at w is found from that at w / 2.
    double middle = end->theta, distance = end->t;
    std::vector<Meeting> anchors{first};
    for (const double part : {0.125, 0.25, 0.5, 1.0}) {
        const auto meeting = meet(flow, part * w, {0, 0}, middle, distance);
        REQUIRE(meeting);
        middle = meeting->middle, distance = meeting->t;
        anchors.push_back(*meeting);
    }
    return {flow, anchors, {.tolerance = tolerance, .fine_step_tolerance = tolerance / 1000}};
}

}  // namespace

TEST_CASE("an arc is followed from a conjugate end through the integrator's errors") {
    // Twice as large, the arc has twice the length; there the errors jump with the steps of the integrator.
    constexpr double tolerance = 1e-10, w = 0.3;
    const ExpressionMetric metric(jumping_end_metric, torus_periods);
    const ArcCurve arc = arc_from_end(metric, jumping_end_point, 5.757042475, 2.860521349, w, tolerance);
    const ScaledMetric twice(metric, 2);
    const ArcCurve twice_as_long =
        arc_from_end(twice, jumping_end_point, 5.757042475, 2 * 2.860521349, w, 2 * tolerance);
    CHECK(std::abs(twice_as_long.length() / 2 - arc.length()) <= tolerance);
    CHECK(twice_as_long.residual() <= 2 * tolerance);

    IndependentGeodesic geodesic(twice, jumping_end_point);
    for (const CutSample& sample : twice_as_long.samples(20))
        for (const double theta : {sample.theta1, sample.theta2})
            CHECK(twice.tensor(sample.x).norm(geodesic.end(theta, sample.distance) - sample.x) <= 1e-9);
}
