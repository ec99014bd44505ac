// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>

#include "tests/apps/cutlocus/support.h"

using namespace dsc;
using namespace dsc::cutlocus;
using namespace dsc::geodesic;
using namespace dsc::tests;

namespace {

/// All numbers of a graph as bits.
std::vector<std::uint64_t> bits_of(const CutGraph& graph) {
    std::vector<std::uint64_t> bits;
    const auto add = [&](double value) { bits.push_back(std::bit_cast<std::uint64_t>(value)); };
    for (const CutVertex& vertex : graph.vertices) {
        for (const double value : {vertex.x.x(), vertex.x.y(), vertex.distance, vertex.residual}) add(value);
        for (const double theta : vertex.thetas) add(theta);
    }
    for (const CutArc& arc : graph.arcs) {
        for (const int value : {arc.start, arc.end, arc.lattice.x(), arc.lattice.y()}) add(value);
        add(arc.length);
        for (const CutSample& sample : arc.samples)
            for (const double value :
                 {sample.x.x(), sample.x.y(), sample.distance, sample.theta1, sample.theta2})
                add(value);
    }
    add(graph.certificate.sector_area);
    add(graph.certificate.residual);
    return bits;
}

void check_same_bits(const Metric& metric, const Point2& p) {
    CutLocusParameters parameters;
    parameters.threads = 1;
    const auto first = bits_of(locus_of(metric, p, parameters).graph);
    const auto again = bits_of(locus_of(metric, p, parameters).graph);
    parameters.threads = 2;
    const auto in_parallel = bits_of(locus_of(metric, p, parameters).graph);
    CHECK(first.size() > 1000);
    CHECK(first == again);
    CHECK(first == in_parallel);
}

}  // namespace

TEST_CASE("two runs, and 1 and 2 threads, give the same bits", "[slow]") {
    check_same_bits(TorusOfRevolution(2, 2), {0, 0.15 * pi});
    check_same_bits(ExpressionMetric(conformal_metric, torus_periods), {0.8, -0.3});
}
