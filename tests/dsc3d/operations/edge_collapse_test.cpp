// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/edge_collapse.h"

#include "dsc3d/label_statistics.h"
#include "dsc3d/operations/split.h"
#include "tests/dsc3d/random_topology.h"
#include "tests/dsc3d/samples.h"
#include "tests/dsc3d/simplices.h"
#include "tests/dsc3d/support.h"
#include "tests/support/seed.h"

using namespace dsc::dsc3d;
using namespace dsc::tests;
using dsc::core::Random;
using dsc::geometry::QualityMeasure;

namespace {

constexpr std::uint32_t cone = 0xffffffff;

Simplices coned(const Simplices& complex, const Simplices& base) {
    Simplices all = complex;
    all.insert({cone});
    for (Simplex s : base) {
        s.insert(cone);
        all.insert(s);
    }
    return all;
}

bool satisfies_link_condition(const Simplices& complex, const Simplex& edge) {
    const Simplex a = {*edge.begin()}, b = {*edge.rbegin()};
    return link(complex, edge) == intersection(link(complex, a), link(complex, b));
}

bool is_connected(const Simplices& graph) {
    Simplices open = filter(graph, 0);
    std::vector<Simplex> front = {*open.begin()};
    open.erase(open.begin());
    while (!front.empty()) {
        const Simplex at = front.back();
        front.pop_back();
        for (const Simplex& line : filter(star(graph, at), 1))
            for (const Simplex& next : filter(closure(line), 0))
                if (open.erase(next) != 0) front.push_back(next);
    }
    return open.empty();
}

// A vertex of the surface is inside a sheet when its link is a circle; inside a seam when its link without two vertices
// falls apart into paths, each of which joins the two. Otherwise it is a corner.
enum class Place { sheet, seam, corner };
Place place_in(const Simplices& surface, const Simplex& v) {
    const Simplices around = link(surface, v);
    Simplices ends;
    for (const Simplex& x : filter(around, 0))
        if (filter(star(around, x), 1).size() != 2) ends.insert(x);
    if (!is_connected(around)) return Place::corner;
    if (ends.empty()) return Place::sheet;
    if (ends.size() != 2) return Place::corner;
    // Connected, and with every sheet there joining both ends: their degrees agree, and no arc returns.
    const std::size_t sheets = filter(star(around, *ends.begin()), 1).size();
    if (filter(star(around, *ends.rbegin()), 1).size() != sheets) return Place::corner;
    // Euler's number of k arcs between two points is 2 - k; a loop at either end would need another arc less.
    Simplices without = around;
    for (const Simplex& end : ends)
        for (const Simplex& s : star(around, end)) without.erase(s);
    std::size_t arcs = filter(intersection(around, {{*ends.begin()->begin(), *ends.rbegin()->begin()}}), 1).size();
    while (!without.empty()) {
        // One arc: the part connected to any of its vertices.
        Simplices arc, front = {*filter(without, 0).begin()};
        while (!front.empty()) {
            const Simplex s = *front.begin();
            front.erase(front.begin());
            if (!arc.insert(s).second) continue;
            for (const Simplex& t : without)
                if (is_face(s, t) || is_face(t, s)) front.insert(t);
        }
        for (const Simplex& s : arc) without.erase(s);
        Simplices touched;
        for (const Simplex& line : filter(around, 1))
            for (const Simplex& x : filter(closure(line), 0))
                if (arc.count(x) != 0) touched.merge(filter(closure(line), 0));
        if (intersection(touched, ends) != ends) return Place::corner;
        ++arcs;
    }
    return arcs == sheets ? Place::seam : Place::corner;
}

// The link condition in the complex coned off at its surface, in the surface coned off at its seams, and in the seams:
// no two corners are joined.
struct LinkCondition {
    Simplices solid, surface, seams, corners;

    explicit LinkCondition(const Complex& complex) {
        surface = surface_of(complex);
        solid = coned(simplices_of(complex), surface);
        for (const Simplex& e : filter(surface, 1))
            if (filter(star(surface, e), 2).size() != 2) seams.merge(closure(e));
        for (const Simplex& v : filter(surface, 0)) {
            const Place place = place_in(surface, v);
            if (place != Place::sheet) seams.insert(v);
            if (place == Place::corner) corners.insert(v);
        }
    }
    bool holds(const Simplex& edge) const {
        if (!satisfies_link_condition(solid, edge)) return false;
        if (surface.count(edge) == 0) return true;
        if (!satisfies_link_condition(coned(surface, seams), edge)) return false;
        return seams.count(edge) == 0 || corners.count({*edge.begin()}) == 0 || corners.count({*edge.rbegin()}) == 0;
    }
};

std::map<int, int> euler_by_label(const Complex& complex) {
    std::map<int, Simplices> regions;
    for (const TetId t : tets(complex)) regions[complex.label(t)].insert(simplex(complex.vertices(t)));
    std::map<int, int> number;
    for (const auto& [label, region] : regions) number[label] = euler_characteristic(closure(region));
    return number;
}

}  // namespace

TEST_CASE("a collapse keeps topology exactly when the link condition holds in the solid and in its surface") {
    for (const int labels : {1, 2, 4}) {
        Random random(seed(1));
        Mesh mesh(box({2, 1, 1}));
        Complex& complex = mesh.complex();
        StarWalker walker(complex);
        EdgeCollapse collapse;
        RandomTopology topology(complex, random, 40, labels);
        int possible = 0, refused = 0;
        for (int round = 0; round < 15; ++round) {
            topology.run(3);
            const LinkCondition condition(complex);
            for (const EdgeId e : edges(complex)) {
                const bool expected = condition.holds(simplex(complex.vertices(e)));
                for (const VertexId kept : complex.vertices(e)) {
                    INFO("round " << round << ", labels " << labels << ", edge " << complex.vertices(e)[0].index()
                                  << " " << complex.vertices(e)[1].index());
                    REQUIRE(collapse.keeps_topology(complex, e, kept, walker) == expected);
                }
                ++(expected ? possible : refused);
            }
        }
        CHECK(possible > 100);
        CHECK(refused > 100);
    }
}

TEST_CASE("collapses that keep topology leave a manifold complex whose regions have the same Euler numbers") {
    for (const int labels : {1, 3}) {
        Random random(seed(2));
        Mesh mesh(box({2, 2, 1}));
        Complex& complex = mesh.complex();
        StarWalker walker(complex);
        EdgeCollapse edge_collapse;
        RandomTopology topology(complex, random, 60, labels);
        int done = 0;
        for (int round = 0; round < 1000; ++round) {
            topology.run_one();
            const EdgeId e = topology.pick_edge();
            const VertexId kept = complex.vertices(e)[random.below(2)];
            if (!edge_collapse.keeps_topology(complex, e, kept, walker)) continue;
            ++done;
            const std::map<int, int> before = euler_by_label(complex);
            collapse(complex, e, kept, walker);
            INFO("round " << round << ", labels " << labels);
            require_valid(complex);
            REQUIRE(euler_by_label(complex) == before);
        }
        CHECK(done > 30);
    }
}

TEST_CASE("a collapse to a place of the interface keeps the topology of all regions, or changes nothing") {
    Random random(seed(7));
    int done = 0, refused = 0;
    for (int trial = 0; trial < 4; ++trial) {
        TetData data = box({5, 5, 5});
        for (const auto& tet : data.tets) {
            Point3 p = Point3::Zero();
            for (const std::uint32_t v : tet) p += data.vertices[v] / 4;
            const bool is_in = (p - Point3(2.5, 2.5, 2.5)).norm() < 1.6;
            data.labels.push_back(is_in ? (trial % 2 == 1 && p.x() > 2.5 ? 2 : 1) : 0);
        }
        shake_inside(data, 0.1, random);
        Mesh mesh(data);
        const Complex& complex = mesh.complex();
        RatedMesh rated(mesh, QualityMeasure::minimum_sine, FlatSurface::flat_boundary(mesh));
        EdgeCollapse collapse;
        for (int attempt = 0; attempt < 60; ++attempt) {
            std::vector<EdgeId> candidates;
            for (const EdgeId e : edges(complex)) {
                const auto [a, b] = complex.vertices(e);
                if (complex.is_interface(e) && !complex.is_boundary(a) && !complex.is_boundary(b))
                    candidates.push_back(e);
            }
            if (candidates.empty()) break;
            const EdgeId e = candidates[random.below(candidates.size())];
            const auto ends = complex.vertices(e);
            const std::size_t which = random.below(2);
            const VertexId kept = ends[which], gone = ends[1 - which];
            const double share = std::array{0.0, 0.5, 1.0}[random.below(3)];
            const Point3 place = (1 - share) * mesh.position(kept) + share * mesh.position(gone);
            const double enough = attempt % 2 == 0 ? 0.05 : 0.2;
            const auto tets_before = labelled_tets(complex);
            const Point3 kept_before = mesh.position(kept), gone_before = mesh.position(gone);
            const auto volume = volumes(mesh);
            const auto before = label_statistics(mesh);
            double worst = 1;
            for (const TetId t : tets(complex))
                if (complex.has_vertex(t, kept) || complex.has_vertex(t, gone))
                    worst = std::min(worst, rated.quality(t));

            if (!collapse.collapse_at(rated, e, kept, place, enough)) {
                ++refused;
                REQUIRE(labelled_tets(complex) == tets_before);
                REQUIRE(mesh.position(kept) == kept_before);
                REQUIRE(mesh.position(gone) == gone_before);
                continue;
            }
            ++done;
            require_valid(mesh);
            REQUIRE(complex.is_deleted(gone));
            REQUIRE(mesh.position(kept) == place);
            for (const TetId t : tets(complex)) {
                REQUIRE(rated.quality(t) == rated.rate(complex.vertices(t)));
                if (complex.has_vertex(t, kept)) REQUIRE(rated.quality(t) >= std::min(worst, enough));
            }
            double sum_before = 0, sum_after = 0;
            for (const auto& [label, value] : volume) sum_before += value;
            for (const auto& [label, value] : volumes(mesh)) sum_after += value;
            REQUIRE(sum_after == Approx(sum_before).epsilon(1e-12));
            const auto after = label_statistics(mesh);
            REQUIRE(after.size() == before.size());
            for (std::size_t i = 0; i < before.size(); ++i) {
                REQUIRE(after[i].components == before[i].components);
                REQUIRE(after[i].surfaces == before[i].surfaces);
                REQUIRE(after[i].genus == before[i].genus);
            }
        }
    }
    CHECK(done > 40);
    CHECK(refused > 40);
}
