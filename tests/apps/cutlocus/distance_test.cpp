// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/distance.h"

#include "tests/apps/cutlocus/independent_geodesic.h"
#include "tests/apps/cutlocus/support.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::cutlocus;
using namespace dsc::geodesic;
using namespace dsc::tests;

namespace {

/// Where a geodesic of the fan passes near the target: at distance t, the target to the left (side > 0) or right.
struct Pass {
    double t, side, gap;
};

/// The length of the shortest geodesic to `target` by brute force: a fan of geodesics as long as `reach`, and bisection
/// between neighbours that pass the target on different sides.
class FanSearch {
public:
    FanSearch(const Metric& metric, const Point2& p, const Point2& target, double reach)
        : metric_(metric), geodesic_(metric, p, 1e-12), target_(target), reach_(reach) {}

    double shortest() {
        constexpr int directions = 1500;
        double shortest = 1e300;
        std::vector<Pass> before = passes(0);
        for (int i = 1; i <= directions; ++i) {
            const double theta = 2 * pi * i / directions;
            const std::vector<Pass> here = passes(theta);
            for (const Pass& a : before)
                for (const Pass& b : here)
                    if (std::abs(a.t - b.t) < 2 * step && (a.side > 0) != (b.side > 0))
                        shortest = std::min(shortest, bisected(theta - 2 * pi / directions, theta, a, b));
            before = here;
        }
        return shortest;
    }

private:
    static constexpr double step = 0.05;

    Vector2 to_target(const Point2& x) const { return metric_.periods().wrapped(target_ - x); }

    /// The pass near `state`, which is at distance t: Newton's method on the component of the gap along the geodesic.
    Pass pass_near(IndependentGeodesic::State state, double t) {
        for (int i = 0; i < 20; ++i) {
            const double along = metric_.tensor(state.x).inner(to_target(state.x), state.velocity);
            if (std::abs(along) < 1e-13) break;
            if (along < 0) {  // backwards: turn round, go, turn again
                state.velocity = -state.velocity;
                geodesic_.advance(state, -along);
                state.velocity = -state.velocity;
            } else {
                geodesic_.advance(state, along);
            }
            t += along;
        }
        const Vector2 gap = to_target(state.x);
        const double side = state.velocity.x() * gap.y() - state.velocity.y() * gap.x();
        return {t, side, metric_.tensor(state.x).norm(gap)};
    }

    std::vector<Pass> passes(double theta) {
        std::vector<Pass> found;
        IndependentGeodesic::State state = geodesic_.start(theta);
        double before = 1e300;
        for (double t = 0; t < reach_; t += step) {
            const double along = metric_.tensor(state.x).inner(to_target(state.x), state.velocity);
            const double gap = metric_.tensor(state.x).norm(to_target(state.x));
            if (before > 0 && before < 1e299 && along <= 0 && gap < 0.2) found.push_back(pass_near(state, t));
            before = along;
            geodesic_.advance(state, step);
        }
        return found;
    }

    double bisected(double low, double high, Pass a, Pass b) {
        for (int i = 0; i < 60 && high - low > 1e-14; ++i) {
            const double middle = (low + high) / 2;
            IndependentGeodesic::State state = geodesic_.start(middle);
            geodesic_.advance(state, (a.t + b.t) / 2);
            const Pass pass = pass_near(state, (a.t + b.t) / 2);
            if ((pass.side > 0) == (a.side > 0))
                low = middle, a = pass;
            else
                high = middle, b = pass;
        }
        return std::max(a.gap, b.gap) < 1e-8 ? (a.t + b.t) / 2 : 1e300;
    }

    const Metric& metric_;
    IndependentGeodesic geodesic_;
    Point2 target_;
    double reach_;
};

/// Each of `thetas` is the direction of one geodesic, and each geodesic has one of them.
void check_directions(const std::vector<GeodesicState>& geodesics, const std::vector<double>& thetas) {
    REQUIRE(geodesics.size() == thetas.size());
    for (const double theta : thetas) {
        double nearest = pi;
        for (const GeodesicState& state : geodesics) nearest = std::min(nearest, angle_between(state.theta, theta));
        CHECK(nearest < 1e-7);
    }
}

constexpr double tolerance = 1e-9;

}  // namespace

TEST_CASE("a point of an arc has its two directions, a branch point three", "[slow]") {
    const TorusOfRevolution torus(2, 2);
    const Point2 p{0, 0.15 * pi};
    const CutLocus locus = locus_of(torus, p);
    check_certificate(locus);
    for (const CutArc& arc : locus.graph.arcs) {
        INFO("arc from " << arc.start << " to " << arc.end << " of length " << arc.length);
        const CutSample& sample = arc.samples[arc.samples.size() / 2];
        const auto geodesics = minimising_geodesics(torus, p, locus.graph, sample.x, tolerance);
        check_directions(geodesics, {sample.theta1, sample.theta2});
        for (const GeodesicState& state : geodesics) CHECK(std::abs(state.t - sample.distance) < 1e-8);
    }
    for (const CutVertex& vertex : vertices_of_degree(locus.graph, 3)) {
        INFO("vertex at " << vertex.x.transpose());
        check_directions(minimising_geodesics(torus, p, locus.graph, vertex.x, tolerance), vertex.thetas);
    }
}

TEST_CASE("the point itself is at distance 0", "[slow]") {
    const TorusOfRevolution torus(2, 1);
    const CutLocus locus = locus_of(torus, {0, 0.5});
    const auto geodesics = minimising_geodesics(torus, {0, 0.5}, locus.graph, {2 * pi, 0.5}, tolerance);
    REQUIRE(geodesics.size() == 1);
    CHECK(geodesics[0].t < tolerance);
}

TEST_CASE("elsewhere one geodesic minimises, as short as the shortest of a fine fan", "[slow]") {
    const TorusOfRevolution torus(2, 2);
    const Point2 p{0, 0.15 * pi};
    const CutLocus locus = locus_of(torus, p);
    check_certificate(locus);
    core::Random random(seed(7));
    for (int i = 0; i < 6; ++i) {
        const Point2 target{random.uniform(-pi, pi), random.uniform(-pi, pi)};
        INFO("target " << target.transpose());
        const auto geodesics = minimising_geodesics(torus, p, locus.graph, target, tolerance);
        REQUIRE(geodesics.size() == 1);
        CHECK(chart_distance(torus, geodesics[0].x, target) < 1e-8);
        FanSearch fan(torus, p, target, geodesics[0].t + 0.5);
        CHECK(std::abs(fan.shortest() - geodesics[0].t) < 1e-8);
    }
}
