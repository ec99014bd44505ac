// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/interface_control.h"

#include <cmath>
#include <numbers>

#include "tests/dsc3d/deform/support.h"
#include "tests/dsc3d/volumes.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;

namespace {

std::vector<double> interface_lengths(PassBench& bench) {
    std::vector<double> lengths;
    PassContext context = bench.context();
    for (const EdgeId e : edges(context.complex()))
        if (context.complex().is_interface(e)) lengths.push_back(context.relative_length(e));
    std::sort(lengths.begin(), lengths.end());
    return lengths;
}

}  // namespace

TEST_CASE("a sphere gets the lengths that are wanted, which vary, and keeps its place and its topology") {
    Mesh mesh = box_with(distance_from_sphere({0.5, 0.5, 0.5}, 0.3), 0.12);
    PassBench bench(mesh, {.edge_length = 0.08});
    const auto set_lengths = [&] {
        for (const VertexId v : vertices(mesh.complex()))
            if (mesh.complex().is_interface(v)) bench.wanted_length.set(v, 0.04 + 0.08 * mesh.position(v).x());
        bench.take_all();
        bench.wanted_length.update(bench.rated, vertices(mesh.complex()));
    };
    InterfaceControl control(mesh);
    set_lengths();
    const double volume = volumes(mesh).at(1), worst = worst_quality(bench);
    const std::size_t before = interface_lengths(bench).size();
    const auto in_range = [&] {
        const std::vector<double> lengths = interface_lengths(bench);
        const surface::EdgeLengthParameters& limits = bench.parameters.interface_lengths;
        const auto low = std::lower_bound(lengths.begin(), lengths.end(), limits.collapse_below);
        const auto high = std::upper_bound(lengths.begin(), lengths.end(), limits.split_above);
        return static_cast<double>(high - low) / static_cast<double>(lengths.size());
    };
    const double share = in_range();
    for (int run = 0; run < 6; ++run) {
        set_lengths();
        PassContext context = bench.context();
        control.reconsider();
        control.run(context);
        require_valid(mesh);
        CHECK(worst_quality(bench) >= std::min(worst, bench.parameters.interface_quality));
    }
    set_lengths();
    CHECK(interface_lengths(bench).size() != before);
    CHECK(in_range() > std::max(share, 0.95));
    CHECK(interface_lengths(bench).back() < 1.5);
    CHECK(interface_lengths(bench).front() > 0.3);
    // New vertices go where the ball suggests, so that it has more of its volume than before.
    const double ideal = 4 * std::numbers::pi / 3 * std::pow(0.3, 3);
    CHECK(volumes(mesh).at(1) > volume);
    CHECK(volumes(mesh).at(1) < ideal);
    CHECK(volumes(mesh).at(0) + volumes(mesh).at(1) == Approx(1).epsilon(1e-12));
    const LabelStatistics ball = statistics_by_label(mesh).at(1);
    CHECK(ball.components == 1);
    CHECK(ball.surfaces == 1);
    CHECK(ball.genus == 0);
    for (const VertexId v : vertices(mesh.complex()))
        if (mesh.complex().is_interface(v))
            CHECK(std::abs(distance_from_sphere({0.5, 0.5, 0.5}, 0.3)(mesh.position(v))) < 0.012);
}

TEST_CASE("a cube keeps its corners and its edges, whatever lengths are wanted") {
    for (const double wanted : {0.6, 1.0, 3.0}) {
        Mesh mesh = cubes_with({6, 6, 6},
                               [](const Point3& p) { return (p.array() > 1).all() && (p.array() < 5).all() ? 1 : 0; });
        PassBench bench(mesh, {.edge_length = wanted});
        InterfaceControl control(mesh);
        const std::size_t before = interface_triangles(mesh.complex()).size();
        for (int run = 0; run < 5; ++run) {
            bench.take_all();
            bench.wanted_length.update(bench.rated, vertices(mesh.complex()));
            PassContext context = bench.context();
            control.reconsider();
            control.run(context);
            require_valid(mesh);
        }
        if (wanted < 1) CHECK(interface_triangles(mesh.complex()).size() > 2 * before);
        if (wanted > 2) CHECK(interface_triangles(mesh.complex()).size() < before / 2);
        CHECK(volumes(mesh).at(1) == Approx(64).epsilon(1e-12));
        CHECK(surface_areas(mesh).at({0, 1}) == Approx(96).epsilon(1e-12));
        int corners = 0;
        double ridges = 0;
        const auto sides = [&](VertexId v) {
            int count = 0;
            for (const double x : mesh.position(v)) count += std::abs(std::abs(x - 3) - 2) < 1e-12 ? 1 : 0;
            return count;
        };
        for (const VertexId v : vertices(mesh.complex())) {
            if (!mesh.complex().is_interface(v)) continue;
            CHECK(sides(v) >= 1);
            const Point3 p = mesh.position(v);
            if (sides(v) == 3) {
                ++corners;
                CHECK(((p.array() == 1) || (p.array() == 5)).all());
            }
        }
        CHECK(corners == 8);
        for (const EdgeId e : edges(mesh.complex())) {
            const auto [a, b] = mesh.complex().vertices(e);
            if (!mesh.complex().is_interface(e) || sides(a) < 2 || sides(b) < 2) continue;
            const Point3 along = (mesh.position(b) - mesh.position(a)).cwiseAbs();
            if (along.maxCoeff() > (1 - 1e-9) * along.norm()) ridges += along.norm();
        }
        CHECK(ridges == Approx(12 * 4).epsilon(1e-12));
    }
}

TEST_CASE("degenerate edges and caps of the interface disappear, also where it is bent") {
    core::Random random(seed(1));
    Mesh mesh = box_with(distance_from_sphere({0.5, 0.5, 0.5}, 0.3), 0.15);
    PassBench bench(mesh, {.edge_length = 0.12});
    InterfaceControl control(mesh);
    std::vector<EdgeId> some;
    for (const EdgeId e : edges(mesh.complex()))
        if (mesh.complex().is_interface(e) && random.below(6) == 0) some.push_back(e);
    int made = 0;
    for (const EdgeId e : some) {
        if (mesh.complex().is_deleted(e) || !mesh.complex().is_interface(e)) continue;
        const auto [a, b] = mesh.complex().vertices(e);
        const Point3 near = mesh.position(a) + 0.1 * (mesh.position(b) - mesh.position(a));
        made += bench.rated.split(e, near).is_valid() ? 1 : 0;
    }
    REQUIRE(made > 20);
    const auto degenerate = [&] {
        const std::vector<double> lengths = interface_lengths(bench);
        return std::lower_bound(lengths.begin(), lengths.end(), bench.parameters.degenerate_edge) - lengths.begin();
    };
    REQUIRE(degenerate() >= made);
    for (int run = 0; run < 2; ++run) {
        bench.take_all();
        PassContext context = bench.context();
        control.reconsider();
        control.run(context);
        require_valid(mesh);
    }
    CHECK(degenerate() == 0);
    // Smoothing makes longer edges of some.
    CHECK(bench.report.counts.collapses > static_cast<std::size_t>(made) / 2);
    CHECK(statistics_by_label(mesh).at(1).genus == 0);
    CHECK(statistics_by_label(mesh).at(1).components == 1);
}

TEST_CASE("the listener hears of every vertex of the interface that comes or goes") {
    struct Census final : Listener {
        explicit Census(const Mesh& of) : mesh(of) {
            for (const VertexId v : vertices(mesh.complex()))
                if (mesh.complex().is_interface(v)) there.insert(v);
        }
        void on_interface_split(VertexId m, VertexId a, VertexId b, double s) override {
            CHECK(there.count(a) == 1);
            CHECK(there.count(b) == 1);
            const Point3 &p = mesh.position(a), &q = mesh.position(b);
            CHECK((mesh.position(m) - ((1 - s) * p + s * q)).norm() < 0.1 * (q - p).norm());  // a ball is curved
            CHECK(there.insert(m).second);
        }
        void on_interface_collapse(VertexId removed, VertexId kept) override {
            CHECK(there.erase(removed) == 1);
            CHECK(there.count(kept) == 1);
        }
        const Mesh& mesh;
        std::set<VertexId> there;
    };
    for (const double wanted : {0.08, 0.22}) {
        Mesh mesh = box_with(distance_from_sphere({0.5, 0.5, 0.5}, 0.3), 0.15);
        PassBench bench(mesh, {.edge_length = wanted});
        Census census(mesh);
        InterfaceControl control(mesh);
        PassContext context{bench.rated,  bench.parameters, bench.wanted_length, bench.way, bench.pull,
                            bench.region, census,           bench.report};
        control.reconsider();
        control.run(context);
        std::set<VertexId> now;
        for (const VertexId v : vertices(mesh.complex()))
            if (mesh.complex().is_interface(v)) now.insert(v);
        CHECK(now == census.there);
        CHECK((wanted < 0.1 ? bench.report.counts.edge_splits : bench.report.counts.collapses) > 10);
    }
}
