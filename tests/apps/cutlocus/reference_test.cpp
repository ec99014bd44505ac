// SPDX-License-Identifier: GPL-3.0-or-later
// The six cases of the thesis against cut loci from an independent program, in the shared data.
#include <map>
#include <string>

#include "geodesic/torus.h"
#include "io/atomic_file.h"
#include "io/csv.h"
#include "io/json.h"
#include "tests/apps/cutlocus/support.h"
#include "tests/support/shared_data.h"

using namespace dsc;
using namespace dsc::cutlocus;
using namespace dsc::geodesic;
using namespace dsc::tests;

namespace {

using Polyline = std::vector<Point2>;

/// Shift of the chart by whole periods that brings `x` next to `to`.
Point2 brought_near(const Point2& x, const Point2& to) { return to + torus_periods.wrapped(x - to); }

Polyline unwrapped(const Polyline& points) {
    Polyline line{points.front()};
    for (std::size_t i = 1; i < points.size(); ++i) line.push_back(brought_near(points[i], line.back()));
    return line;
}

/// The point at parameter s (the index of a sample, or between two) of the cubic through the four nearest samples.
Point2 on_cubic(const Polyline& line, double s) {
    const auto last = static_cast<double>(line.size() - 1);
    const int count = static_cast<int>(std::min<std::size_t>(4, line.size()));
    const int first = static_cast<int>(std::clamp(std::floor(s) - 1, 0.0, last - count + 1));
    Point2 x(0, 0);
    for (int i = first; i < first + count; ++i) {
        double weight = 1;
        for (int k = first; k < first + count; ++k)
            if (k != i) weight *= (s - k) / (i - k);
        x += weight * line[static_cast<std::size_t>(i)];
    }
    return x;
}

/// Distance in the chart from `x` to the curve through the points of `line`.
double distance_to_curve(const Polyline& line, const Point2& x) {
    std::size_t nearest = 0;
    double nearest_gap = 1e300;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const double gap = torus_periods.wrapped(x - line[i]).squaredNorm();
        if (gap < nearest_gap) nearest = i, nearest_gap = gap;
    }
    if (nearest_gap > 1e-3) return std::sqrt(nearest_gap);  // another arc is nearer
    const Point2 target = brought_near(x, line[nearest]);
    const auto gap = [&](double s) { return (on_cubic(line, s) - target).norm(); };
    const auto middle = static_cast<double>(nearest);
    double low = std::max(0.0, middle - 1), high = std::min(static_cast<double>(line.size() - 1), middle + 1);
    while (high - low > 1e-9) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        (gap(a) < gap(b) ? high : low) = gap(a) < gap(b) ? b : a;
    }
    return gap((low + high) / 2);
}

double directed_hausdorff(const std::vector<Polyline>& from, const std::vector<Polyline>& to) {
    double largest = 0;
    for (const Polyline& line : from)
        for (const Point2& x : line) {
            double nearest = 1e300;
            for (const Polyline& other : to) nearest = std::min(nearest, distance_to_curve(other, x));
            largest = std::max(largest, nearest);
        }
    return largest;
}

std::vector<Polyline> lines_of(const io::CsvTable& table) {
    std::map<int, Polyline> arcs;
    for (const auto& row : table.rows) arcs[static_cast<int>(row[5])].push_back({row[0], row[1]});
    std::vector<Polyline> lines;
    for (const auto& [id, points] : arcs) lines.push_back(unwrapped(points));
    return lines;
}

std::vector<Polyline> lines_of(const CutGraph& graph) {
    std::vector<Polyline> lines;
    for (const CutArc& arc : graph.arcs) {
        Polyline points;
        for (const CutSample& sample : arc.samples) points.push_back(sample.x);
        lines.push_back(unwrapped(points));
    }
    return lines;
}

/// For each vertex of the reference the vertex of `graph` in its place.
std::vector<int> check_vertices(const CutGraph& graph, const io::Json& reference) {
    std::vector<int> partners;
    REQUIRE(graph.vertices.size() == reference["vertices"].size());
    for (const io::Json& expected : reference["vertices"].elements()) {
        const Point2 place(expected["u"].number(), expected["v"].number());
        INFO("vertex at " << place.transpose());
        int partner = -1, found = 0;
        for (std::size_t i = 0; i < graph.vertices.size(); ++i)
            if (torus_periods.wrapped(graph.vertices[i].x - place).cwiseAbs().maxCoeff() < 1e-8)
                partner = static_cast<int>(i), ++found;
        REQUIRE(found == 1);
        partners.push_back(partner);
        const CutVertex& vertex = graph.vertices[static_cast<std::size_t>(partner)];
        CHECK(vertex.degree == expected["degree"].integer());
        CHECK((vertex.kind == VertexKind::end) == (expected["kind"].string() == "end"));
        CHECK(std::abs(vertex.distance - expected["distance"].number()) < 1e-8);
        REQUIRE(vertex.thetas.size() == expected["thetas"].size());
        for (const io::Json& theta : expected["thetas"].elements()) {
            double nearest = pi;
            for (const double mine : vertex.thetas) nearest = std::min(nearest, angle_between(mine, theta.number()));
            CHECK(nearest < 1e-7);
        }
    }
    return partners;
}

/// Each arc of the reference is an arc of `graph` between the same vertices, as long, with the same lattice vector, up
/// to its orientation.
void check_arcs(const CutGraph& graph, const io::Json& reference, const std::vector<int>& partners) {
    REQUIRE(graph.arcs.size() == reference["arcs"].size());
    std::vector<bool> is_taken(graph.arcs.size(), false);
    for (const io::Json& expected : reference["arcs"].elements()) {
        const int start = partners[static_cast<std::size_t>(expected["start"].integer())];
        const int end = partners[static_cast<std::size_t>(expected["end"].integer())];
        const LatticeVector lattice(static_cast<int>(expected["lattice"][0].integer()),
                                    static_cast<int>(expected["lattice"][1].integer()));
        INFO("arc from " << start << " to " << end << ", lattice " << lattice.transpose());
        bool is_found = false;
        for (std::size_t i = 0; i < graph.arcs.size() && !is_found; ++i) {
            const CutArc& arc = graph.arcs[i];
            const bool same_ends =
                (arc.start == start && arc.end == end) || (arc.start == end && arc.end == start);
            const bool same_lattice = arc.lattice == lattice || arc.lattice == -lattice;
            if (is_taken[i] || !same_ends || !same_lattice) continue;
            if (std::abs(arc.length - expected["length"].number()) > 1e-7) continue;
            is_taken[i] = is_found = true;
        }
        CHECK(is_found);
    }
}

struct Case {
    const char* name;
    double lambda;
    double v;
};

}  // namespace

TEST_CASE("the thesis cases agree with the references", "[shared][slow]") {
    DSC_NEEDS_SHARED_DATA("cutlocus");
    const Case thesis_case =
        GENERATE(Case{"circ_p0000", 1, 0}, Case{"circ_p0020", 1, 0.2 * pi}, Case{"circ_p0050", 1, 0.5 * pi},
                 Case{"circ_p0090", 1, 0.9 * pi}, Case{"ell2_p0000", 2, 0}, Case{"ell2_p0015", 2, 0.15 * pi});
    const std::string stem = std::string("cutlocus/") + thesis_case.name;
    INFO(thesis_case.name);
    const io::Json reference = io::Json::parse(io::read_file(shared_data(stem + ".json")));
    const TorusOfRevolution torus(2, thesis_case.lambda);
    const CutLocus locus = locus_of(torus, {0, thesis_case.v});
    check_certificate(locus);
    check_arcs(locus.graph, reference, check_vertices(locus.graph, reference));
    CHECK(std::abs(locus.graph.length - reference["length"].number()) < 1e-7);
    CHECK(std::abs(locus.graph.nearest.distance - reference["min_distance"].number()) < 1e-8);
    CHECK(std::abs(locus.graph.farthest.distance - reference["max_distance"].number()) < 1e-8);

    const auto mine = lines_of(locus.graph), expected = lines_of(io::read_csv(shared_data(stem + ".csv")));
    CHECK(directed_hausdorff(mine, expected) <= 1e-7);
    CHECK(directed_hausdorff(expected, mine) <= 1e-7);
}
