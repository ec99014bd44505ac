// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/relocation.h"

#include <algorithm>
#include <optional>

#include "tests/dsc3d/samples.h"
#include "tests/dsc3d/support.h"
#include "tests/support/seed.h"

using namespace dsc::dsc3d;
using namespace dsc::tests;
using dsc::core::Random;
using dsc::geometry::QualityMeasure;

namespace {

TetData relocation_sample(int labels, Random& random) {
    TetData data = box({4, 3, 3});
    if (labels > 1) label_slabs(data, {4, 3, 3}, labels);
    shake_inside(data, 0.3, random);
    turn(data);
    return data;
}

using Corners = std::array<std::array<double, 3>, 3>;

// The faces of boundary and interfaces by the places of their corners.
std::set<Corners> surface_faces(const Mesh& mesh) {
    std::set<Corners> triangles;
    for (const FaceId f : faces(mesh.complex())) {
        if (!mesh.complex().is_surface(f)) continue;
        Corners corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const Point3& p = mesh.position(mesh.complex().vertices(f)[i]);
            corners[i] = {p.x(), p.y(), p.z()};
        }
        std::sort(corners.begin(), corners.end());
        triangles.insert(corners);
    }
    return triangles;
}

template <class Handle>
Handle pick(const std::vector<Handle>& handles, Random& random) {
    return handles[random.below(handles.size())];
}

bool are_disjoint(RatedMesh& mesh, VertexId v, EdgeId e) {
    EdgeRing ring;
    gather_ring(mesh.complex(), e, ring);
    return std::none_of(ring.tets.begin(), ring.tets.end(), [&](TetId t) { return mesh.complex().has_vertex(t, v); });
}

// The worst of the new tetrahedra, for the best edge along which v can go by a collapse of its own, if there is one.
std::optional<double> best_collapse(RatedMesh& mesh, VertexId v) {
    EdgeCollapse collapse;
    Proposal proposal;
    std::optional<double> best;
    for (const EdgeId e : edges(mesh.complex())) {
        const auto [a, b] = mesh.complex().vertices(e);
        if (a != v && b != v) continue;
        if (!collapse.propose(mesh, e, a == v ? b : a, 0.0, proposal)) continue;
        best = std::max(best.value_or(0.0), proposal.quality_after);
    }
    return best;
}

}  // namespace

TEST_CASE("a relocation keeps every vertex, the surface and the volume of each region") {
    Random random(seed(1));
    int done = 0;
    for (int trial = 0; trial < 12; ++trial) {
        Mesh mesh(relocation_sample(1 + trial % 2, random));
        RatedMesh rated(mesh, QualityMeasure::minimum_biased_sine, {});
        const auto volumes_before = volumes(mesh);
        const auto surface_before = surface_faces(mesh);
        const auto vertices_before = vertices(mesh.complex());
        Relocation relocation;
        Proposal proposal;
        for (int round = 0; round < 400; ++round) {
            const VertexId v = pick(vertices(mesh.complex()), random);
            const EdgeId e = pick(edges(mesh.complex()), random);
            if (!relocation.propose(rated, v, e, proposal)) continue;
            const EdgeVertices ends = mesh.complex().vertices(e);
            const Point3 middle = 0.5 * (mesh.position(ends[0]) + mesh.position(ends[1]));
            CHECK(proposal.quality_before == rated.worst_quality(proposal.removed));
            const std::uint32_t before = rated.time();
            if (!rated.apply(proposal)) {
                CHECK(rated.time() == before);
                continue;
            }
            ++done;
            require_valid(mesh);
            CHECK(mesh.position(v) == middle);
            CHECK_FALSE(edge_between(mesh.complex(), ends[0], ends[1]).is_valid());
            CHECK(edge_between(mesh.complex(), ends[0], v).is_valid());
            CHECK(edge_between(mesh.complex(), ends[1], v).is_valid());
            double worst = 1;
            for (const NewTet& tet : proposal.added) worst = std::min(worst, rated.rate(tet.vertices));
            CHECK(proposal.quality_after == worst);
            REQUIRE(vertices(mesh.complex()) == vertices_before);
            REQUIRE(surface_faces(mesh) == surface_before);
            require_same(volumes_before, volumes(mesh), 1e-12);
        }
    }
    CHECK(done > 100);
}

TEST_CASE("a relocation is possible for a vertex inside that can go, and an edge inside away from it; no other") {
    Random random(seed(2));
    int possible = 0, refused = 0;
    for (const int labels : {1, 2}) {
        Mesh mesh(relocation_sample(labels, random));
        RatedMesh rated(mesh, QualityMeasure::minimum_sine, {});
        const Complex& complex = mesh.complex();
        Relocation relocation;
        Proposal proposal;
        for (const VertexId v : vertices(complex)) {
            const std::optional<double> closed = best_collapse(rated, v);
            for (const EdgeId e : edges(complex)) {
                const bool expected =
                    !complex.is_surface(v) && closed && !complex.is_surface(e) && are_disjoint(rated, v, e);
                REQUIRE(relocation.propose(rated, v, e, proposal) == expected);
                ++(expected ? possible : refused);
                // The star is closed in the best way.
                if (expected) REQUIRE(proposal.quality_after <= *closed);
            }
        }
    }
    CHECK(possible > 100);
    CHECK(refused > 100);
}

TEST_CASE("a relocation that is taken back was never done") {
    Random random(seed(3));
    Mesh mesh(relocation_sample(2, random));
    RatedMesh rated(mesh, QualityMeasure::minimum_biased_sine, {});
    const auto state = [&] {
        std::vector<std::array<double, 3>> places;
        for (const VertexId v : vertices(mesh.complex()))
            places.push_back({mesh.position(v).x(), mesh.position(v).y(), mesh.position(v).z()});
        return std::pair(labelled_tets(mesh.complex()), places);
    };
    const auto before = state();
    Relocation relocation;
    Proposal proposal;
    int done = 0;
    for (int round = 0; round < 400; ++round) {
        rated.begin();
        // One after the other, also of the same vertex.
        for (int change = 0; change < 1 + round % 3; ++change) {
            const VertexId v = pick(vertices(mesh.complex()), random);
            for (const EdgeId e : {pick(edges(mesh.complex()), random), pick(edges(mesh.complex()), random)})
                if (!mesh.complex().is_deleted(e) && relocation.propose(rated, v, e, proposal) && rated.apply(proposal))
                    ++done;
        }
        rated.roll_back();
        REQUIRE(state() == before);
    }
    require_valid(mesh);
    CHECK(done > 20);
}
