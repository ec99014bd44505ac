// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate holds on surfaces without symmetry, and every sample is hit by both of its geodesics when they are
// integrated anew by an integrator of another make.
#include <memory>
#include <sstream>

#include "tests/apps/cutlocus/independent_geodesic.h"
#include "tests/apps/cutlocus/support.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::cutlocus;
using namespace dsc::geodesic;
using namespace dsc::tests;

namespace {

/// Largest miss, in the chart, of both geodesics to every `stride`th sample.
double largest_miss(const Metric& metric, const Point2& p, const CutGraph& graph, std::size_t stride) {
    IndependentGeodesic geodesic(metric, p);
    double largest = 0;
    for (const CutArc& arc : graph.arcs)
        for (std::size_t i = 0; i < arc.samples.size(); i += stride) {
            const CutSample& sample = arc.samples[i];
            for (const double theta : {sample.theta1, sample.theta2})
                largest = std::max(largest, chart_distance(metric, geodesic.end(theta, sample.distance), sample.x));
        }
    return largest;
}

void check_locus(const Metric& metric, const Point2& p, std::size_t stride = 10) {
    INFO("p = " << p.transpose());
    const CutLocus locus = locus_of(metric, p);
    check_certificate(locus);
    CHECK(largest_miss(metric, p, locus.graph, stride) <= 1e-9);
}

/// A sum of `terms` cosines of random wave vectors and phases, with amplitudes up to `amplitude`.
std::string random_series(core::Random& random, int terms, double amplitude) {
    std::ostringstream text;
    text.precision(17);
    text << '0';
    for (int i = 0; i < terms; ++i)
        text << "+(" << random.uniform(-amplitude, amplitude) << ")*cos(" << random.below(3) << "*u+"
             << static_cast<int>(random.below(3)) - 1 << "*v+" << random.uniform(0, 2 * pi) << ')';
    return text.str();
}

/// Positive definite: E >= 0.6 exp(f), G >= 1.1 exp(f), |F| <= 0.4 and f >= -0.4.
std::string random_metric(core::Random& random) {
    const std::string factor = "exp(" + random_series(random, 2, 0.2) + ")";
    return "E=" + factor + "*(1+" + random_series(random, 2, 0.2) + ");F=0.2+" + random_series(random, 2, 0.1) +
           ";G=" + factor + "*(1.5+" + random_series(random, 2, 0.2) + ")";
}

}  // namespace

TEST_CASE("every sample of lambda 2 is hit by both geodesics", "[slow]") {
    check_locus(TorusOfRevolution(2, 2), {0, 0.15 * pi}, 1);
}

TEST_CASE("the certificate holds on a flat and on a high section", "[slow]") {
    const double lambda = GENERATE(0.5, 3.0);
    INFO("lambda = " << lambda);
    check_locus(TorusOfRevolution(2, lambda), {0, 0});
    check_locus(TorusOfRevolution(2, lambda), {0, 0.7});
}

TEST_CASE("the certificate holds on a conformal metric", "[slow]") {
    const ExpressionMetric metric(conformal_metric, torus_periods);
    check_locus(metric, {0, 0});
    check_locus(metric, {0.8, -0.3});
}

TEST_CASE("the certificate holds on a bumpy torus", "[slow]") {
    check_locus(ExpressionEmbedding(bumpy_torus, torus_periods), {0.3, 0.7});
}

TEST_CASE("the certificate holds on random trigonometric metrics", "[slow]") {
    const int round = GENERATE(range(0, 12));
    core::Random random(seed(101) + static_cast<std::uint64_t>(round));
    const std::string text = random_metric(random);
    INFO("round " << round << ": " << text);
    const ExpressionMetric metric(text, torus_periods);
    check_locus(metric, {random.uniform(-pi, pi), random.uniform(-pi, pi)});
}

TEST_CASE("the certificate holds where the integrator's errors jump next to an end", "[slow]") {
    check_locus(ExpressionMetric(jumping_end_metric, torus_periods), jumping_end_point);
}

TEST_CASE("an end on an arc too short for the front is found and told from the announced ones", "[slow]") {
    const ExpressionMetric metric(hidden_end_metric, torus_periods);
    CutLocusParameters parameters;
    parameters.front_spacing = 0.04;  // about six times the length of the end
    const CutLocus locus = locus_of(metric, hidden_end_point, parameters);
    check_certificate(locus);
    std::vector<CutArc> unannounced;
    for (const CutArc& arc : locus.graph.arcs)
        if (!arc.is_announced) unannounced.push_back(arc);
    REQUIRE(unannounced.size() == 1);
    CHECK(std::abs(unannounced[0].length - 0.069146) < 1e-6);
    CHECK(largest_miss(metric, hidden_end_point, locus.graph, 10) <= 1e-9);
}
