// SPDX-License-Identifier: GPL-3.0-or-later
// A cut locus that was spoilt does not keep its certificate.
#include "apps/cutlocus/certificate.h"

#include "tests/apps/cutlocus/support.h"

using namespace dsc;
using namespace dsc::cutlocus;
using namespace dsc::geodesic;
using namespace dsc::tests;

namespace {

class Spoiler {
public:
    Spoiler() : metric_("E=1;F=0.3;G=1.4", torus_periods), locus_(locus_of(metric_, {0.2, 0.1}, {.spacing = 0.1})) {}

    /// True if the certificate of the graph, changed by `spoil`, fails.
    template <class Spoil>
    bool is_caught(const Spoil& spoil) const {
        CutGraph graph = locus_.graph;
        spoil(graph);
        certify(metric_, graph);
        return !graph.certificate.holds();
    }

private:
    ExpressionMetric metric_;
    CutLocus locus_;
};

}  // namespace

TEST_CASE("the certificate fails for a graph that was spoilt", "[slow]") {
    const Spoiler spoiler;
    CHECK_FALSE(spoiler.is_caught([](CutGraph&) {}));
    CHECK(spoiler.is_caught([](CutGraph& graph) { graph.arcs.pop_back(); }));
    CHECK(spoiler.is_caught([](CutGraph& graph) { graph.arcs.push_back(graph.arcs.front()); }));
    CHECK(spoiler.is_caught([](CutGraph& graph) { graph.vertices.emplace_back(); }));
    CHECK(spoiler.is_caught([](CutGraph& graph) { graph.arcs[0].samples.pop_back(); }));
    CHECK(spoiler.is_caught([](CutGraph& graph) { graph.arcs[1].samples.front().theta1 += 1e-8; }));
    CHECK(spoiler.is_caught([](CutGraph& graph) { graph.arcs[1].samples.back().theta2 -= 1e-8; }));
    CHECK(spoiler.is_caught([](CutGraph& graph) { graph.certificate.sector_area *= 1 + 2e-8; }));
    CHECK(spoiler.is_caught([](CutGraph& graph) { graph.certificate.sector_area = std::nan(""); }));
    CHECK(spoiler.is_caught([](CutGraph& graph) { graph.doubts.push_back({1.0, "somewhere"}); }));
}

TEST_CASE("the certificate fails for an arc that ends in the wrong vertex", "[slow]") {
    const Spoiler spoiler;
    CHECK(spoiler.is_caught([](CutGraph& graph) { graph.arcs[0].end = graph.arcs[0].start; }));
    CHECK(spoiler.is_caught([](CutGraph& graph) { std::swap(graph.arcs[0].start, graph.arcs[0].end); }));
}

TEST_CASE("the certificate fails for a vertex that was moved", "[slow]") {
    const Spoiler spoiler;
    CHECK(spoiler.is_caught([](CutGraph& graph) { graph.vertices[0].x.x() += 1e-3; }));
    CHECK(spoiler.is_caught([](CutGraph& graph) { graph.vertices[0].thetas[0] += 1e-3; }));
}
