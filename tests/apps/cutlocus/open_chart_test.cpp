// SPDX-License-Identifier: GPL-3.0-or-later
// Charts with one period or none: the cut locus as far as asked for.
#include "apps/cutlocus/certificate.h"
#include "core/errors.h"
#include "tests/apps/cutlocus/independent_geodesic.h"
#include "tests/apps/cutlocus/support.h"

using namespace dsc;
using namespace dsc::cutlocus;
using namespace dsc::geodesic;
using namespace dsc::tests;

namespace {

CutLocus locus_within(const Metric& metric, const Point2& p, double max_distance) {
    CutLocusParameters parameters;
    parameters.max_distance = max_distance;
    CutLocus locus = locus_of(metric, p, parameters);
    for (const std::string& failure : locus.graph.certificate.failures) FAIL_CHECK(failure);
    return locus;
}

}  // namespace

TEST_CASE("the cut locus on a flat cylinder is the line opposite to p, up to the distance asked for", "[slow]") {
    const ExpressionMetric cylinder("E=1;F=0;G=1", {2 * pi, std::nullopt});
    const Point2 p = GENERATE(Point2{0, 0}, Point2{1, -2});
    const CutLocus locus = locus_within(cylinder, p, 5);
    const double half = std::sqrt(25 - pi * pi);
    REQUIRE(locus.graph.arcs.size() == 1);
    REQUIRE(locus.graph.vertices.size() == 2);
    for (const CutVertex& vertex : locus.graph.vertices) {
        CHECK(vertex.kind == VertexKind::frontier);
        CHECK(std::abs(vertex.distance - 5) < 1e-9);
    }
    CHECK(distance_to_nearest(cylinder, locus.graph.vertices, p + Vector2(pi, half)) < 1e-9);
    CHECK(distance_to_nearest(cylinder, locus.graph.vertices, p + Vector2(pi, -half)) < 1e-9);
    CHECK(std::abs(locus.graph.length - 2 * half) < 1e-9);
    for (const CutSample& sample : locus.graph.arcs[0].samples)
        CHECK(std::abs(std::abs(cylinder.periods().wrapped(sample.x - p).x()) - pi) < 1e-9);
}

TEST_CASE("on the flat plane there is no cut locus, on a cylinder none within half its girth", "[slow]") {
    const ExpressionMetric plane("E=1;F=0;G=1", {});
    CHECK(locus_within(plane, {0.3, 0.4}, 2).graph.arcs.empty());
    const ExpressionMetric cylinder("E=1;F=0;G=1", {2 * pi, std::nullopt});
    CHECK(locus_within(cylinder, {0, 0}, 3).graph.arcs.empty());
}

TEST_CASE("behind a hill on the plane the cut locus is a ray from a conjugate end", "[slow]") {
    // The hill lies on the axis v = 0, in which everything is symmetric.
    const std::string factor = "(1+3*exp(-4*((u-1)^2+v^2)))";
    const ExpressionMetric plane("E=" + factor + ";F=0;G=" + factor, {});
    const CutLocus locus = locus_within(plane, {0, 0}, 4);
    REQUIRE(locus.graph.arcs.size() == 1);
    REQUIRE(locus.graph.vertices.size() == 2);
    CHECK(vertices_of_degree(locus.graph, 1).size() == 2);
    int ends = 0;
    for (const CutVertex& vertex : locus.graph.vertices) {
        ends += vertex.kind == VertexKind::end ? 1 : 0;
        if (vertex.kind == VertexKind::frontier) CHECK(std::abs(vertex.distance - 4) < 1e-9);
    }
    CHECK(ends == 1);
    IndependentGeodesic geodesic(plane, {0, 0});
    double worst = 0, off_axis = 0;
    for (const CutSample& sample : locus.graph.arcs[0].samples) {
        off_axis = std::max(off_axis, std::abs(sample.x.y()));
        for (const double theta : {sample.theta1, sample.theta2})
            worst = std::max(worst, (geodesic.end(theta, sample.distance) - sample.x).norm());
    }
    CHECK(off_axis < 1e-9);
    CHECK(worst < 1e-9);
}

TEST_CASE("an open chart without a largest distance is refused") {
    const ExpressionMetric plane("E=1;F=0;G=1", {});
    CHECK_THROWS_AS(locus_of(plane, {0, 0}), core::UsageError);
}
