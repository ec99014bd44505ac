// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/improve/passes.h"

#include "tests/dsc3d/samples.h"
#include "tests/dsc3d/support.h"
#include "tests/support/seed.h"

using namespace dsc::dsc3d;
using namespace dsc::tests;
using dsc::core::Random;
using dsc::geometry::QualityMeasure;

namespace {

TetData passes_sample(int labels, Random& random) {
    const Cells cells = {4, 4, 4};
    TetData data = box(cells);
    if (labels > 1) label_slabs(data, cells, labels);
    shake_inside(data, 0.45, random);
    turn(data);
    return data;
}

double worst_quality(const RatedMesh& mesh) { return mesh.worst_quality(tets(mesh.complex())); }

std::size_t total(const PassCounts& counts) {
    return counts.smoothings + counts.edge_removals + counts.multi_face_removals + counts.multi_face_retriangulations +
           counts.collapses;
}

std::uint32_t surface_vertex_count(const Complex& complex) {
    const std::vector<VertexId> all = vertices(complex);
    return static_cast<std::uint32_t>(
        std::count_if(all.begin(), all.end(), [&](VertexId v) { return complex.is_surface(v); }));
}

}  // namespace

TEST_CASE("a pass never lowers the worst quality, moves no surface, and ends where it has nothing to do") {
    std::size_t retriangulations = 0;
    for (const int labels : {1, 2}) {
        for (const QualityMeasure measure : {QualityMeasure::minimum_biased_sine, QualityMeasure::radius_ratio}) {
            Random random(seed(1));
            Mesh mesh(passes_sample(labels, random));
            RatedMesh rated(mesh, measure, {});
            Passes passes(rated, {});
            const auto volumes_before = volumes(mesh);
            const auto areas_before = surface_areas(mesh);
            const auto check = [&](auto pass) {
                const double before = worst_quality(rated);
                (passes.*pass)();
                require_valid(mesh);
                REQUIRE(worst_quality(rated) >= before);
                require_same(volumes_before, volumes(mesh), 1e-12);
                require_same(areas_before, surface_areas(mesh), 1e-12);
            };
            std::size_t before = 0;
            int rounds = 0;
            do {
                before = total(passes.counts());
                check(&Passes::smooth_all_vertices);
                check(&Passes::topological_pass);
                REQUIRE(++rounds < 200);
            } while (total(passes.counts()) != before);
            CHECK(passes.counts().smoothings > 20);
            CHECK(passes.counts().edge_removals > 5);
            retriangulations += passes.counts().multi_face_retriangulations;
            CHECK(passes.counts().collapses == 0);
            // Nothing has changed since: nobody looks again.
            const std::uint32_t time = rated.time();
            passes.smooth_all_vertices();
            passes.topological_pass();
            CHECK(rated.time() == time);
        }
    }
    CHECK(retriangulations > 0);
}

TEST_CASE("a pass that was asked not to retriangulate does not") {
    Random random(seed(2));
    Mesh mesh(passes_sample(1, random));
    RatedMesh rated(mesh, QualityMeasure::minimum_sine, {});
    Passes passes(rated, {.uses_multi_face_retriangulation = false});
    for (int round = 0; round < 4; ++round) passes.smooth_all_vertices(), passes.topological_pass();
    CHECK(passes.counts().multi_face_retriangulations == 0);
    CHECK(passes.counts().edge_removals > 0);
}

TEST_CASE("thinning removes vertices and leaves tetrahedra that are better than the worst or good enough") {
    for (const bool removes_surface_vertices : {false, true}) {
        for (const double enough : {0.1, 0.3}) {
            Random random(seed(3));
            Mesh mesh(passes_sample(2, random));
            RatedMesh rated(mesh, QualityMeasure::minimum_sine, {});
            Passes passes(rated, {.removes_surface_vertices = removes_surface_vertices, .enough = enough});
            const double before = worst_quality(rated);
            const std::uint32_t vertices_before = mesh.complex().vertex_count();
            const std::uint32_t surface_before = surface_vertex_count(mesh.complex());
            const auto volumes_before = volumes(mesh);
            const auto areas_before = surface_areas(mesh);
            passes.thinning_pass();
            require_valid(mesh);
            CHECK(worst_quality(rated) >= std::min(before, enough));
            CHECK(passes.counts().collapses > 3);
            CHECK(mesh.complex().vertex_count() == vertices_before - passes.counts().collapses);
            CHECK((surface_vertex_count(mesh.complex()) < surface_before) == removes_surface_vertices);
            require_same(volumes_before, volumes(mesh), 1e-12);
            require_same(areas_before, surface_areas(mesh), 1e-12);
        }
    }
}

TEST_CASE("what a pass says is gone is gone") {
    Random random(seed(4));
    Mesh mesh(passes_sample(1, random));
    RatedMesh rated(mesh, QualityMeasure::minimum_sine, {});
    Passes passes(rated, {});
    int removed = 0;
    for (const TetId t : tets(mesh.complex())) {
        if (mesh.complex().is_deleted(t)) continue;
        const TetVertices before = mesh.complex().vertices(t);
        const bool is_removed = passes.remove_tet(t);
        removed += is_removed ? 1 : 0;
        REQUIRE(is_removed == mesh.complex().is_deleted(t));
        if (!is_removed) REQUIRE(mesh.complex().vertices(t) == before);
    }
    CHECK(removed > 20);
    std::uint32_t collapsed = 0;
    const std::uint32_t vertices_before = mesh.complex().vertex_count();
    for (const EdgeId e : edges(mesh.complex()))
        if (!mesh.complex().is_deleted(e) && passes.collapse_edge(e)) ++collapsed;
    CHECK(mesh.complex().vertex_count() == vertices_before - collapsed);
    require_valid(mesh);
}

TEST_CASE("a pass that is cancelled does nothing") {
    class Cancelling final : public dsc::core::Observer {
    public:
        bool is_cancelled() const override { return true; }
    };
    Random random(seed(5));
    Mesh mesh(passes_sample(1, random));
    RatedMesh rated(mesh, QualityMeasure::minimum_sine, {});
    const Cancelling observer;
    const StopCondition stop(observer, {});
    Passes passes(rated, {}, &stop);
    const LabelledTets before = labelled_tets(mesh.complex());
    passes.smooth_all_vertices();
    passes.topological_pass();
    passes.thinning_pass();
    CHECK(total(passes.counts()) == 0);
    CHECK(labelled_tets(mesh.complex()) == before);
}
