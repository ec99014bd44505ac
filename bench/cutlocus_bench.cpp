// SPDX-License-Identifier: GPL-3.0-or-later
// Cost of the cut locus of p = (0, 0) on the torus with lambda = 2 against tolerance, spacing and spacing of the front,
// and of its parts: one geodesic, one meeting, one query of the metric. One thread.
//
//     cutlocus_bench --benchmark_format=json
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "apps/cutlocus/cutlocus.h"
#include "geodesic/expression_metric.h"
#include "geodesic/meeting.h"
#include "geodesic/torus.h"

namespace {

using namespace dsc;
using namespace dsc::geodesic;

constexpr double pi = std::numbers::pi;
const TorusOfRevolution torus(2, 2);
const char* const torus_embedding = "x=(2+cos(v))*cos(u);y=(2+cos(v))*sin(u);z=2*sin(v)";

void run_cut_locus(benchmark::State& state, const cutlocus::CutLocusParameters& parameters) {
    core::Observer silent;
    std::optional<cutlocus::CutLocus> locus;
    double front_seconds = 0, exact_seconds = 0;
    for (auto _ : state) {
        locus = cutlocus::cut_locus(torus, {0, 0}, parameters, silent);
        front_seconds += locus->front_seconds;
        exact_seconds += locus->exact_seconds;
    }
    if (!locus->graph.certificate.holds()) state.SkipWithError("the certificate does not hold");
    std::size_t points = 0;
    for (const cutlocus::CutArc& arc : locus->graph.arcs) points += arc.samples.size();
    const benchmark::Counter::Flags average = benchmark::Counter::kAvgIterations;
    state.counters["front_s"] = benchmark::Counter(front_seconds, average);
    state.counters["exact_s"] = benchmark::Counter(exact_seconds, average);
    state.counters["points"] = static_cast<double>(points);
    state.counters["residual"] = locus->graph.certificate.residual;
    state.counters["area_error"] = std::abs(locus->graph.certificate.relative_area_error());
}

// Argument: -log10 of the tolerance.
void cut_locus_by_tolerance(benchmark::State& state) {
    cutlocus::CutLocusParameters parameters;
    parameters.tolerance = std::pow(10.0, -static_cast<double>(state.range(0)));
    run_cut_locus(state, parameters);
}
BENCHMARK(cut_locus_by_tolerance)->DenseRange(3, 11, 2)->Unit(benchmark::kMillisecond);

// Argument: spacing of the samples in units of 1e-3.
void cut_locus_by_spacing(benchmark::State& state) {
    cutlocus::CutLocusParameters parameters;
    parameters.spacing = 1e-3 * static_cast<double>(state.range(0));
    run_cut_locus(state, parameters);
}
BENCHMARK(cut_locus_by_spacing)->Arg(50)->Arg(20)->Arg(10)->Arg(5)->Arg(2)->Arg(1)->Unit(benchmark::kMillisecond);

// Argument: relative spacing of the front in units of 1e-3.
void front_by_spacing(benchmark::State& state) {
    core::Observer silent;
    cutlocus::FrontParameters parameters;
    parameters.spacing = 1e-3 * static_cast<double>(state.range(0)) * std::sqrt(total_area(torus));
    parameters.time_step = parameters.spacing / 2;
    parameters.snapshots = 0;
    std::optional<cutlocus::FrontResult> front;
    for (auto _ : state) front = cutlocus::grow_front(torus, {0, 0}, parameters, silent);
    state.counters["steps"] = front->steps;
    state.counters["vertices"] = static_cast<double>(front->vertices);
    state.counters["contacts"] = static_cast<double>(front->contacts.size());
}
BENCHMARK(front_by_spacing)->Arg(40)->Arg(20)->Arg(10)->Arg(5)->Arg(2)->Unit(benchmark::kMillisecond);

// Argument: -log10 of the tolerance of the integrator.
void shoot(benchmark::State& state) {
    GeodesicFlow flow(torus, {0, 0}, std::pow(10.0, -static_cast<double>(state.range(0))));
    double theta = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(flow.shoot(theta, 5));
        theta += 0.1;
    }
    state.counters["evaluations"] =
        benchmark::Counter(static_cast<double>(flow.evaluations()), benchmark::Counter::kAvgIterations);
}
BENCHMARK(shoot)->Arg(6)->Arg(9)->Arg(11)->Arg(13)->Unit(benchmark::kMicrosecond);

// Two geodesics that pass the torus's inner equator on either side of the meridian opposite to the start, from a guess
// that is wrong by one part in a hundred.
void meeting(benchmark::State& state) {
    GeodesicFlow flow(torus, {0, 0}, 1e-13);
    const double w = pi / 2 - 0.6;
    std::optional<Meeting> found;
    const auto solve = [&](double middle, double t) { found = meet(flow, w, {0, 1}, middle, t); };
    solve(pi / 2, 5.5);
    if (!found) solve(0, 5.5);
    if (!found) return state.SkipWithError("the two geodesics do not meet");
    const double middle = found->middle, t = found->t;
    for (auto _ : state) {
        solve(middle + 0.01, t * 1.01);
        benchmark::DoNotOptimize(found);
    }
    if (!found) state.SkipWithError("Newton's method does not converge");
}
BENCHMARK(meeting)->Unit(benchmark::kMicrosecond);

void query(benchmark::State& state, const Metric& metric) {
    Point2 x(0.1, 0.2);
    for (auto _ : state) {
        benchmark::DoNotOptimize(metric.local_geometry(x));
        x += Vector2(0.01, 0.02);
    }
}
void local_geometry_built_in(benchmark::State& state) { query(state, torus); }
BENCHMARK(local_geometry_built_in);
void local_geometry_expression(benchmark::State& state) {
    query(state, ExpressionEmbedding(torus_embedding, {2 * pi, 2 * pi}));
}
BENCHMARK(local_geometry_expression);

}  // namespace
