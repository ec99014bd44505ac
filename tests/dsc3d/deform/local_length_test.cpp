// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/local_length.h"

#include <limits>
#include <queue>

#include "tests/dsc3d/deform/support.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;

namespace {

/// Dijkstra's distances from the interface along the edges.
std::map<VertexId, double> distances(const Mesh& mesh) {
    std::map<VertexId, std::vector<std::pair<VertexId, double>>> next;
    for (const EdgeId e : edges(mesh.complex())) {
        const auto [a, b] = mesh.complex().vertices(e);
        const double length = (mesh.position(a) - mesh.position(b)).norm();
        next[a].emplace_back(b, length);
        next[b].emplace_back(a, length);
    }
    std::map<VertexId, double> found;
    std::priority_queue<std::pair<double, VertexId>, std::vector<std::pair<double, VertexId>>, std::greater<>> open;
    for (const VertexId v : vertices(mesh.complex()))
        if (mesh.complex().is_interface(v)) open.emplace(0, v);
    while (!open.empty()) {
        const auto [distance, v] = open.top();
        open.pop();
        if (!found.emplace(v, distance).second) continue;
        for (const auto& [u, length] : next[v])
            if (found.count(u) == 0) open.emplace(distance + length, u);
    }
    return found;
}

/// By how much the most the lengths at the ends of an edge differ beyond growth times its length.
double excess(const Mesh& mesh, const LocalLength& length, double growth) {
    double most = -std::numeric_limits<double>::infinity();
    for (const EdgeId e : edges(mesh.complex())) {
        const auto [a, b] = mesh.complex().vertices(e);
        // Of two vertices of the interface, only the caller decides.
        if (mesh.complex().is_interface(a) && mesh.complex().is_interface(b)) continue;
        most = std::max(most,
                        std::abs(length.at(a) - length.at(b)) - growth * (mesh.position(a) - mesh.position(b)).norm());
    }
    return most;
}

}  // namespace

TEST_CASE("wanted lengths grow with the distance from the interface along the edges") {
    const Mesh mesh = box_with(distance_from_sphere({0.4, 0.5, 0.5}, 0.2), 0.12);
    for (const double growth : {0.0, 0.3, 1.0}) {
        const LocalLength length(mesh, 0.1, growth);
        for (const auto& [v, distance] : distances(mesh))
            REQUIRE(length.at(v) == Approx(0.1 + growth * distance).epsilon(1e-13));
    }
}

TEST_CASE("in a mesh without an interface the wanted length is the same everywhere") {
    const Mesh mesh(box({3, 3, 3}));
    const LocalLength length(mesh, 0.7, 1);
    for (const VertexId v : vertices(mesh.complex())) CHECK(length.at(v) == 0.7);
}

TEST_CASE("after an update of everything, neighbours differ by growth times their distance at most") {
    Mesh mesh = box_with(distance_from_sphere({0.4, 0.5, 0.5}, 0.2), 0.12);
    const double growth = 0.6;
    RatedMesh rated(mesh, geometry::QualityMeasure::minimum_sine, FlatSurface::flat_boundary(mesh));
    LocalLength length(mesh, 0.1, growth);
    const std::vector<VertexId> all = vertices(mesh.complex());
    for (int step = 0; step < 8; ++step) {
        for (const VertexId v : all) {
            if (!mesh.complex().is_interface(v)) continue;
            rated.move(v, mesh.position(v) + Point3(0.01, 0.003, -0.002), rated.walker().star(v));
        }
        length.update(rated, all);
        CHECK(excess(mesh, length, growth) < 1e-12);
    }
    for (const VertexId v : all)
        if (mesh.complex().is_interface(v)) CHECK(length.at(v) == 0.1);
    // A length that is set at one vertex of the interface is taken by its neighbours.
    const VertexId first =
        *std::find_if(all.begin(), all.end(), [&](VertexId v) { return mesh.complex().is_interface(v); });
    length.set(first, 0.01);
    length.update(rated, all);
    CHECK(length.at(first) == 0.01);
    for (const EdgeId e : edges(mesh.complex())) {
        const auto ends = mesh.complex().vertices(e);
        const double rise = growth * (mesh.position(ends[0]) - mesh.position(ends[1])).norm();
        for (const std::size_t i : {0u, 1u})
            if (!mesh.complex().is_interface(ends[i]))
                REQUIRE(length.at(ends[i]) <= length.at(ends[1 - i]) + rise + 1e-12);
    }
}
