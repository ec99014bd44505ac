// SPDX-License-Identifier: GPL-3.0-or-later
// Steps much longer than what is in their way: a small ball of one label is thrown at a thin plate of another one, ten
// of its diameters per step; only its vertices have targets. `preserved`: it stays in front, the plate keeps all its
// bits. `adaptive`: what happens, happens on the side it was thrown at, and the other side keeps its bits. Plates,
// balls and directions vary; a row says what was found. Exit code 1 when one does not hold.
//
//     large_steps_3d            # directions by seed 1
//     large_steps_3d 5          # by another seed
#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <string>

#include "apps/common/run_main.h"
#include "core/random.h"
#include "core/stopwatch.h"
#include "dsc3d/deform/deformer.h"
#include "dsc3d/generate/blocks.h"
#include "dsc3d/generate/shapes.h"
#include "dsc3d/generate/tetrahedralize.h"
#include "dsc3d/label_statistics.h"

namespace {

using namespace dsc;
using namespace dsc::dsc3d;
using motion::TopologyPolicy;

constexpr double front = 0;  // x of the side of the plate at which the ball is thrown
constexpr double plate_side = 0.24;
constexpr int ball_label = 1, plate_label = 2;
constexpr double at_rest = 1e-12;  // beyond `front`, vertices are of the other side

struct Throw {
    double radius, edge_length, thickness;
    Point3 direction;
};

void append(geometry::InterfaceData& all, const geometry::SurfaceData& part, int label) {
    const auto first = static_cast<std::uint32_t>(all.surface.vertices.size());
    all.surface.vertices.insert(all.surface.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const auto& [a, b, c] : part.triangles) {
        all.surface.triangles.push_back({a + first, b + first, c + first});
        all.sides.push_back({0, label});
    }
}

Mesh ball_and_plate(const Throw& thrown) {
    const Point3 centre = -4 * thrown.radius * thrown.direction / thrown.direction.x();
    geometry::InterfaceData all;
    append(all, icosphere(centre, thrown.radius, icosphere_frequency(thrown.radius, thrown.edge_length)), ball_label);
    append(all,
           box_surface({Point3(front, -plate_side / 2, -plate_side / 2),
                        Point3(front + thrown.thickness, plate_side / 2, plate_side / 2)},
                       thrown.edge_length),
           plate_label);
    core::Observer observer;
    return Mesh(tetrahedralize(all, {Point3::Constant(-1.5), Point3::Constant(1.5)}, {}, observer));
}

std::map<VertexId, Point3> vertices_of(const Mesh& mesh, int label) {
    std::map<VertexId, Point3> found;
    for (std::uint32_t i = 0; i < mesh.complex().tet_capacity(); ++i) {
        const TetId t(i);
        if (mesh.complex().is_deleted(t) || mesh.complex().label(t) != label) continue;
        for (const VertexId v : mesh.complex().vertices(t)) found[v] = mesh.position(v);
    }
    return found;
}

class EventCounter final : public Listener {
public:
    void on_event(const Event& event) override {
        ++(event.label == 0 ? merges : splits);
        furthest = std::max(furthest, event.place.x());
    }
    int merges = 0, splits = 0;
    double furthest = -1;
};

// What does not hold; empty when all does.
std::string judge(const Throw& thrown, TopologyPolicy policy, std::uint64_t seed) {
    Mesh mesh = ball_and_plate(thrown);
    EventCounter events;
    Deformer deformer(mesh, {.edge_length = thrown.edge_length, .seed = seed, .topology = policy}, events);
    const auto before = vertices_of(mesh, plate_label);
    std::vector<std::optional<Point3>> targets(mesh.complex().vertex_capacity());
    for (const auto& [v, p] : vertices_of(mesh, ball_label))
        if (mesh.complex().is_interface(v)) targets[v.index()] = p + 20 * thrown.radius * thrown.direction;
    const core::Stopwatch watch;
    const StepReport report = deformer.step(targets);
    const double seconds = watch.seconds();

    std::string misses;
    const auto require = [&](bool holds, const char* what) { misses += holds ? "" : std::string("; ") + what; };
    const bool is_preserved = policy == TopologyPolicy::preserved;
    const auto after = vertices_of(mesh, plate_label);
    double tip = -1;
    for (const auto& [v, p] : vertices_of(mesh, ball_label)) tip = std::max(tip, p.x());
    bool stays = true;
    for (const auto& [v, p] : before)
        if (is_preserved || p.x() > front + at_rest) stays = stays && after.contains(v) && after.at(v) == p;
    require(stays, "the plate has moved");
    require(validate(mesh).empty(), "the mesh is not valid");
    require(is_preserved ? tip < front : tip < front + thrown.thickness / 2, "the ball is in the plate");
    require(is_preserved || events.merges > 0, "no merge");
    require(is_preserved ? events.merges + events.splits == 0 : events.furthest < front + thrown.thickness / 2,
            "an event where none may be");
    for (const LabelStatistics& label : label_statistics(mesh))
        if (is_preserved || label.label == plate_label)
            require(label.components == 1 && label.genus == 0, "another topology");
    const Point3& d = thrown.direction;
    fmt::print(
        "{:9} ball {:4.2f}, edges {:5.3f}, plate {:6.4f}, direction {:5.2f} {:5.2f} {:5.2f}: {:3} substeps, {:5.2f} "
        "s, {} merges, {} splits, ball ends {:8.5f} from the plate{}\n",
        is_preserved ? "preserved" : "adaptive", thrown.radius, thrown.edge_length, thrown.thickness, d.x(), d.y(),
        d.z(), report.substeps, seconds, events.merges, events.splits, front - tip, misses);
    std::fflush(stdout);
    return misses;
}

int run(int argc, const char* const* argv) {
    const std::uint64_t seed = argc > 1 ? std::stoull(argv[1]) : 1;
    core::Random random(seed);
    int failures = 0, count = 0;
    for (const auto& [radius, edges_per_radius] : {std::pair(0.05, 1.7), std::pair(0.03, 1.3)}) {
        for (const double plate : {1.0, 0.3, 0.1}) {
            const double edge_length = radius / edges_per_radius;
            const Point3 slanted = Point3(1, random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8)).normalized();
            for (const Point3& direction : {Point3(1, 0, 0), slanted}) {
                for (const TopologyPolicy policy : {TopologyPolicy::preserved, TopologyPolicy::adaptive}) {
                    ++count;
                    failures +=
                        judge({radius, edge_length, plate * edge_length, direction}, policy, seed).empty() ? 0 : 1;
                }
            }
        }
    }
    fmt::print("{} of {} throws hold\n", count - failures, count);
    return failures == 0 ? apps::exit_done : apps::exit_failed;
}

}  // namespace

int main(int argc, char** argv) {
    return dsc::apps::run_main("large_steps_3d", [&] { return run(argc, argv); });
}
