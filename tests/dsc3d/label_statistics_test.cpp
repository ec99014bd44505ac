// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/label_statistics.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <map>

#include "dsc3d/generate/lattice.h"
#include "tests/dsc3d/samples.h"
#include "tests/dsc3d/support.h"
#include "tests/dsc3d/volumes.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;

namespace {

// A lattice of `cells` in each direction, labelled by the centroid of each tetrahedron.
Mesh labelled(int cells, const std::function<int(const Point3&)>& label) {
    geometry::TetData data = lattice({Point3(0, 0, 0), Point3(1, 1, 1)}, 1.0 / cells);
    for (const auto& [a, b, c, d] : data.tets)
        data.labels.push_back(label((data.vertices[a] + data.vertices[b] + data.vertices[c] + data.vertices[d]) / 4));
    return Mesh(data);
}

std::map<int, LabelStatistics> by_label(const Mesh& mesh) {
    std::map<int, LabelStatistics> result;
    for (const LabelStatistics& statistics : label_statistics(mesh)) result[statistics.label] = statistics;
    return result;
}

// Cubes of tetrahedra, labelled by the cube.
Mesh labelled_cubes(std::uint32_t cells, const std::function<int(const Point3&)>& label) {
    geometry::TetData data = box({cells, cells, cells});
    for (Point3& p : data.vertices) p /= cells;
    for (const auto& [a, b, c, d] : data.tets) {
        const Point3 p = (data.vertices[a] + data.vertices[b] + data.vertices[c] + data.vertices[d]) / 4;
        data.labels.push_back(label(((p * cells).array().floor() + 0.5) / cells));
    }
    return Mesh(data);
}

bool is_in(const Point3& p, const Point3& low, const Point3& high) {
    return (p.array() > low.array()).all() && (p.array() < high.array()).all();
}

}  // namespace

TEST_CASE("volumes, areas and components of labels agree with sums over the simplices") {
    const Mesh mesh = labelled(6, [](const Point3& p) { return p.x() + p.y() < 0.8 ? 3 : p.z() < 0.4 ? 1 : 0; });
    const auto volume = volumes(mesh);
    const auto area = surface_areas(mesh);
    for (const auto& [label, statistics] : by_label(mesh)) {
        CHECK(statistics.volume == Approx(volume.at(label)).epsilon(1e-12));
        CHECK(statistics.components == components_of_label(mesh.complex(), label));
        double boundary = 0, interface = 0;
        for (const auto& [labels, share] : area) {
            if (labels.first != label && labels.second != label) continue;
            (labels.first == -1 ? boundary : interface) += share;
        }
        CHECK(statistics.boundary_area == Approx(boundary).epsilon(1e-12));
        CHECK(statistics.interface_area == Approx(interface).epsilon(1e-12));
        CHECK(statistics.genus == 0);
        CHECK(statistics.surfaces == 1);
    }
}

TEST_CASE("genus and surfaces of balls, rings, cavities and several parts") {
    const auto is_ball = [](const Point3& p) { return (p - Point3(0.5, 0.5, 0.5)).norm() < 0.3; };
    auto of = by_label(labelled(10, [&](const Point3& p) { return is_ball(p) ? 1 : 0; }));
    CHECK(of[1].genus == 0);
    CHECK(of[1].surfaces == 1);
    CHECK(of[0].genus == 0);
    CHECK(of[0].surfaces == 2);
    CHECK(of[0].components == 1);

    of = by_label(labelled(16, [](const Point3& p) {
        return std::hypot(std::hypot(p.x() - 0.5, p.y() - 0.5) - 0.28, p.z() - 0.5) < 0.12 ? 1 : 0;
    }));
    CHECK(of[1].genus == 1);
    CHECK(of[0].genus == 1);
    CHECK(of[0].surfaces == 2);

    of = by_label(labelled(16, [](const Point3& p) {
        // A plate with two holes, and a ball that has a cavity.
        if ((p - Point3(0.5, 0.5, 0.75)).norm() < 0.2) return (p - Point3(0.5, 0.5, 0.75)).norm() < 0.1 ? 0 : 1;
        if (!is_in(p, Point3(0.1, 0.2, 0.2), Point3(0.9, 0.8, 0.4))) return 0;
        return is_in(p, Point3(0.25, 0.4, 0), Point3(0.4, 0.6, 1)) ||
                       is_in(p, Point3(0.6, 0.4, 0), Point3(0.75, 0.6, 1))
                   ? 0
                   : 1;
    }));
    CHECK(of[1].components == 2);
    CHECK(of[1].surfaces == 3);
    CHECK(of[1].genus == 2);
    CHECK(of[0].components == 2);
    CHECK(of[0].genus == 2);
}

TEST_CASE("where surfaces touch in an edge or a vertex, each is taken as seen from inside") {
    // Two cubes that meet in one corner, or in one edge.
    const auto is_low = [](const Point3& p) { return is_in(p, Point3(0.25, 0.25, 0.25), Point3(0.5, 0.5, 0.5)); };
    for (const double top : {0.75, 0.5}) {
        const Point3 high(0.75, 0.75, top);
        const auto of = by_label(labelled_cubes(
            4, [&](const Point3& p) { return is_low(p) || is_in(p, high - Point3(0.25, 0.25, 0.25), high) ? 1 : 0; }));
        CHECK(of.at(1).components == 2);
        CHECK(of.at(1).surfaces == 2);
        CHECK(of.at(1).genus == 0);
        CHECK(of.at(0).components == 1);
        // From outside, the walk around an edge goes from one cube to the other one.
        CHECK(of.at(0).surfaces == (top == 0.5 ? 2 : 3));
        CHECK(of.at(0).genus == 0);
    }
}

TEST_CASE("a ring that is closed by an edge only is a ball, and outside it a ring") {
    // Seven of eight cubes around a hole: the two beside the gap meet in an edge.
    const auto of = by_label(labelled_cubes(5, [](const Point3& p) {
        if (!is_in(p, Point3(0.2, 0.2, 0.4), Point3(0.8, 0.8, 0.6))) return 0;
        const int x = static_cast<int>(p.x() * 5) - 1, y = static_cast<int>(p.y() * 5) - 1;
        return (x == 1 && y == 1) || (x == 2 && y == 2) ? 0 : 1;
    }));
    CHECK(of.at(1).components == 1);
    CHECK(of.at(1).genus == 0);
    CHECK(of.at(0).genus == 1);
    CHECK(of.at(0).components == 1);
}
