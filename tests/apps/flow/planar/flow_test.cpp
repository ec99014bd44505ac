// SPDX-License-Identifier: GPL-3.0-or-later
// Flows in the plane with known answers.
#include "apps/flow/planar/flow.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "apps/flow/planar/initial_complex.h"
#include "core/errors.h"
#include "dsc2d/interface.h"
#include "dsc2d/label_statistics.h"
#include "dsc2d/validate.h"
#include "motion/curl_noise.h"
#include "tests/apps/flow/stop_after.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::flow::planar;
using flow::FlowEnd;
using motion::TopologyPolicy;
using std::numbers::pi;

namespace {

/// A shape, its mesh and a run of it.
struct Run {
    explicit Run(const ShapeOptions& shape, TopologyPolicy policy = TopologyPolicy::preserved)
        : initial(initial_complex(shape)), parameters(deformation(edge_limits(initial), policy)) {
        result.domain = initial.domain;
        result.is_torus = shape.is_torus;
        result.edge_length = initial.edge_length;
        before = places();
    }

    void go(const Targets& targets, int steps, double until = 1) {
        core::Observer observer;
        go(targets, steps, until, observer);
    }
    void go(const Targets& targets, int steps, double until, core::Observer& observer) {
        result.time = {until / steps, until, steps};
        Snapshots snapshots({}, steps, 0);
        run_flow(initial.complex, parameters, targets, snapshots, observer, result);
        CHECK(validate(initial.complex).empty());
        for (const StepRecord& step : result.steps) REQUIRE(step.inverted == 0);
    }
    void go(const MotionOptions& motion, int steps, double until = 1) {
        go(motion_targets(motion, initial.domain, initial.edge_length, until), steps, until);
    }

    std::vector<Point2> places() const {
        std::vector<Point2> found;
        for (const core::VertexId v : dsc2d::Interface(initial.complex).vertices)
            found.push_back(initial.complex.position(v));
        return found;
    }
    const dsc2d::LabelStatistics& label(int number) const {
        for (const dsc2d::LabelStatistics& found : result.steps.back().labels)
            if (found.label == number) return found;
        throw core::RunError("the label is gone");
    }
    double largest_area_change() const {
        double largest = 0;
        for (const StepRecord& step : result.steps)
            for (std::size_t i = 0; i < step.labels.size(); ++i)
                largest = std::max(largest, std::abs(step.labels[i].area - result.steps[0].labels[i].area));
        return largest;
    }
    double smallest_angle() const {
        double smallest = 90;
        for (const StepRecord& step : result.steps) smallest = std::min(smallest, step.min_angle);
        return smallest;
    }
    std::size_t events(const std::string& kind) const {
        std::size_t count = 0;
        for (const auto& event : result.events) count += event.kind == kind ? 1 : 0;
        return count;
    }

    InitialComplex initial;
    dsc2d::Parameters parameters;
    FlowResult result;
    std::vector<Point2> before;
};

// Distance of each place of one set to the nearest of the other one.
double hausdorff(const std::vector<Point2>& a, const std::vector<Point2>& b) {
    double largest = 0;
    for (const auto* sets : {&a, &b})
        for (const Point2& p : *sets) {
            double nearest = 1e9;
            for (const Point2& q : sets == &a ? b : a) nearest = std::min(nearest, (p - q).norm());
            largest = std::max(largest, nearest);
        }
    return largest;
}

void check_rigid(const Run& run) {
    CHECK(run.result.end == FlowEnd::done);
    CHECK(run.largest_area_change() <= 1e-9);
    CHECK(run.smallest_angle() >= 10);
    CHECK(run.result.events.empty());
    for (const StepRecord& step : run.result.steps) {
        REQUIRE(step.is_complete);
        REQUIRE(step.unchanged_share == 1);
    }
}

}  // namespace

TEST_CASE("a turn by 360 degrees in 50 steps ends where it began, in a box that stays") {
    for (const Shape shape : {Shape::disc, Shape::slotted_disc}) {
        Run run({.shape = shape});
        run.go(MotionOptions{.motion = Motion::rotate, .angle = 360}, 50);
        check_rigid(run);
        CHECK(hausdorff(run.before, run.places()) <= 1e-9);
    }
}

TEST_CASE("three labels turned by 90 degrees keep their areas and their triple point") {
    Run run({.shape = Shape::labelled_block});
    run.go(MotionOptions{.motion = Motion::rotate, .about = Point2(0.4, 0.5), .angle = 90}, 20);
    check_rigid(run);
    CHECK(run.result.steps.back().labels.size() == 4);
    for (Point2& p : run.before) p = Point2(0.4 - (p.y() - 0.5), 0.5 + (p.x() - 0.4));
    CHECK(hausdorff(run.before, run.places()) <= 1e-9);
}

TEST_CASE("on a torus, shapes cross the seam as often as they like") {
    Run run({.shape = Shape::disc, .is_torus = true});
    run.go(MotionOptions{.motion = Motion::translate, .velocity = {7, -5}}, 100);
    check_rigid(run);
    for (Point2& p : run.before) p -= p.array().floor().matrix();
    std::vector<Point2> after = run.places();
    for (Point2& p : after) p -= p.array().floor().matrix();
    CHECK(hausdorff(run.before, after) <= 1e-9);
}

TEST_CASE("a circle of 200 edges shrinks as sqrt(r0^2 - 2 t), and vanishes where it may") {
    const ShapeOptions circle{.shape = Shape::disc, .radius = 0.3, .edge_length = 0.3 * 2 * pi / 200};
    Run run(circle);
    CHECK(run.before.size() == 200);
    run.go(MotionOptions{.motion = Motion::curvature}, 20, 0.375 * 0.09);
    const std::vector<Point2> places = run.places();
    Point2 centre = Point2::Zero();
    for (const Point2& p : places) centre += p / static_cast<double>(places.size());
    double mean = 0;
    for (const Point2& p : places) mean += (p - centre).norm() / static_cast<double>(places.size());
    CHECK(mean == Approx(0.15).epsilon(1e-3));
    CHECK(run.smallest_angle() > 10);

    Run vanishing(circle, TopologyPolicy::adaptive);
    vanishing.go(MotionOptions{.motion = Motion::curvature}, 60, 0.06);
    CHECK(vanishing.result.end == FlowEnd::vanished);
    CHECK(vanishing.result.steps.back().time == Approx(0.045).margin(0.0011));
    REQUIRE(vanishing.events("vanish") == 1);
    CHECK((vanishing.result.events.back().place - Point2(0.5, 0.5)).norm() < std::sqrt(0.09 - 2 * 0.044));
    CHECK(vanishing.result.events.back().label == 1);
}

TEST_CASE("two discs that grow merge or are stopped, as the policy says") {
    for (const TopologyPolicy policy : {TopologyPolicy::adaptive, TopologyPolicy::merge_only,
                                        TopologyPolicy::split_only, TopologyPolicy::preserved}) {
        CAPTURE(static_cast<int>(policy));
        Run run({.shape = Shape::two_discs}, policy);
        run.go(MotionOptions{.motion = Motion::offset, .distance = 0.04}, 8);
        if (policy == TopologyPolicy::adaptive || policy == TopologyPolicy::merge_only) {
            CHECK(run.smallest_angle() > 10);
            const double r = 0.19, d = 0.31;
            const double lens = 2 * r * r * std::acos(d / (2 * r)) - d / 2 * std::sqrt(4 * r * r - d * d);
            CHECK(run.label(1).components == 1);
            CHECK(run.label(1).holes == 0);
            CHECK(run.label(1).area == Approx(2 * pi * r * r - lens).epsilon(3e-3));
            CHECK(run.events("merge") > 0);
            CHECK(run.events("contact") == 0);
        } else {
            CHECK(run.label(1).components == 2);
            CHECK(run.events("merge") == 0);
            CHECK(run.events("contact") > 0);
            CHECK(run.smallest_angle() > 5);
            for (const StepRecord& step : run.result.steps) {
                REQUIRE(step.counts.topology_changes == 0);
                for (const Unfinished& motion : step.unfinished) CHECK(motion.is_in_contact);
            }
            CHECK(run.result.steps.back().unfinished.size() > 10);
        }
    }
}

TEST_CASE("what was pressed together comes apart again") {
    Run run({.shape = Shape::two_discs});
    run.go(MotionOptions{.motion = Motion::expression, .expressions = "((x<0.5 ? 1 : -1)*(t<0.5 ? 0.06 : -0.12), 0)"},
           20);
    CHECK(run.events("contact") > 0);
    CHECK(run.label(1).components == 2);
    CHECK(run.result.steps.back().unfinished.empty());
    double least_gap = 1;
    for (const Point2& p : run.places()) least_gap = std::min(least_gap, std::abs(p.x() - 0.5));
    CHECK(least_gap > 0.01);
}

TEST_CASE("the hole of a ring closes or stays, a dumbbell falls into two or holds") {
    Run closing({.shape = Shape::ring, .radius = 0.15, .minor_radius = 0.05}, TopologyPolicy::adaptive);
    closing.go(MotionOptions{.motion = Motion::offset, .distance = 0.12}, 20);
    CHECK(closing.label(1).holes == 0);
    CHECK(closing.label(1).area == Approx(pi * 0.32 * 0.32).epsilon(0.01));
    CHECK(closing.events("vanish") == 1);
    Run staying({.shape = Shape::ring, .radius = 0.15, .minor_radius = 0.05}, TopologyPolicy::preserved);
    staying.go(MotionOptions{.motion = Motion::offset, .distance = 0.12}, 20);
    CHECK(staying.label(1).holes == 1);
    CHECK(staying.smallest_angle() > 5);

    const ShapeOptions dumbbell{.shape = Shape::dumbbell, .radius = 0.15, .minor_radius = 0.05, .spread = 0.5};
    Run splitting(dumbbell, TopologyPolicy::split_only);
    splitting.go(MotionOptions{.motion = Motion::offset, .distance = -0.08}, 20);
    CHECK(splitting.label(1).components == 2);
    CHECK(splitting.events("split") > 0);
    CHECK(splitting.smallest_angle() > 10);
    Run holding(dumbbell, TopologyPolicy::merge_only);
    holding.go(MotionOptions{.motion = Motion::offset, .distance = -0.08}, 20);
    CHECK(holding.label(1).components == 1);
    CHECK(holding.events("contact") > 0);
}

TEST_CASE("a square that is offset outwards or inwards keeps its corners") {
    for (const double distance : {0.1, -0.1}) {
        Run run({.shape = Shape::box, .size = Point2(0.4, 0.4)});
        run.go(MotionOptions{.motion = Motion::offset, .distance = distance}, 10);
        const double half = 0.2 + distance;
        for (const Point2& p : run.places())
            CHECK((p - Point2(0.5, 0.5)).cwiseAbs().maxCoeff() == Approx(half).epsilon(1e-12));
        // In each step, coordinates are rounded to the grid of the domain.
        const double rounding = 10 * 8 * half * run.initial.complex.domain().quantum();
        CHECK(run.label(1).area == Approx(4 * half * half).margin(rounding));
    }
}

TEST_CASE("motion that is no number, or leads out of the box, ends the run in its last good state") {
    Run lost({.shape = Shape::disc});
    lost.go(MotionOptions{.motion = Motion::expression, .expressions = "(t<0.35 ? 0 : 0/(x-x), 0)"}, 10);
    CHECK(lost.result.end == FlowEnd::stopped);
    CHECK_THAT(lost.result.reason,
               Catch::Contains("vertex") && Catch::Contains("not finite") && Catch::Contains("time"));
    CHECK(lost.result.steps.size() == 4);

    Run leaving({.shape = Shape::disc});
    leaving.go(MotionOptions{.motion = Motion::translate, .velocity = {1, 0}}, 10);
    CHECK(leaving.result.end == FlowEnd::stopped);
    CHECK_THAT(leaving.result.reason, Catch::Contains("out of the box"));
    CHECK(leaving.smallest_angle() > 5);
    CHECK(leaving.largest_area_change() < 1e-12);
}

TEST_CASE("a run can be stopped, and the same run has the same bits") {
    tests::StopAfter stop(3);
    Run run({.shape = Shape::disc});
    run.go(motion_targets({}, run.initial.domain, run.initial.edge_length, 1), 10, 1, stop);
    CHECK(run.result.end == FlowEnd::cancelled);
    CHECK(run.result.steps.size() == 4);

    std::vector<Point2> places[2];
    for (auto& found : places) {
        Run again({.shape = Shape::two_discs}, TopologyPolicy::adaptive);
        again.go(MotionOptions{.motion = Motion::offset, .distance = 0.03}, 6);
        found = again.places();
    }
    CHECK(places[0] == places[1]);
}

TEST_CASE("random flows leave a valid mesh after every step, and where it is preserved, the topology", "[slow]") {
    for (const TopologyPolicy policy : {TopologyPolicy::adaptive, TopologyPolicy::preserved}) {
        Run run({.shape = Shape::labelled_block, .size = Point2(0.5, 0.5)}, policy);
        const int steps = policy == TopologyPolicy::adaptive ? 400 : 200;
        const auto components = [](const dsc2d::Complex& complex) {
            std::vector<std::array<std::int64_t, 3>> found;
            for (const auto& label : dsc2d::label_statistics(complex))
                found.push_back({label.label, label.components, label.holes});
            return found;
        };
        const auto first = components(run.initial.complex);
        const std::uint64_t seed = tests::seed(11);
        int call = 0;
        motion::VelocityField<2> noise;
        const Targets targets = [&](const dsc2d::Complex& complex, double time, double dt) {
            REQUIRE(validate(complex).empty());
            if (policy == TopologyPolicy::preserved) REQUIRE(components(complex) == first);
            const double speed = 0.5 * run.initial.edge_length;
            if (call++ % 50 == 0)
                noise = motion::curl_noise(motion::CurlNoiseParameters<2>{
                    .has_walls = true, .max_speed = speed, .seed = seed + static_cast<std::uint64_t>(call)});
            std::vector<std::optional<Point2>> wanted(complex.vertex_capacity());
            for (const core::VertexId v : dsc2d::Interface(complex).vertices)
                if (!complex.is_boundary(v))
                    wanted[v.index()] = complex.position(v) + dt * noise(complex.position(v), time);
            return wanted;
        };
        run.go(targets, steps, steps);
        CHECK(run.result.end == FlowEnd::done);
        CHECK(run.result.steps.size() == static_cast<std::size_t>(steps) + 1);
        const bool is_adaptive = policy == TopologyPolicy::adaptive;
        if (is_adaptive) CHECK(run.smallest_angle() > 1);
        CHECK((run.events("merge") + run.events("split") > 100) == is_adaptive);
        CHECK((run.events("contact") > 100) == !is_adaptive);
    }
}

TEST_CASE("a step through many periods arrives, and nothing vanishes on the way") {
    ShapeOptions shape{.radius = 0.3, .edge_length = 0.1, .domain = Eigen::AlignedBox2d(Point2(0, 0), Point2(1, 1))};
    shape.is_torus = true;
    Run run(shape);
    run.go({.motion = Motion::translate, .velocity = Point2(100, -37)}, 1);
    CHECK(run.result.end == FlowEnd::done);
    CHECK(run.result.steps.back().is_complete);
    CHECK(run.largest_area_change() <= 1e-9);
    CHECK(run.result.events.empty());
}

TEST_CASE("a step beyond all reach is refused, with the state before") {
    ShapeOptions shape{.radius = 0.1, .domain = Eigen::AlignedBox2d(Point2(0, 0), Point2(1, 1))};
    shape.is_torus = true;
    Run run(shape);
    const std::vector<Point2> before = run.before;
    run.go({.motion = Motion::translate, .velocity = Point2(1e12, 0)}, 1);
    CHECK(run.result.end == FlowEnd::stopped);
    CHECK_THAT(run.result.reason, Catch::Contains("smaller steps"));
    CHECK(run.places() == before);
}

TEST_CASE("a step that is stopped in the middle is recorded as far as it went") {
    class StopAfter final : public core::Observer {
    public:
        explicit StopAfter(int questions) : left_(questions) {}
        bool is_cancelled() const override { return left_-- <= 0; }

    private:
        mutable int left_;
    } observer(5);
    Run run({.radius = 0.1});
    run.go(motion_targets({.motion = Motion::translate, .velocity = Point2(0.2, 0)}, run.initial.domain,
                          run.initial.edge_length, 1),
           1, 1, observer);
    CHECK(run.result.end == FlowEnd::cancelled);
    REQUIRE(run.result.steps.size() == 2);
    const double time = run.result.steps.back().time;
    CHECK(time > 0);
    CHECK(time < 1);
    for (std::size_t i = 0; i < run.before.size(); ++i)
        CHECK((run.places()[i] - run.before[i] - Point2(0.2 * time, 0)).norm() < 1e-12);
}

TEST_CASE("a shear turns a box into a parallelogram; curl noise keeps areas, on a torus too") {
    Run sheared({.shape = Shape::box, .size = Point2(0.2, 0.2), .edge_length = 0.05});
    sheared.go({.motion = Motion::shear, .direction = Point2(1, 0), .gradient = Point2(0, 1)}, 5);
    Eigen::AlignedBox2d bounds;
    for (const Point2& p : sheared.places()) bounds.extend(p);
    CHECK(bounds.sizes().x() == Approx(0.4).epsilon(1e-12));
    CHECK(sheared.label(1).area == Approx(0.04).epsilon(1e-12));
    for (const bool is_torus : {false, true}) {
        Run stirred({.shape = Shape::disc, .radius = 0.2, .edge_length = 0.02, .is_torus = is_torus});
        stirred.go({.motion = Motion::curl_noise, .speed = 0.1, .has_walls = !is_torus}, 10);
        CHECK(stirred.largest_area_change() < 2e-3 * stirred.result.steps[0].labels[1].area);
        CHECK(stirred.places() != stirred.before);
    }
}
