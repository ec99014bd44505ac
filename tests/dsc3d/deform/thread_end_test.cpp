// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/thread_end.h"

#include <numbers>

#include "dsc3d/deform/deformer.h"
#include "dsc3d/generate/delaunay.h"
#include "tests/dsc3d/deform/support.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;
using motion::TopologyPolicy;

namespace {

constexpr int rings = 5;

// A prism along x over triangles of this radius, of length rings - 1, in a box; its vertices are the first ones.
Mesh prism_in_box(double radius) {
    std::vector<Point3> points;
    for (int ring = 0; ring < rings; ++ring)
        for (int corner = 0; corner < 3; ++corner) {
            const double angle = 2 * std::numbers::pi * corner / 3;
            points.emplace_back(ring - 0.5 * (rings - 1), radius * std::cos(angle), radius * std::sin(angle));
        }
    const std::size_t of_prism = points.size();
    for (const double x : {-4.0, 4.0})
        for (const double y : {-4.0, 4.0})
            for (const double z : {-4.0, 4.0}) points.emplace_back(x, y, z);
    TetData data = delaunay(points);
    for (const auto& tet : data.tets)
        data.labels.push_back(std::all_of(tet.begin(), tet.end(), [&](auto v) { return v < of_prism; }) ? 1 : 0);
    return Mesh(data);
}

bool is_at_an_end(const Mesh& mesh, VertexId v) { return std::abs(mesh.position(v).x()) == 0.5 * (rings - 1); }

std::size_t interface_vertex_count(const Mesh& mesh) {
    const std::vector<VertexId> all = vertices(mesh.complex());
    return static_cast<std::size_t>(
        std::count_if(all.begin(), all.end(), [&](VertexId v) { return mesh.complex().is_interface(v); }));
}

}  // namespace

TEST_CASE("the ends of a thread are found, if it is thin and may not be cut") {
    const double thin = 0.05, thick = 0.3;
    for (const double radius : {thin, thick}) {
        for (const TopologyPolicy policy : {TopologyPolicy::adaptive, TopologyPolicy::preserved,
                                            TopologyPolicy::merge_only, TopologyPolicy::split_only}) {
            Mesh mesh = prism_in_box(radius);
            PassBench bench(mesh, {.edge_length = 1, .topology = policy});
            PassContext context = bench.context();
            const bool may_be_cut = policy != TopologyPolicy::preserved;
            ThreadEnd end;
            for (const VertexId v : vertices(mesh.complex())) {
                const bool is_expected =
                    radius == thin && !may_be_cut && mesh.complex().is_interface(v) && is_at_an_end(mesh, v);
                CHECK(end.find(context, v) == is_expected);
            }
        }
    }
}

TEST_CASE("a thread is taken back from its ends, as far as its topology allows") {
    Mesh mesh = prism_in_box(0.05);
    REQUIRE(interface_vertex_count(mesh) == 3 * rings);
    Deformer deformer(mesh, {.edge_length = 1, .topology = TopologyPolicy::preserved});
    for (int round = 0; round < 8; ++round) {
        deformer.improve_everywhere();
        REQUIRE(validate(mesh).empty());
    }
    CHECK(interface_vertex_count(mesh) == 4);
    const LabelStatistics thread = statistics_by_label(mesh).at(1);
    CHECK(thread.components == 1);
    CHECK(thread.genus == 0);
}
