// SPDX-License-Identifier: GPL-3.0-or-later
// The plain method of the thesis against the exact cut locus: its error is below the largest speed in the chart times
// the time step (5.4.1), so that it halves with the step.
#include "tests/apps/cutlocus/program.h"
#include "tests/apps/cutlocus/support.h"

using namespace dsc;
using namespace dsc::cutlocus;
using namespace dsc::geodesic;
using namespace dsc::tests;

namespace {

struct Errors {
    double to_exact = 0, from_exact = 0, mean = 0;
};

/// Distances in the chart between where the front stopped and the exact points, both ways.
Errors errors_of(const std::vector<Point2>& stops, const std::vector<Point2>& exact) {
    const auto distance = [](const Point2& x, const std::vector<Point2>& points) {
        double nearest = 1e300;
        for (const Point2& y : points) nearest = std::min(nearest, torus_periods.wrapped(x - y).squaredNorm());
        return std::sqrt(nearest);
    };
    Errors errors;
    for (const Point2& x : stops) {
        const double miss = distance(x, exact);
        errors.to_exact = std::max(errors.to_exact, miss);
        errors.mean += miss / static_cast<double>(stops.size());
    }
    for (const Point2& x : exact) errors.from_exact = std::max(errors.from_exact, distance(x, stops));
    return errors;
}

}  // namespace

TEST_CASE("the plain method is off by less than a time step, and half of it with half the step", "[slow]") {
    const auto [lambda, v] = GENERATE(std::pair{"1", 0.0}, std::pair{"2", 0.0}, std::pair{"2", 0.15 * pi});
    INFO("lambda " << lambda << ", v " << v);
    std::vector<Point2> exact;
    for (const CutArc& arc : locus_of(TorusOfRevolution(2, std::stod(lambda)), {0, v}).graph.arcs)
        for (const CutSample& sample : arc.samples) exact.push_back(sample.x);

    const TemporaryFolder folder;
    const std::string csv = (folder / "a.csv").string();
    const auto errors_at = [&](const char* step) {
        const ProgramResult result =
            cutlocus_program({"--torus", "elliptic", "--lambda", lambda, "--point", "0," + std::to_string(v),
                              "--method", "front", "--time-step", step, "-o", csv});
        REQUIRE(result.exit_code == 0);
        std::vector<Point2> stops;
        for (const auto& row : io::read_csv(csv).rows) stops.push_back({row[0], row[1]});
        return errors_of(stops, exact);
    };
    // The speed in the chart is 1 at most: E >= 1 and G >= 1.
    const Errors coarse = errors_at("0.05"), fine = errors_at("0.025");
    CHECK(coarse.to_exact < 0.05);
    CHECK(coarse.from_exact < 0.05);
    CHECK(fine.to_exact < 0.025);
    CHECK(fine.from_exact < 0.025);
    CHECK(fine.mean < 0.65 * coarse.mean);
}
