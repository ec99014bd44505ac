// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic/two_point.h"

#include <gsl/gsl_odeiv2.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <new>

#include "geodesic/expression_metric.h"
#include "geodesic/torus.h"
#include "tests/geodesic/samples.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::geodesic;
using namespace dsc::tests;

namespace {

/// A geodesic of unit speed on the torus ((R + cos v) cos u, ..., lambda sin v), integrated by GSL from the equations
/// of Clairaut's Lagrangian: independent of the code under test. State: u, v, u', v'.
struct TrueGeodesic {
    double radius, lambda;

    std::array<double, 4> at(const Point2& origin, double angle, double t) const {
        const double c = std::cos(origin.y()), s = std::sin(origin.y());
        std::array<double, 4> y{origin.x(), origin.y(), std::cos(angle) / (radius + c),
                                std::sin(angle) / std::sqrt(s * s + lambda * lambda * c * c)};
        gsl_odeiv2_system system{derivative, nullptr, 4, const_cast<TrueGeodesic*>(this)};
        gsl_odeiv2_driver* driver = gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-3, 1e-14, 1e-14);
        double now = 0;
        REQUIRE(gsl_odeiv2_driver_apply(driver, &now, t, y.data()) == 0);
        gsl_odeiv2_driver_free(driver);
        return y;
    }

private:
    static int derivative(double, const double y[], double dydt[], void* parameters) {
        const auto& torus = *static_cast<const TrueGeodesic*>(parameters);
        const double c = std::cos(y[1]), s = std::sin(y[1]), rho = torus.radius + c;
        const double l2 = torus.lambda * torus.lambda, g = s * s + l2 * c * c;
        dydt[0] = y[2];
        dydt[1] = y[3];
        dydt[2] = 2 * s / rho * y[2] * y[3];
        dydt[3] = (-rho * s * y[2] * y[2] - (1 - l2) * s * c * y[3] * y[3]) / g;
        return 0;
    }
};

/// Counts what the solver asks for.
class CountingMetric final : public Metric {
public:
    explicit CountingMetric(const Metric& metric) : Metric(metric.periods()), metric_(metric) {}
    MetricTensor tensor(const Point2& x) const override { return ++tensors, metric_.tensor(x); }
    LocalGeometry local_geometry(const Point2& x) const override { return ++others, metric_.local_geometry(x); }
    ConnectionJet connection_jet(const Point2& x) const override { return ++jets, metric_.connection_jet(x); }

    mutable long tensors = 0, jets = 0, others = 0;

private:
    const Metric& metric_;
};

/// The largest component of the finite-difference equation (5.4), written as the thesis has it.
double largest_defect(const Metric& metric, const std::vector<Point2>& nodes) {
    double largest = 0;
    for (std::size_t p = 1; p + 1 < nodes.size(); ++p) {
        const LocalGeometry local = metric.local_geometry(nodes[p]);
        const Vector2 d = nodes[p + 1] - nodes[p - 1];
        const auto term = [&](const std::array<double, 3>& symbols) {
            return symbols[0] * d.x() * d.x() + 2 * symbols[1] * d.x() * d.y() + symbols[2] * d.y() * d.y();
        };
        const Vector2 defect = (nodes[p + 1] + nodes[p - 1]) / 2 - nodes[p] +
                               Vector2{term(local.christoffel_u), term(local.christoffel_v)} / 8;
        largest = std::max(largest, defect.lpNorm<Eigen::Infinity>());
    }
    return largest;
}

}  // namespace

#ifndef __SANITIZE_ADDRESS__  // the sanitizer counts on its own operators
#define DSC_COUNTS_ALLOCATIONS
namespace {
std::atomic<long> allocations{0};
}
void* operator new(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
#endif

TEST_CASE("the two-point solution satisfies the thesis' equation (5.4)") {
    core::Random random(tests::seed(8));
    const TorusOfRevolution torus(2, 2);
    const ExpressionEmbedding bumpy(bumpy_embedding, torus_periods);
    const ExpressionMetric skew(skew_tensor, torus_periods);
    for (const Metric* metric :
         {static_cast<const Metric*>(&torus), static_cast<const Metric*>(&bumpy), static_cast<const Metric*>(&skew)}) {
        TwoPointSolver solver(*metric);
        for (int i = 0; i < 20; ++i) {
            const Point2 from = random_point(random), to = from + Point2(random.uniform(-1, 1), random.uniform(-1, 1));
            std::vector<Point2> nodes = straight_polyline(from, to, 50);
            const TwoPointReport report = solver.solve(nodes);
            REQUIRE(report.is_converged);
            REQUIRE(nodes.front() == from);
            REQUIRE(nodes.back() == to);
            REQUIRE(largest_defect(*metric, nodes) < 1e-14);
            REQUIRE(report.length == length(*metric, nodes));
        }
    }
}

TEST_CASE("the two-point solver is of second order in h") {
    for (const double lambda : {1.0, 2.0}) {
        const TrueGeodesic truth{2, lambda};
        const TorusOfRevolution torus(2, lambda);
        const Point2 origin{0.2, 0.4};
        const double angle = 0.9, distance = 3;
        const auto end = truth.at(origin, angle, distance), middle = truth.at(origin, angle, distance / 2);
        const auto start = truth.at(origin, angle, 0);
        TwoPointSolver solver(torus);
        std::array<double, 4> previous{};
        for (int segments = 32; segments <= 512; segments *= 2) {
            std::vector<Point2> nodes = straight_polyline(origin, {end[0], end[1]}, segments);
            const TwoPointReport report = solver.solve(nodes);
            REQUIRE(report.is_converged);
            const std::array errors{
                (nodes[static_cast<std::size_t>(segments) / 2] - Point2(middle[0], middle[1])).norm(),
                std::abs(report.length - distance), (report.initial_direction - Vector2(start[2], start[3])).norm(),
                (report.final_direction - Vector2(end[2], end[3])).norm()};
            for (std::size_t i = 0; i < errors.size(); ++i) {
                INFO("lambda " << lambda << ", segments " << segments << ", quantity " << i);
                CHECK(errors[i] < 40.0 / (segments * segments));
                if (segments >= 256) CHECK(std::log2(previous[i] / errors[i]) == Approx(2).margin(0.1));
            }
            previous = errors;
        }
    }
}

TEST_CASE("Newton's method of the two-point solver is quadratic") {
    const TorusOfRevolution torus(2, 2);
    const ExpressionEmbedding embedding(torus_embedding(2, 2), torus_periods);
    const ExpressionMetric tensor(torus_tensor(2, 2), torus_periods);
    const ExpressionMetric skew(skew_tensor, torus_periods);
    for (const Metric* metric : {static_cast<const Metric*>(&torus), static_cast<const Metric*>(&embedding),
                                 static_cast<const Metric*>(&tensor), static_cast<const Metric*>(&skew)}) {
        TwoPointSolver solver(*metric);
        std::vector<Point2> nodes = straight_polyline({0, 0.3}, {1, 2}, 200);
        REQUIRE(solver.solve(nodes).is_converged);
        const auto corrections = solver.corrections();
        REQUIRE(corrections.size() >= 4);
        int judged = 0;
        for (std::size_t i = 0; i + 1 < corrections.size(); ++i)
            if (corrections[i] < 0.1 && corrections[i] > 1e-8) {
                // Each correction is bounded by a constant times the square of the one before.
                CHECK(corrections[i + 1] < 3 * corrections[i] * corrections[i] + 1e-15);
                ++judged;
            }
        CHECK(judged >= 2);
    }
}

TEST_CASE("the cost of the two-point solver is linear in the number of nodes") {
    const TorusOfRevolution torus(2, 2);
    for (const int segments : {100, 1000, 10000, 100000}) {
        const CountingMetric counting(torus);
        TwoPointSolver solver(counting);
        std::vector<Point2> nodes = straight_polyline({0, 0.3}, {1, 2}, segments);
        const TwoPointReport report = solver.solve(nodes);
        REQUIRE(report.is_converged);
        CHECK(report.iterations <= 6);  // does not grow with the number of nodes
        CHECK(counting.jets == (segments - 1L) * report.iterations);
        CHECK(counting.tensors == segments + 2);
        CHECK(counting.others == 0);
        CHECK(solver.corrections().back() < 1e-14);
    }
}

#ifdef DSC_COUNTS_ALLOCATIONS
TEST_CASE("a two-point solver allocates nothing once it has seen as many nodes") {
    const TorusOfRevolution torus(2, 2);
    TwoPointSolver solver(torus);
    std::vector<Point2> nodes = straight_polyline({0, 0.3}, {1, 2}, 300), again = nodes;
    again[150] += Vector2{0.1, -0.1};
    solver.solve(nodes);
    const long before = allocations;
    const bool is_converged = solver.solve(again).is_converged && solver.solve(std::span(again).first(50)).is_converged;
    const long after = allocations;  // read before Catch, which allocates
    CHECK(after == before);
    CHECK(is_converged);
    CHECK((again[100] - nodes[100]).norm() < 1e-13);
}
#endif

TEST_CASE("the two-point solver finds the geodesic of the homotopy class it starts in") {
    const TorusOfRevolution torus(2, 1);
    TwoPointSolver solver(torus);
    // Half way round the outer equator, the inner equator and a meridian: closed geodesics by symmetry.
    const auto solved_length = [&](const Point2& from, const Point2& to) {
        std::vector<Point2> nodes = straight_polyline(from, to, 400);
        REQUIRE(solver.solve(nodes).is_converged);
        return length(torus, nodes);
    };
    CHECK(solved_length({0, 0}, {1, 0}) == Approx(3).epsilon(1e-12));
    CHECK(solved_length({0, pi}, {1, pi}) == Approx(1).epsilon(1e-12));
    CHECK(solved_length({0.3, -1}, {0.3, 2}) == Approx(3).epsilon(1e-12));
    CHECK(solved_length({0.3, 0}, {0.3, 2 * pi}) == Approx(2 * pi).epsilon(1e-12));
}

TEST_CASE("rough polylines are smoothed and converge to the same geodesic") {
    core::Random random(tests::seed(13));
    const TorusOfRevolution torus(2, 2);
    TwoPointSolver solver(torus);
    std::vector<Point2> smooth = straight_polyline({0, 0.3}, {1, 2}, 300);
    REQUIRE(solver.solve(smooth).is_converged);
    for (int i = 0; i < 20; ++i) {
        std::vector<Point2> rough = straight_polyline({0, 0.3}, {1, 2}, 300);
        for (std::size_t p = 1; p < 300; ++p)
            rough[p] += Vector2{random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05)};
        REQUIRE(solver.solve(rough).is_converged);
        CHECK((rough[100] - smooth[100]).norm() < 1e-12);
    }
}

TEST_CASE("polylines without inner nodes and points that coincide") {
    const TorusOfRevolution torus(2, 1);
    TwoPointSolver solver(torus);
    std::vector<Point2> two = straight_polyline({0, 0}, {0.1, 0}, 1);
    const TwoPointReport report = solver.solve(two);
    CHECK(report.is_converged);
    CHECK(report.iterations == 0);
    CHECK(report.length == Approx(0.3).epsilon(1e-14));
    CHECK((report.initial_direction - Vector2(1.0 / 3, 0)).norm() < 1e-14);
    CHECK((report.final_direction - report.initial_direction).norm() < 1e-14);

    std::vector<Point2> three = straight_polyline({0, 0.5}, {0, 1.5}, 2);
    CHECK(solver.solve(three).is_converged);
    CHECK((three[1] - Point2(0, 1)).norm() < 1e-14);

    std::vector<Point2> one_place(5, Point2(1, 1));
    CHECK(solver.solve(one_place).is_converged);
    CHECK(solver.solve(one_place).initial_direction.norm() == 0);
}

TEST_CASE("a two-point problem that leaves the domain of the metric ends without convergence") {
    const ExpressionMetric half_plane("E=1;F=0;G=sqrt(u)", {});
    TwoPointSolver solver(half_plane);
    std::vector<Point2> nodes = straight_polyline({-1, 0}, {1, 1}, 20);
    CHECK_FALSE(solver.solve(nodes).is_converged);
}
