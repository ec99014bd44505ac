// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/detail.h"

#include "tests/dsc3d/deform/support.h"
#include "tests/dsc3d/volumes.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;

namespace {

std::map<VertexId, Point3> interface_places(const Mesh& mesh) {
    std::map<VertexId, Point3> found;
    for (const auto& [v, place] : places(mesh))
        if (mesh.complex().is_interface(v)) found[v] = place;
    return found;
}

double longest_off_interface(PassBench& bench) {
    double longest = 0;
    PassContext context = bench.context();
    for (const EdgeId e : edges(context.complex()))
        if (!context.complex().is_interface(e)) longest = std::max(longest, context.relative_length(e));
    return longest;
}

}  // namespace

TEST_CASE("no edge off the interface stays longer than wanted, and the interface stays") {
    for (const double wanted : {0.12, 0.08, 0.05}) {
        Mesh mesh = box_with(distance_from_sphere({0.5, 0.5, 0.5}, 0.25), 0.2);
        PassBench bench(mesh, {.edge_length = wanted});
        DetailControl detail;
        const auto triangles = interface_triangles(mesh.complex());
        const auto fixed = interface_places(mesh);
        const auto before = volumes(mesh);
        const auto areas = surface_areas(mesh);
        // Whatever is longest is halved in a run.
        for (int run = 0; run < 6; ++run) {
            const double longest = longest_off_interface(bench);
            PassContext context = bench.context();
            DetailControl::update_lengths(context);
            detail.split_long_edges(context);
            require_valid(mesh);
            CHECK(longest_off_interface(bench) <= std::max(longest, bench.parameters.max_edge) * (1 + 1e-9));
            bench.take_all();
        }
        CHECK(longest_off_interface(bench) <= bench.parameters.max_edge);
        CHECK((bench.report.counts.edge_splits > 0) == (wanted < 0.06));
        CHECK(interface_triangles(mesh.complex()) == triangles);
        CHECK(interface_places(mesh) == fixed);
        require_same(before, volumes(mesh), 1e-12);
        require_same(areas, surface_areas(mesh), 1e-12);
    }
}

TEST_CASE("short edges off the interface are collapsed as far as the tetrahedra stay good, and the interface stays") {
    Mesh mesh = box_with(distance_from_sphere({0.5, 0.5, 0.5}, 0.25), 0.1);
    PassBench bench(mesh, {.edge_length = 0.3});
    DetailControl detail;
    const auto triangles = interface_triangles(mesh.complex());
    const auto fixed = interface_places(mesh);
    const auto before = volumes(mesh);
    const auto areas = surface_areas(mesh);
    const std::uint32_t count = mesh.complex().vertex_count();
    double worst = 1;
    for (const TetId t : tets(mesh.complex())) worst = std::min(worst, bench.rated.quality(t));
    PassContext context = bench.context();
    DetailControl::update_lengths(context);
    detail.collapse_short_edges(context);
    require_valid(mesh);
    CHECK(bench.report.counts.collapses == count - mesh.complex().vertex_count());
    CHECK(bench.report.counts.collapses > count / 4);
    for (const TetId t : tets(mesh.complex()))
        REQUIRE(bench.rated.quality(t) >= std::min(worst, bench.parameters.collapse_quality));
    CHECK(interface_triangles(mesh.complex()) == triangles);
    CHECK(interface_places(mesh) == fixed);
    require_same(before, volumes(mesh), 1e-12);
    require_same(areas, surface_areas(mesh), 1e-12);
    // What a collapse makes need not be split again.
    bench.take_all();
    const std::size_t splits = bench.report.counts.edge_splits;
    PassContext again = bench.context();
    DetailControl::update_lengths(again);
    detail.split_long_edges(again);
    CHECK(bench.report.counts.edge_splits == splits);
}
