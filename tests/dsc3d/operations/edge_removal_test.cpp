// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/edge_removal.h"

#include "dsc3d/label_statistics.h"
#include "dsc3d/operations/multi_face.h"
#include "tests/dsc3d/samples.h"
#include "tests/dsc3d/support.h"
#include "tests/support/seed.h"
#include "tests/support/triangulations.h"

using namespace dsc::dsc3d;
using namespace dsc::tests;
using dsc::core::Random;
using dsc::geometry::QualityMeasure;

namespace {

// The best of all triangulations of link[begin] .. link[end]: each triangle carries a tetrahedron at a and one at b.
double best_of_all(const RatedMesh& mesh, const EdgeRing& ring, std::size_t begin, std::size_t end) {
    double best = -infinity;
    const auto at = [&](int i) { return ring.link[(begin + static_cast<std::size_t>(i)) % ring.tets.size()]; };
    const auto in_open = [&](int i) { return ring.link[begin + static_cast<std::size_t>(i)]; };
    for (const Triangulation& triangulation : triangulations(static_cast<int>(end - begin + 1))) {
        double worst = infinity;
        for (const auto& [i, j, k] : triangulation) {
            const VertexId x = ring.is_closed ? at(i) : in_open(i), y = ring.is_closed ? at(j) : in_open(j),
                           z = ring.is_closed ? at(k) : in_open(k);
            worst = std::min({worst, mesh.rate(x, y, z, ring.b), mesh.rate(x, z, y, ring.a)});
        }
        best = std::max(best, worst);
    }
    return best;
}

// Where the surface meets the link of a surface edge, from the definition of a surface face.
std::vector<std::size_t> surface_places(const Complex& complex, const EdgeRing& ring) {
    std::vector<std::size_t> places;
    const std::size_t n = ring.tets.size();
    if (!ring.is_closed) places.push_back(0);
    for (std::size_t i = ring.is_closed ? 0 : 1; i < n; ++i)
        if (complex.label(ring.tets[i]) != complex.label(ring.tets[(i + n - 1) % n])) places.push_back(i);
    if (!ring.is_closed) places.push_back(n);
    return places;
}

// What edge removal should find, or minus infinity where it has no business.
double expected_quality(const RatedMesh& mesh, EdgeId e) {
    const Complex& complex = mesh.complex();
    EdgeRing ring;
    gather_ring(complex, e, ring);
    const std::size_t n = ring.tets.size();
    if (!complex.is_surface(e)) return best_of_all(mesh, ring, 0, n - 1);
    const std::vector<std::size_t> places = surface_places(complex, ring);
    if (places.size() != 2 || mesh.surface().is_ridge(complex, e, ring)) return -infinity;
    // An arc of two vertices would leave a face without a tetrahedron.
    const auto arc = [&](std::size_t begin, std::size_t end) {
        return end - begin < 2 ? -infinity : best_of_all(mesh, ring, begin, end);
    };
    const double first = arc(places[0], places[1]);
    return ring.is_closed ? std::min(first, arc(places[1], places[0] + n)) : first;
}

TetData shaken_box(const Cells& cells, int labels, bool is_oblique, Random& random) {
    TetData data = box(cells);
    if (labels > 1) label_slabs(data, cells, labels);
    shake_inside(data, 0.3, random);
    if (is_oblique) turn(data);
    return data;
}

}  // namespace

TEST_CASE("edge removal finds the best of all triangulations of the link") {
    Random random(seed(1));
    for (const QualityMeasure measure : {QualityMeasure::minimum_biased_sine, QualityMeasure::volume_length}) {
        for (std::uint32_t n = 3; n <= 8; ++n) {
            int possible = 0, impossible = 0;
            for (int trial = 0; trial < 40; ++trial) {
                Mesh mesh(fan(n, 1, random));
                RatedMesh rated(mesh, measure, {});
                const EdgeId e = edge_between(mesh.complex(), VertexId(0), VertexId(1));
                EdgeRing ring;
                gather_ring(mesh.complex(), e, ring);
                const double expected = best_of_all(rated, ring, 0, n - 1);
                EdgeRemoval removal;
                Proposal proposal;
                const bool is_possible = removal.propose(rated, e, proposal, 0.0);
                REQUIRE(is_possible == (expected > 0));
                ++(is_possible ? possible : impossible);
                if (!is_possible) continue;
                REQUIRE(proposal.quality_after == Approx(expected).epsilon(1e-12));
                REQUIRE(proposal.quality_before == rated.worst_quality(ring.tets));
                REQUIRE(proposal.added.size() == 2 * (n - 2));
                for (const NewTet& tet : proposal.added) REQUIRE(rated.rate(tet.vertices) >= proposal.quality_after);
                Proposal improvement;
                REQUIRE(removal.propose(rated, e, improvement) == proposal.is_improvement());

                const std::map<int, double> before = volumes(mesh);
                REQUIRE(rated.apply(proposal));
                require_valid(mesh);
                require_same(before, volumes(mesh), 1e-13);
                REQUIRE_FALSE(edge_between(mesh.complex(), VertexId(0), VertexId(1)).is_valid());
                for (const TetId t : tets(mesh.complex()))
                    REQUIRE(rated.quality(t) == rated.rate(mesh.complex().vertices(t)));
            }
            CHECK(possible > 5);
        }
    }
}

TEST_CASE("in a box, edge removal does what is best inside, on flat parts of the surface, and nothing on ridges") {
    for (const int labels : {1, 2}) {
        for (const bool is_oblique : {false, true}) {
            Random random(seed(2));
            const TetData data = shaken_box({2, 2, 2}, labels, is_oblique, random);
            int inner = 0, boundary = 0, interface = 0, refused = 0;
            const Mesh original(data);
            for (const EdgeId e : edges(original.complex())) {
                Mesh mesh(data);
                RatedMesh rated(mesh, QualityMeasure::minimum_sine, {});
                const Complex& complex = mesh.complex();
                const double expected = expected_quality(rated, e);
                EdgeRemoval removal;
                Proposal proposal;
                const bool is_possible = removal.propose(rated, e, proposal, 0.0);
                // A quality of rounding errors is none: exact positivity decides whether it is applied.
                if (expected > 1e-12) REQUIRE(is_possible);
                if (expected <= 0) REQUIRE_FALSE(is_possible);
                if (!is_possible) {
                    ++refused;
                    continue;
                }
                REQUIRE(proposal.quality_after == Approx(expected).epsilon(1e-12));
                ++(complex.is_boundary(e) ? boundary : complex.is_interface(e) ? interface : inner);
                const EdgeVertices ends = complex.vertices(e);
                const auto volumes_before = volumes(mesh);
                const auto areas_before = surface_areas(mesh);
                std::multiset<std::int32_t> patches_before, patches_after;
                for (const FaceId f : faces(complex))
                    if (complex.is_surface(f)) patches_before.insert(rated.surface().patch(f));
                if (!rated.apply(proposal)) continue;
                require_valid(mesh);
                require_same(volumes_before, volumes(mesh), 1e-13);
                require_same(areas_before, surface_areas(mesh), 1e-13);
                for (const FaceId f : faces(complex))
                    if (complex.is_surface(f)) patches_after.insert(rated.surface().patch(f));
                REQUIRE(patches_before == patches_after);
                REQUIRE_FALSE(edge_between(complex, ends[0], ends[1]).is_valid());
            }
            CHECK(inner > 5);
            CHECK(boundary > 5);
            CHECK((interface > 0) == (labels == 2));
            CHECK(refused > 20);
        }
    }
}

TEST_CASE("multi-face removal undoes edge removal, and edge removal does again what was undone") {
    Random random(seed(3));
    int done = 0;
    for (int trial = 0; trial < 400; ++trial) {
        Mesh mesh(fan(3 + static_cast<std::uint32_t>(trial % 5), 0.7, random));
        RatedMesh rated(mesh, QualityMeasure::minimum_biased_sine, {});
        const LabelledTets with_edge = labelled_tets(mesh.complex());
        EdgeRemoval removal;
        Proposal proposal;
        if (!removal.propose(rated, edge_between(mesh.complex(), VertexId(0), VertexId(1)), proposal, 0.0)) continue;
        if (!rated.apply(proposal)) continue;
        const LabelledTets without_edge = labelled_tets(mesh.complex());
        const double quality = proposal.quality_after;
        REQUIRE(without_edge != with_edge);

        MultiFace multi_face;
        const std::vector<FaceId> all = faces(mesh.complex());
        multi_face.gather(rated, *std::find_if(all.begin(), all.end(), [&](FaceId f) {
                              const FaceVertices v = mesh.complex().vertices(f);
                              return std::all_of(v.begin(), v.end(), [](VertexId u) { return u > VertexId(1); });
                          }));
        if (!multi_face.propose_removal(rated, proposal, 0.0)) continue;
        // A part of the faces may do better than all of them, which would be another operation.
        if (proposal.removed.size() != mesh.complex().tet_count() || !rated.apply(proposal)) continue;
        ++done;
        require_valid(mesh);
        REQUIRE(labelled_tets(mesh.complex()) == with_edge);
        REQUIRE(removal.propose(rated, edge_between(mesh.complex(), VertexId(0), VertexId(1)), proposal, 0.0));
        REQUIRE(proposal.quality_after == Approx(quality).epsilon(1e-12));
        REQUIRE(rated.apply(proposal));
        // Triangulations of five and more vertices can share their worst triangle.
        if (mesh.complex().tet_count() <= 4) REQUIRE(labelled_tets(mesh.complex()) == without_edge);
    }
    CHECK(done > 50);
}

TEST_CASE("rings that are too long are left alone") {
    Mesh mesh(fan(EdgeRemoval::max_ring + 1));
    RatedMesh rated(mesh, QualityMeasure::minimum_sine, {});
    EdgeRemoval removal;
    Proposal proposal;
    const EdgeId e = edge_between(mesh.complex(), VertexId(0), VertexId(1));
    CHECK_FALSE(removal.propose(rated, e, proposal, 0.0));
    Mesh longest(fan(EdgeRemoval::max_ring));
    RatedMesh rated_longest(longest, QualityMeasure::minimum_sine, {});
    CHECK(removal.propose(rated_longest, edge_between(longest.complex(), VertexId(0), VertexId(1)), proposal, 0.0));
}

TEST_CASE("a flip of a bent interface moves it over the tetrahedron of its two triangles, and keeps the topology") {
    Random random(seed(8));
    TetData data = box({5, 5, 5});
    for (const auto& tet : data.tets) {
        Point3 p = Point3::Zero();
        for (const std::uint32_t v : tet) p += data.vertices[v] / 4;
        data.labels.push_back((p - Point3(2.5, 2.5, 2.5)).norm() < 1.7 ? 1 : 0);
    }
    shake_inside(data, 0.15, random);
    Mesh mesh(data);
    const Complex& complex = mesh.complex();
    RatedMesh rated(mesh, QualityMeasure::minimum_sine, FlatSurface::flat_boundary(mesh));
    EdgeRemoval removal;
    Proposal proposal;
    // Of the two triangles at an interface edge, the vertices opposite to it.
    const auto opposite = [&](EdgeId e) {
        std::vector<VertexId> found;
        for (const FaceId f : faces(complex)) {
            const auto& sides = complex.edges(f);
            if (!complex.is_interface(f) || std::find(sides.begin(), sides.end(), e) == sides.end()) continue;
            for (const VertexId v : complex.vertices(f))
                if (v != complex.vertices(e)[0] && v != complex.vertices(e)[1]) found.push_back(v);
        }
        return found;
    };
    const auto genus_of_ball = [&] { return label_statistics(mesh)[1]; };
    const LabelStatistics before = genus_of_ball();
    int done = 0, bent = 0;
    for (int attempt = 0; attempt < 300; ++attempt) {
        std::vector<EdgeId> candidates;
        for (const EdgeId e : edges(complex))
            if (complex.is_interface(e)) candidates.push_back(e);
        const EdgeId e = candidates[random.below(candidates.size())];
        const auto [a, b] = complex.vertices(e);
        const std::vector<VertexId> ends = opposite(e);
        const double wanted = 0.05;
        if (!removal.propose_flip(rated, e, proposal, wanted)) continue;
        REQUIRE(ends.size() == 2);
        REQUIRE_FALSE(edge_between(complex, ends[0], ends[1]).is_valid());
        const double volume_before = volumes(mesh).at(1), sum = volume_before + volumes(mesh).at(0);
        const double between = std::abs(volume(mesh, {a, b, ends[0], ends[1]}));
        if (!rated.apply(proposal)) continue;
        ++done;
        bent += between > 1e-3 ? 1 : 0;
        require_valid(mesh);
        for (const TetId t : tets(complex))
            if (complex.has_vertex(t, ends[0]) && complex.has_vertex(t, ends[1])) REQUIRE(rated.quality(t) > wanted);
        const EdgeId gone = edge_between(complex, a, b);
        REQUIRE_FALSE(gone.is_valid());
        const EdgeId made = edge_between(complex, ends[0], ends[1]);
        REQUIRE((made.is_valid() && complex.is_interface(made) && complex.surface_degree(made) == 2));
        REQUIRE(std::abs(volumes(mesh).at(1) - volume_before) == Approx(between).margin(1e-12));
        REQUIRE(volumes(mesh).at(0) + volumes(mesh).at(1) == Approx(sum).epsilon(1e-12));
        const LabelStatistics after = genus_of_ball();
        REQUIRE(after.components == before.components);
        REQUIRE(after.surfaces == before.surfaces);
        REQUIRE(after.genus == before.genus);
    }
    CHECK(done > 10);
    CHECK(bent > 2);
}

TEST_CASE("edges on the boundary, off the interface and at seams are not flipped") {
    TetData data = box({4, 3, 3});
    label_slabs(data, {4, 3, 3}, 2);
    for (std::size_t i = 0; i < data.tets.size(); ++i) {
        double z = 0;
        for (const std::uint32_t v : data.tets[i]) z += data.vertices[v].z() / 4;
        if (data.labels[i] == 1 && z > 1) data.labels[i] = 2;
    }
    Mesh mesh(data);
    RatedMesh rated(mesh, QualityMeasure::minimum_sine, FlatSurface::flat_boundary(mesh));
    EdgeRemoval removal;
    Proposal proposal;
    int possible = 0;
    for (const EdgeId e : edges(mesh.complex())) {
        const bool is_flipped = removal.propose_flip(rated, e, proposal, 0.0);
        if (mesh.complex().is_boundary(e) || mesh.complex().surface_degree(e) != 2) CHECK_FALSE(is_flipped);
        possible += is_flipped ? 1 : 0;
    }
    CHECK(possible > 0);
}
