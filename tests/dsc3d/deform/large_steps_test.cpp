// SPDX-License-Identifier: GPL-3.0-or-later
// Steps much longer than what is in their way: a small ball is thrown at a thin plate, ten of its diameters in a step.
// bench/large_steps_3d.cpp does it with more plates, balls and directions.
#include <algorithm>

#include "core/observer.h"
#include "dsc3d/deform/deformer.h"
#include "dsc3d/generate/blocks.h"
#include "dsc3d/generate/shapes.h"
#include "dsc3d/generate/tetrahedralize.h"
#include "tests/dsc3d/deform/support.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;
using motion::TopologyPolicy;

namespace {

constexpr double front = 0.5;  // x of the side of the plate at which the ball is thrown
constexpr double start_radius = 0.05, edge_length = 0.03;
constexpr int ball_label = 1, plate_label = 2;

void append(geometry::InterfaceData& all, const geometry::SurfaceData& part, int label) {
    const auto first = static_cast<std::uint32_t>(all.surface.vertices.size());
    all.surface.vertices.insert(all.surface.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const auto& [a, b, c] : part.triangles) {
        all.surface.triangles.push_back({a + first, b + first, c + first});
        all.sides.push_back({0, label});
    }
}

/// A ball that will hit the middle of the plate after a way of four radii or more.
Mesh ball_and_plate(double thickness, const Point3& direction) {
    const Point3 centre = Point3(front, 0.5, 0.5) - 4 * start_radius * direction / direction.x();
    geometry::InterfaceData all;
    append(all, icosphere(centre, start_radius, icosphere_frequency(start_radius, edge_length)), ball_label);
    append(all, box_surface({Point3(front, 0.38, 0.38), Point3(front + thickness, 0.62, 0.62)}, edge_length),
           plate_label);
    core::Observer observer;
    return Mesh(tetrahedralize(all, {Point3(-1, -0.5, -0.5), Point3(2, 1.5, 1.5)}, {}, observer));
}

std::map<VertexId, Point3> vertices_of(const Mesh& mesh, int label) {
    std::map<VertexId, Point3> found;
    for (const TetId t : tets(mesh.complex()))
        if (mesh.complex().label(t) == label)
            for (const VertexId v : mesh.complex().vertices(t)) found[v] = mesh.position(v);
    return found;
}

StepReport throw_ball(Mesh& mesh, Deformer& deformer, const Point3& direction) {
    std::vector<std::optional<Point3>> targets(mesh.complex().vertex_capacity());
    for (const auto& [v, p] : vertices_of(mesh, ball_label)) {
        if (mesh.complex().is_interface(v)) targets[v.index()] = p + 20 * start_radius * direction;
    }
    StepReport report = deformer.step(targets);
    REQUIRE(validate(mesh).empty());
    return report;
}

const std::array throws = {std::pair(0.3, Point3(1, 0, 0)), std::pair(1.0, Point3(0.88, 0.44, 0.18)),
                           std::pair(0.1, Point3(0.8, -0.5, 0.33))};  // plates in edge lengths, directions

}  // namespace

TEST_CASE("a ball thrown ten diameters far stays in front of a thin plate where they may not touch", "[slow]") {
    for (const auto& [thickness, way] : throws) {
        CAPTURE(thickness, way.transpose());
        const Point3 direction = way.normalized();
        Mesh mesh = ball_and_plate(thickness * edge_length, direction);
        Deformer deformer(mesh, {.edge_length = edge_length, .topology = TopologyPolicy::preserved});
        const auto plate = vertices_of(mesh, plate_label);
        const StepReport report = throw_ball(mesh, deformer, direction);
        CHECK_FALSE(report.unfinished.empty());
        CHECK_FALSE(report.contacts.empty());
        for (const auto& [v, p] : vertices_of(mesh, ball_label)) REQUIRE(p.x() < front);
        CHECK(vertices_of(mesh, plate_label) == plate);  // with all bits
        for (const int label : {0, ball_label, plate_label}) {
            CHECK(statistics_by_label(mesh).at(label).components == 1);
            CHECK(statistics_by_label(mesh).at(label).genus == 0);
        }
    }
}

TEST_CASE("where it may, it touches the side of the plate that it was thrown at, and the other side stays", "[slow]") {
    for (const auto& [thickness, way] : throws) {
        CAPTURE(thickness, way.transpose());
        const Point3 direction = way.normalized();
        Mesh mesh = ball_and_plate(thickness * edge_length, direction);
        EventList list;
        Deformer deformer(mesh, {.edge_length = edge_length, .topology = TopologyPolicy::adaptive}, list);
        const auto before = vertices_of(mesh, plate_label);
        throw_ball(mesh, deformer, direction);
        CHECK(std::ranges::count_if(list.events, [](const Event& event) { return event.label == 0; }) > 0);
        for (const Event& event : list.events) CHECK(event.place.x() < front);
        for (const auto& [v, p] : vertices_of(mesh, ball_label)) CHECK(p.x() < front + 0.01 * thickness * edge_length);
        const auto after = vertices_of(mesh, plate_label);
        for (const auto& [v, p] : before)
            if (p.x() > front + 1e-12) REQUIRE((after.count(v) == 1 && after.at(v) == p));
        CHECK(statistics_by_label(mesh).at(plate_label).components == 1);
        CHECK(statistics_by_label(mesh).at(plate_label).genus == 0);
    }
}
