// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/upkeep.h"

#include "tests/dsc3d/deform/support.h"
#include "tests/dsc3d/volumes.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;

namespace {

/// A ball in a box, everything else shaken.
Mesh shaken(std::uint64_t number) {
    core::Random random(number);
    TetData data = box_with(distance_from_sphere({0.5, 0.5, 0.5}, 0.25), 0.14).data();
    shake_inside(data, 0.08, random);
    return Mesh(data);
}

std::size_t poor_tets(const PassBench& bench) {
    const std::vector<TetId> all = tets(bench.rated.complex());
    return static_cast<std::size_t>(std::count_if(
        all.begin(), all.end(), [&](TetId t) { return bench.rated.quality(t) < bench.parameters.poor_quality; }));
}

}  // namespace

TEST_CASE("upkeep never makes the worst tetrahedron worse, leaves few poor ones, and the surface where it is") {
    const std::uint64_t first_seed = seed(1);
    for (std::uint64_t trial = 0; trial < 3; ++trial) {
        Mesh mesh = shaken(first_seed + trial);
        PassBench bench(mesh, {.edge_length = 0.14});
        Upkeep upkeep(bench.rated, 1);
        const auto triangles = interface_triangles(mesh.complex());
        std::map<VertexId, Point3> fixed;
        for (const auto& [v, place] : places(mesh))
            if (mesh.complex().is_interface(v)) fixed[v] = place;
        const auto volume_before = volumes(mesh);
        const auto areas = surface_areas(mesh);
        const std::size_t poor = poor_tets(bench);
        const double worst = worst_quality(bench);
        REQUIRE(poor > 50);

        PassContext context = bench.context();
        upkeep.run(context);
        require_valid(mesh);
        const double after_run = worst_quality(bench);
        CHECK(after_run >= worst);
        CHECK(poor_tets(bench) < poor / 5);
        bench.take_all();
        PassContext again = bench.context();
        upkeep.rescue(again);
        require_valid(mesh);
        CHECK(worst_quality(bench) >= after_run);

        CHECK(interface_triangles(mesh.complex()) == triangles);
        for (const auto& [v, place] : fixed) REQUIRE(mesh.position(v) == place);
        require_same(volume_before, volumes(mesh), 1e-12);
        require_same(areas, surface_areas(mesh), 1e-12);
        CHECK(bench.report.counts.smoothings > 0);
    }
}

TEST_CASE("good tetrahedra are left alone, and so is all that the region does not touch") {
    const std::uint64_t number = seed(2);
    Mesh mesh = shaken(number);
    PassBench bench(mesh, {.edge_length = 0.14});
    Upkeep upkeep(bench.rated, 1);
    std::vector<TetId> good;
    for (const TetId t : tets(mesh.complex()))
        if (bench.rated.quality(t) >= bench.parameters.poor_quality) good.push_back(t);
    bench.region.assign(good);
    const auto before = labelled_tets(mesh.complex());
    const auto start = places(mesh);
    PassContext context = bench.context();
    upkeep.run(context);
    upkeep.rescue(context);
    CHECK(labelled_tets(mesh.complex()) == before);
    CHECK(places(mesh) == start);
}

TEST_CASE("the region holds all that upkeep has changed") {
    const std::uint64_t number = seed(3);
    Mesh mesh = shaken(number);
    PassBench bench(mesh, {.edge_length = 0.14});
    Upkeep upkeep(bench.rated, 1);
    std::vector<TetId> some;
    for (const TetId t : tets(mesh.complex()))
        if (bench.rated.quality(t) < bench.parameters.poor_quality && some.size() < 5) some.push_back(t);
    bench.region.assign(some);
    const auto before = labelled_tets(mesh.complex());
    const auto start = places(mesh);
    PassContext context = bench.context();
    upkeep.run(context);
    const std::set<TetId> region(bench.region.tets().begin(), bench.region.tets().end());
    std::size_t changed = 0;
    for (const TetId t : tets(mesh.complex())) {
        const TetVertices& v = mesh.complex().vertices(t);
        const bool is_moved = std::any_of(v.begin(), v.end(), [&](VertexId u) {
            const auto found = start.find(u);
            return found == start.end() || found->second != mesh.position(u);
        });
        if (!is_moved && before.count({oriented(v), mesh.complex().label(t)}) == 1) continue;
        ++changed;
        REQUIRE(region.count(t) == 1);
    }
    CHECK(changed > 0);
    CHECK(changed < tets(mesh.complex()).size());
}
