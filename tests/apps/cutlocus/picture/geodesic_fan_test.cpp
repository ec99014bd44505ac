// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/picture/geodesic_fan.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "apps/cutlocus/picture/distance_circles.h"
#include "apps/cutlocus/picture/geodesic_table.h"
#include "core/random.h"
#include "geodesic/connect.h"
#include "tests/apps/cutlocus/picture/samples.h"
#include "tests/support/seed.h"

using namespace dsc::cutlocus;
using dsc::core::Random;
using dsc::tests::PictureSample;

namespace {

/// Distance on the surface to the nearest sample of an arc.
double distance_to_locus(const PictureSample& sample, const Point2& x) {
    const auto tensor = sample.metric.tensor(x);
    double least = std::numeric_limits<double>::infinity();
    for (const CutArc& arc : sample.locus.graph.arcs)
        for (const CutSample& s : arc.samples)
            least = std::min(least, tensor.norm(sample.metric.periods().wrapped(x - s.x)));
    return least;
}

}  // namespace

TEST_CASE("the rays of a fan end on the cut locus, their neighbours near them") {
    for (const PictureSample* sample : {&dsc::tests::torus_sample(), &dsc::tests::flat_sample()}) {
        const CutDistance cut(sample->locus);
        const double gap = cut.limit() / 60;
        const auto fan = geodesic_fan(sample->metric, sample->p, cut, {.step = cut.limit() / 50, .largest_gap = gap});
        for (std::size_t i = 0; i < fan.size(); ++i) {
            const FanRay& ray = fan[i];
            const FanRay& next = fan[(i + 1) % fan.size()];
            const Point2 end = ray.states.back().x;
            CHECK(ray.ends_on_locus);
            // Half the spacing of the samples along the arc, and the error of interpolation across it.
            CHECK(distance_to_locus(*sample, end) < 0.0026);
            CHECK(sample->metric.tensor(end).norm(next.states.back().x - end) <= 1.05 * gap);
            CHECK((i == 0 || fan[i - 1].theta < ray.theta));
        }
    }
}

TEST_CASE("places between the states of a ray lie on the geodesic") {
    const PictureSample& sample = dsc::tests::torus_sample();
    const CutDistance cut(sample.locus);
    const auto fan = geodesic_fan(sample.metric, sample.p, cut,
                                  {.directions = 12, .step = cut.limit() / 64, .largest_gap = 100, .length = 6.0});
    REQUIRE(fan.size() == 12);
    dsc::geodesic::GeodesicFlow flow(sample.metric, sample.p);
    for (const FanRay& ray : fan) {
        CHECK(ray.length == 6);
        for (const double t : {0.01, 1.234, 3.3, 5.99, 6.0})
            CHECK((ray.point(t) - flow.shoot(ray.theta, t).x).norm() < 3e-5);
    }
}

TEST_CASE("a distance circle consists of places at its distance and ends on the cut locus") {
    const PictureSample& sample = dsc::tests::torus_sample();
    const CutDistance cut(sample.locus);
    const auto fan =
        geodesic_fan(sample.metric, sample.p, cut, {.step = cut.limit() / 64, .largest_gap = cut.limit() / 150});
    GeodesicTable table(sample.metric, sample.p, cut, cut.limit() / 100);
    for (const double radius : round_radii(sample.locus.graph.farthest.distance, 9)) {
        const auto lines = distance_circle(fan, sample.locus.graph, sample.metric.periods(), radius);
        REQUIRE(!lines.empty());
        for (const Polyline& line : lines) {
            for (const Point2& x : line) CHECK(std::abs(table.geodesic_to(x).distance - radius) < 2e-3);
            for (std::size_t i = 1; i < line.size(); ++i)
                CHECK(sample.metric.tensor(line[i]).norm(line[i] - line[i - 1]) < cut.limit() / 100);
            const bool is_closed = (line.front() - line.back()).norm() < 1e-12;
            CHECK((is_closed || distance_to_locus(sample, line.front()) < 0.0026));
            CHECK((is_closed || distance_to_locus(sample, line.back()) < 0.0026));
        }
    }
}

TEST_CASE("the table gives directions and distances of known geodesics") {
    const PictureSample& sample = dsc::tests::torus_sample();
    const CutDistance cut(sample.locus);
    GeodesicTable table(sample.metric, sample.p, cut, cut.limit() / 100);
    dsc::geodesic::GeodesicFlow flow(sample.metric, sample.p);
    Random random(dsc::tests::seed(3));
    for (int i = 0; i < 300; ++i) {
        const double theta = 2 * std::numbers::pi * random.uniform();
        const double share = random.uniform();
        const double t = cut.reach(theta).distance * share;
        const auto state = flow.shoot(theta, t);
        const GeodesicTable::Answer answer = table.geodesic_to(sample.metric.periods().wrapped(state.x));
        const Polyline line = table.line(answer, 0.1);
        const double miss = sample.metric.tensor(state.x).norm(sample.metric.periods().wrapped(line.back() - state.x));
        // Up to the cut locus conjugate points come near, where directions are ill-conditioned.
        const double allowed = share < 0.9 ? 2e-3 : 0.02 * cut.limit();
        CHECK(std::abs(answer.distance - t) < allowed);
        CHECK(miss < allowed);
    }
}

TEST_CASE("the geodesics of a front's vertices end in them") {
    const PictureSample& sample = dsc::tests::seam_sample();
    const CutDistance cut(sample.locus.front);
    GeodesicTable table(sample.metric, sample.p, cut, cut.limit() / 100);
    table.add_stops(sample.locus.front);
    for (const FrontSnapshot& snapshot : sample.locus.front.snapshots) {
        int below = 0, above = 0;
        for (const Point2& x : snapshot.points) {
            const GeodesicTable::Answer answer = table.geodesic_to_vertex(x);
            const Polyline line = table.line(answer, 0.1);
            const double miss = sample.metric.tensor(x).norm(sample.metric.periods().wrapped(line.back() - x));
            CHECK(miss < 2 * sample.locus.front_spacing);
            CHECK(answer.distance < snapshot.t + 0.01);
            (answer.theta < std::numbers::pi ? above : below) += 1;
        }
        // The surface and p are symmetric, and so is the front.
        CHECK(std::abs(above - below) < 0.1 * (above + below) + 3);
    }
}

TEST_CASE("cut distances from the contacts of a front are those of the cut locus, roughly") {
    const PictureSample& sample = dsc::tests::torus_sample();
    const CutDistance exact(sample.locus), rough(sample.locus.front);
    double sum = 0;
    constexpr int count = 500;
    for (int i = 0; i < count; ++i) {
        const double theta = 2 * std::numbers::pi * i / count;
        sum += std::abs(exact.reach(theta).distance - rough.reach(theta).distance);
    }
    CHECK(sum / count < sample.locus.front_spacing);
}
