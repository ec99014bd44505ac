// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/deformer.h"

#include <limits>

#include "core/errors.h"
#include "tests/dsc3d/deform/support.h"
#include "tests/dsc3d/volumes.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;
using motion::TopologyPolicy;

namespace {

using Targets = std::vector<std::optional<Point3>>;

constexpr std::array all_policies = {TopologyPolicy::adaptive, TopologyPolicy::preserved, TopologyPolicy::merge_only,
                                     TopologyPolicy::split_only};

double one_ball(const Point3& p) { return (p - Point3(0.5, 0.65, 0.5)).norm() - 0.2; }

double two_balls(const Point3& p) {
    return std::min((p - Point3(0.3, 0.5, 0.5)).norm(), (p - Point3(0.7, 0.5, 0.5)).norm()) - 0.14;
}

double dumbbell(const Point3& p) {
    const double neck = std::max(Point3(0, p.y() - 0.5, p.z() - 0.5).norm() - 0.1, std::abs(p.x() - 0.5) - 0.2);
    return std::min(neck, std::min((p - Point3(0.25, 0.5, 0.5)).norm(), (p - Point3(0.75, 0.5, 0.5)).norm()) - 0.17);
}

template <class Flow>
Targets targets_of(const Mesh& mesh, Flow&& flow) {
    Targets targets(mesh.complex().vertex_capacity());
    for (std::uint32_t i = 0; i < targets.size(); ++i) {
        const VertexId v(i);
        if (!mesh.complex().is_deleted(v) && mesh.complex().is_interface(v)) targets[i] = flow(mesh.position(v));
    }
    return targets;
}

/// Half of the label 1 becomes label 2: two regions that share a wall.
Mesh two_halves(double spacing) {
    Mesh mesh = box_with([](const Point3& p) { return (p - Point3(0.5, 0.5, 0.5)).norm() - 0.27; }, spacing);
    for (const TetId t : tets(mesh.complex())) {
        Point3 middle = Point3::Zero();
        for (const VertexId v : mesh.complex().vertices(t)) middle += mesh.position(v) / 4;
        if (mesh.complex().label(t) == 1 && middle.x() > 0.5) mesh.complex().set_label(t, 2);
    }
    return mesh;
}

void require_sum(const Mesh& mesh, double domain) {
    double sum = 0;
    for (const auto& [label, volume] : volumes(mesh)) {
        REQUIRE(volume > 0);
        sum += volume;
    }
    REQUIRE(sum == Approx(domain).epsilon(1e-12));
}

Point3 drive_together(const Point3& p) { return p + Point3(p.x() < 0.5 ? 0.02 : -0.02, 0, 0); }

/// Towards the axis, most at the neck.
Point3 pinch(const Point3& p) {
    const double strength = 0.012 * std::exp(-std::pow((p.x() - 0.5) / 0.08, 2));
    const Point3 off(0, p.y() - 0.5, p.z() - 0.5);
    const double radius = off.norm();
    return radius < 1e-9 ? p : Point3(p - off * (std::min(strength, radius) / radius));
}

std::vector<double> bits(const Mesh& mesh) {
    std::vector<double> all;
    const TetData data = mesh.data();
    for (const Point3& p : data.vertices) all.insert(all.end(), p.begin(), p.end());
    for (std::size_t i = 0; i < data.tets.size(); ++i) {
        all.insert(all.end(), data.tets[i].begin(), data.tets[i].end());
        all.push_back(data.label(i));
    }
    return all;
}

}  // namespace

TEST_CASE("a turning ball keeps its volume, and every vertex arrives") {
    Mesh mesh = box_with(one_ball, 0.12);
    Deformer deformer(mesh, {.edge_length = 0.1, .controls_interface = false});
    const auto triangles = interface_triangles(mesh.complex());
    const double volume = volume_of_label(mesh, 1);
    const Eigen::AngleAxisd turn(0.03, Point3::UnitZ());
    const Point3 pivot(0.5, 0.5, 0.5);
    for (int step = 0; step < 20; ++step) {
        const Targets targets = targets_of(mesh, [&](const Point3& p) { return Point3(pivot + turn * (p - pivot)); });
        const StepReport report = deformer.step(targets);
        REQUIRE(report.is_complete);
        REQUIRE(report.unfinished.empty());
        for (std::uint32_t i = 0; i < targets.size(); ++i)
            if (targets[i]) REQUIRE(mesh.position(VertexId(i)) == *targets[i]);
        REQUIRE(validate(mesh).empty());
    }
    CHECK(interface_triangles(mesh.complex()) == triangles);
    CHECK(volume_of_label(mesh, 1) == Approx(volume).epsilon(1e-12));
    CHECK(volume_of_label(mesh, 0) + volume_of_label(mesh, 1) == Approx(1).epsilon(1e-12));
}

TEST_CASE("a layer that ends on the walls slides along them, and is pulled off none") {
    Mesh mesh = slab(1, {0, 1, 0});
    Deformer deformer(mesh, {.edge_length = 1});
    const auto triangles = interface_triangles(mesh.complex());
    const double shift = 0.05;
    for (int step = 1; step <= 10; ++step) {
        // Into the walls and out of them too, which is no way to go.
        const auto at_wall = [&](double x) { return x == 0 || x == 6 ? 0.1 * (step % 2 == 0 ? x - 3 : 3 - x) : 0; };
        const Targets targets = targets_of(
            mesh, [&](const Point3& p) { return Point3(p + Point3(at_wall(p.x()), at_wall(p.y()), shift)); });
        deformer.step(targets);
        REQUIRE(validate(mesh).empty());
        for (const VertexId v : vertices(mesh.complex())) {
            if (!mesh.complex().is_interface(v)) continue;
            const double z = mesh.position(v).z();
            REQUIRE(std::min(std::abs(z - 1 - step * shift), std::abs(z - 2 - step * shift)) < 1e-12);
        }
    }
    CHECK(interface_triangles(mesh.complex()) == triangles);
    CHECK(volume_of_label(mesh, 1) == Approx(36).epsilon(1e-12));
    CHECK(volume_of_label(mesh, 0) == Approx(72).epsilon(1e-12));
}

class StopAt final : public Listener {
public:
    explicit StopAt(int substep) : substep_(substep) {}
    void on_substep(int substep, int) override {
        if (substep == substep_) throw core::Cancelled();
    }

private:
    int substep_;
};

TEST_CASE("a step that is ended between two substeps leaves a mesh from which others go on") {
    Mesh mesh = box_with(one_ball, 0.12);
    StopAt listener(2);
    Deformer deformer(mesh, {.edge_length = 0.05}, listener);
    const double volume = volume_of_label(mesh, 1);
    const auto aside = [](const Point3& p) { return Point3(p + Point3(0.15, 0, 0)); };
    CHECK_THROWS_AS(deformer.step(targets_of(mesh, aside)), core::Cancelled);
    REQUIRE(validate(mesh).empty());
    const StepReport report = deformer.step(targets_of(mesh, [](const Point3& p) { return p; }));
    CHECK(report.unfinished.empty());
    REQUIRE(validate(mesh).empty());
    CHECK(volume_of_label(mesh, 1) == Approx(volume).epsilon(1e-12));
}

TEST_CASE("a ball that goes once around is where it was, with its triangles, in good tetrahedra") {
    Mesh mesh = box_with(one_ball, 0.12);
    Deformer deformer(mesh, {.edge_length = 0.1, .controls_interface = false});
    deformer.improve_everywhere();
    const auto triangles = interface_triangles(mesh.complex());
    std::map<VertexId, Point3> start;
    for (const auto& [v, place] : places(mesh))
        if (mesh.complex().is_interface(v)) start[v] = place;
    const int steps = 24;
    const Point3 pivot(0.5, 0.5, 0.5);
    const auto turned = [&](const Point3& p, double share) {
        return Point3(pivot + Eigen::AngleAxisd(share * 2 * std::numbers::pi / steps, Point3::UnitZ()) * (p - pivot));
    };
    for (int step = 0; step < steps; ++step) {
        const Targets targets = targets_of(mesh, [&](const Point3& p) { return turned(p, 1); });
        const StepReport report = deformer.step(targets, turned);
        REQUIRE(report.unfinished.empty());
        REQUIRE(validate(mesh).empty());
        REQUIRE(min_dihedral(mesh) >= 10);
    }
    CHECK(interface_triangles(mesh.complex()) == triangles);
    for (const auto& [v, place] : start) CHECK((mesh.position(v) - place).norm() < 1e-13);
}

TEST_CASE("an interface that has no way to go stays as it is to the last bit, and a mesh without motion as a whole") {
    Mesh mesh = box_with(two_balls, 0.1);
    Deformer deformer(mesh, {.edge_length = 0.1});
    const std::vector<double> resting = bits(mesh);
    const StepReport report = deformer.step(targets_of(mesh, [](const Point3& p) { return p; }));
    CHECK(report.is_complete);
    CHECK(bits(mesh) == resting);
    const auto before = places(mesh);
    const auto triangles = interface_triangles(mesh.complex());
    const auto moved = [](const Point3& p) { return Point3(p + Point3(0, p.x() < 0.5 ? 0.03 : 0, 0)); };
    for (int step = 0; step < 4; ++step) {
        const auto targets = targets_of(mesh, moved);
        deformer.step(targets, [&](const Point3& p, double share) { return Point3(p + share * (moved(p) - p)); });
    }
    const auto after = places(mesh);
    CHECK(after != before);
    const auto now = interface_triangles(mesh.complex());
    std::size_t count = 0;
    for (const FaceVertices& triangle : triangles) {
        if (before.at(triangle[0]).x() < 0.5) continue;
        ++count;
        for (const VertexId v : triangle) CHECK(after.at(v) == before.at(v));
        CHECK(std::ranges::count(now, triangle) == 1);
    }
    CHECK(count > 0);
}

TEST_CASE("the substeps of a path lie on it") {
    // A turn by 90 degrees in one step: on the chords the ball would be squeezed to half its volume.
    Mesh mesh = box_with([](const Point3& p) { return (p - Point3(0.5, 0.5, 0.5)).norm() - 0.2; }, 0.15);
    Deformer deformer(mesh, {.edge_length = 0.12, .controls_interface = false});
    const double volume = volume_of_label(mesh, 1);
    const auto triangles = interface_triangles(mesh.complex());
    const Point3 pivot(0.5, 0.5, 0.5);
    double largest_share = 0;
    const auto turned = [&](const Point3& p, double share) {
        largest_share = std::max(largest_share, share);
        return Point3(pivot +
                      Eigen::AngleAxisd(share * std::numbers::pi / 2, Point3(1, 1, 1).normalized()) * (p - pivot));
    };
    const Targets targets = targets_of(mesh, [&](const Point3& p) { return turned(p, 1); });
    largest_share = 0;
    const StepReport report = deformer.step(targets, turned);
    CHECK(report.unfinished.empty());
    CHECK(report.substeps >= 4);
    CHECK((largest_share > 0.5 && largest_share < 1));  // the end is the target itself
    for (std::uint32_t i = 0; i < targets.size(); ++i)
        if (targets[i]) REQUIRE(mesh.position(VertexId(i)) == *targets[i]);
    CHECK(interface_triangles(mesh.complex()) == triangles);
    CHECK(volume_of_label(mesh, 1) == Approx(volume).epsilon(1e-12));
    require_valid(mesh);
}

TEST_CASE("a mesh that is too fine off the interface is coarsened at once, and the interface stays as it is") {
    Mesh mesh = box_with(one_ball, 0.07);
    const std::size_t before = mesh.complex().tet_count();
    const auto triangles = interface_triangles(mesh.complex());
    const auto start = places(mesh);
    Deformer deformer(mesh, {.edge_length = 0.06});
    const StepReport report = deformer.coarsen_everywhere();
    CHECK(report.counts.collapses > 0);
    CHECK(mesh.complex().tet_count() < before / 2);
    CHECK(interface_triangles(mesh.complex()) == triangles);
    for (const VertexId v : vertices(mesh.complex()))
        if (mesh.complex().is_interface(v)) CHECK(mesh.position(v) == start.at(v));
    CHECK(min_dihedral(mesh) > 10);
    require_valid(mesh);
    CHECK(deformer.coarsen_everywhere().counts.collapses < report.counts.collapses / 5);
}

TEST_CASE("balls that are driven into each other merge where the policy lets them", "[slow]") {
    for (const TopologyPolicy policy : {TopologyPolicy::adaptive, TopologyPolicy::merge_only}) {
        Mesh mesh = box_with(two_balls, 0.12);
        EventList list;
        Deformer deformer(mesh, {.edge_length = 0.1, .topology = policy}, list);
        REQUIRE(components_of_label(mesh.complex(), 1) == 2);
        std::size_t counted = 0;
        for (int step = 0; step < 8; ++step) {
            counted += deformer.step(targets_of(mesh, drive_together)).counts.topology_changes;
            REQUIRE(validate(mesh).empty());
            REQUIRE(pinches(mesh.complex()) == 0);
            require_sum(mesh, 1);
        }
        const LabelStatistics merged = statistics_by_label(mesh).at(1);
        CHECK(merged.components == 1);
        CHECK(merged.surfaces == 1);
        CHECK_FALSE(list.events.empty());
        CHECK(statistics_by_label(mesh).at(0).components == 1);
        CHECK(counted == list.events.size());
        for (const Event& event : list.events) {
            CHECK(event.kind == motion::EventKind::topology_change);
            CHECK(event.label == 0);
            CHECK((event.place - Point3(0.5, 0.5, 0.5)).norm() < 0.15);
        }
    }
}

TEST_CASE("balls that merge have one surface without handles, after one event") {
    Mesh mesh = box_with(two_balls, 0.12);
    EventList list;
    Deformer deformer(mesh, {.edge_length = 0.1}, list);
    for (int step = 0; step < 8; ++step) deformer.step(targets_of(mesh, drive_together));
    CHECK(statistics_by_label(mesh).at(1).genus == 0);
    CHECK(list.events.size() == 1);
}

TEST_CASE("balls that are driven into each other are stopped where they may not merge, and what is left is reported") {
    for (const TopologyPolicy policy : {TopologyPolicy::preserved, TopologyPolicy::split_only}) {
        Mesh mesh = box_with(two_balls, 0.15);
        Deformer deformer(mesh, {.edge_length = 0.12, .topology = policy});
        REQUIRE(components_of_label(mesh.complex(), 1) == 2);
        std::size_t stopped = 0, contacts = 0;
        for (int step = 0; step < 6; ++step) {
            const Targets targets = targets_of(mesh, drive_together);
            const StepReport report = deformer.step(targets);
            bool all_locked = true;
            for (const auto& unfinished : report.unfinished) all_locked = all_locked && unfinished.is_locked;
            CHECK(report.is_complete == all_locked);
            CHECK(report.counts.topology_changes == 0);
            for (const auto& contact : report.contacts) {
                CHECK(contact.label == 0);
                CHECK(std::abs(contact.place.x() - 0.5) < 0.1);
            }
            stopped += report.unfinished.size();
            contacts += report.contacts.size();
            REQUIRE(validate(mesh).empty());
            for (const int label : {0, 1}) {
                REQUIRE(statistics_by_label(mesh).at(label).components == (label == 1 ? 2 : 1));
                REQUIRE(statistics_by_label(mesh).at(label).genus == 0);
            }
            require_sum(mesh, 1);
        }
        CHECK(stopped > 0);
        CHECK(contacts > 0);
    }
}

TEST_CASE("what is left of a motion is the way from where the vertex stays to its target") {
    Mesh mesh = box_with(two_balls, 0.15);
    Deformer deformer(mesh, {.edge_length = 0.12, .topology = TopologyPolicy::preserved, .controls_interface = false});
    std::size_t stopped = 0;
    for (int step = 0; step < 4; ++step) {
        const Targets targets = targets_of(mesh, drive_together);
        const StepReport report = deformer.step(targets);
        std::set<VertexId> unfinished;
        for (const auto& left : report.unfinished) {
            REQUIRE(unfinished.insert(left.vertex).second);
            REQUIRE((mesh.position(left.vertex) + left.remaining - *targets[left.vertex.index()]).norm() < 1e-15);
        }
        for (std::uint32_t i = 0; i < targets.size(); ++i)
            if (targets[i])
                REQUIRE((unfinished.count(VertexId(i)) == 1) == (mesh.position(VertexId(i)) != *targets[i]));
        stopped += unfinished.size();
    }
    CHECK(stopped > 0);
}

TEST_CASE("balls that rest close to each other, or go together, never merge") {
    // Two blocks with a gap of 0.15 edges between them.
    TetData data = cubes_with({6, 6, 7}, [](const Point3& p) {
                       const bool is_in = p.x() > 2 && p.x() < 4 && p.y() > 2 && p.y() < 4;
                       return is_in && p.z() > 1 && p.z() < 6 && std::abs(p.z() - 3.5) > 0.1 ? 1 : 0;
                   }).data();
    for (Point3& p : data.vertices)
        if (p.z() >= 4) p.z() -= 0.85;
    const auto run = [&](const Point3& way, const Point3& way_of_upper) {
        Mesh mesh(data);
        EventList list;
        Deformer deformer(mesh, {.edge_length = 1}, list);
        for (int step = 0; step < 3; ++step) {
            deformer.step(
                targets_of(mesh, [&](const Point3& p) { return Point3(p + (p.z() > 3.07 ? way_of_upper : way)); }));
            require_valid(mesh);
        }
        CHECK(list.events.empty() == (components_of_label(mesh.complex(), 1) == 2));
        return list.events.size();
    };
    const Point3 rest(0, 0, 0), up(0, 0, 0.05), aside(0.05, 0.02, 0);
    CHECK(run(rest, rest) == 0);
    CHECK(run(aside, aside) == 0);
    CHECK(run(up, up) == 0);
    CHECK(run(-up, up) == 0);
    CHECK(run(rest, -up) > 0);
}

TEST_CASE("the neck of a dumbbell that is pinched splits where the policy lets it, and is held where not", "[slow]") {
    for (const TopologyPolicy policy : {TopologyPolicy::adaptive, TopologyPolicy::merge_only}) {
        Mesh mesh = box_with(dumbbell, 0.08);
        EventList list;
        Deformer deformer(mesh, {.edge_length = 0.07, .topology = policy}, list);
        REQUIRE(components_of_label(mesh.complex(), 1) == 1);
        const bool may_split = policy == TopologyPolicy::adaptive;
        for (int step = 0; step < (may_split ? 12 : 4); ++step) {
            deformer.step(targets_of(mesh, pinch));
            REQUIRE(validate(mesh).empty());
            REQUIRE(pinches(mesh.complex()) == 0);
            require_sum(mesh, 1);
        }
        CHECK(statistics_by_label(mesh).at(1).genus == 0);
        CHECK(components_of_label(mesh.complex(), 1) == (may_split ? 2 : 1));
        int splits = 0;
        for (const Event& event : list.events) {
            splits += event.label == 1 ? 1 : 0;
            CHECK((event.place - Point3(0.5, 0.5, 0.5)).norm() < 0.15);
        }
        CHECK((splits > 0) == may_split);
        CHECK(statistics_by_label(mesh).at(0).components == 1);
    }
}

TEST_CASE("two balls of different labels that are driven together touch, and stay two", "[slow]") {
    Mesh mesh = box_with(two_balls, 0.12);
    for (const TetId t : tets(mesh.complex()))
        if (mesh.complex().label(t) == 1 && mesh.position(mesh.complex().vertices(t)[0]).x() > 0.5)
            mesh.complex().set_label(t, 2);
    Deformer deformer(mesh, {.edge_length = 0.1, .topology = TopologyPolicy::merge_only});
    for (int step = 0; step < 8; ++step) {
        deformer.step(targets_of(mesh, drive_together));
        REQUIRE(validate(mesh).empty());
        REQUIRE(pinches(mesh.complex()) == 0);
        require_sum(mesh, 1);
        for (const int label : {0, 1, 2}) {
            REQUIRE(statistics_by_label(mesh).at(label).components == 1);
            REQUIRE(statistics_by_label(mesh).at(label).genus == 0);
        }
    }
    CHECK(surface_areas(mesh).count({1, 2}) == 1);
}

TEST_CASE("random motion leaves a valid mesh under every policy, and where it is preserved, the topology", "[slow]") {
    for (const int labels : {2, 3}) {
        for (const TopologyPolicy policy : all_policies) {
            Mesh mesh = labels == 2 ? box_with(two_balls, 0.15) : two_halves(0.2);
            Deformer deformer(mesh, {.edge_length = 0.17, .topology = policy});
            const auto before = statistics_by_label(mesh);
            const int pinches_before = pinches(mesh.complex());
            core::Random random(seed(1));
            for (int step = 0; step < 3; ++step) {
                const double reach = step == 2 ? 1 : 0.05;
                deformer.step(targets_of(mesh, [&](const Point3& p) {
                    const double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach),
                                 z = random.uniform(-reach, reach);
                    return Point3(p + Point3(x, y, z));
                }));
                REQUIRE(validate(mesh).empty());
                require_sum(mesh, 1);
                if (labels == 2) REQUIRE(pinches(mesh.complex()) <= pinches_before);
                if (policy != TopologyPolicy::preserved) continue;
                const auto now = statistics_by_label(mesh);
                REQUIRE(now.size() == before.size());
                for (const auto& [label, statistics] : before) {
                    REQUIRE(now.at(label).components == statistics.components);
                    REQUIRE(now.at(label).surfaces == statistics.surfaces);
                    REQUIRE(now.at(label).genus == statistics.genus);
                }
            }
        }
    }
}

TEST_CASE("the same input gives the same bits, also where parts meet") {
    const auto run = [] {
        Mesh mesh = box_with(two_balls, 0.15);
        Deformer deformer(mesh, {.edge_length = 0.12});
        core::Random random(seed(2));
        for (int step = 0; step < 6; ++step) {
            deformer.step(targets_of(mesh, [&](const Point3& p) {
                const double y = random.uniform(-0.02, 0.02);
                return Point3(drive_together(p) + Point3(0, y, 0));
            }));
        }
        return bits(mesh);
    };
    CHECK(run() == run());
}

TEST_CASE("improvement everywhere leaves good tetrahedra, and keeps what is where") {
    Mesh mesh = box_with(one_ball, 0.12);
    Deformer deformer(mesh, {.edge_length = 0.1});
    const double volume = volume_of_label(mesh, 1);
    deformer.improve_everywhere();
    require_valid(mesh);
    CHECK(min_dihedral(mesh) > 12);
    Mesh kept = box_with(one_ball, 0.12);
    const auto triangles = interface_triangles(kept.complex());
    Deformer(kept, {.edge_length = 0.1, .controls_interface = false}).improve_everywhere();
    CHECK(min_dihedral(kept) > 15);
    CHECK(interface_triangles(kept.complex()) == triangles);
    CHECK(volume_of_label(mesh, 1) == Approx(volume).epsilon(0.02));
    CHECK(statistics_by_label(mesh).at(1).genus == 0);
    CHECK(statistics_by_label(mesh).at(1).components == 1);
}

TEST_CASE("a step without targets changes nothing") {
    Mesh mesh = box_with(one_ball, 0.15);
    Deformer deformer(mesh, {.edge_length = 0.1});
    const auto before = bits(mesh);
    const StepReport report = deformer.step(Targets(mesh.complex().vertex_capacity()));
    CHECK(report.is_complete);
    CHECK(report.substeps == 0);
    CHECK(bits(mesh) == before);
}

TEST_CASE("a step says what is wrong with a target, and a deformer with a parameter") {
    Mesh mesh = box_with(one_ball, 0.2);
    CHECK_THROWS_AS(Deformer(mesh, {.edge_length = 0}), core::UsageError);
    CHECK_THROWS_AS(Deformer(mesh, {.edge_length = 0.1, .approach = 1}), core::UsageError);
    CHECK_THROWS_AS(Deformer(mesh, {.edge_length = 0.1, .growth = -1}), core::UsageError);
    Deformer deformer(mesh, {.edge_length = 0.1});
    for (std::uint32_t i = 0; i < mesh.complex().vertex_capacity(); ++i) {
        const VertexId v(i);
        Targets targets(mesh.complex().vertex_capacity());
        targets[i] = mesh.position(v);
        if (!mesh.complex().is_interface(v)) REQUIRE_THROWS_AS(deformer.step(targets), core::UsageError);
        targets[i]->x() = std::numeric_limits<double>::quiet_NaN();
        REQUIRE_THROWS_AS(deformer.step(targets), core::UsageError);
    }
    CHECK_THROWS_AS(deformer.step(Targets(mesh.complex().vertex_capacity() + 1)), core::UsageError);
    const auto start = places(mesh);
    CHECK_THROWS_AS(deformer.step(targets_of(mesh, [](const Point3& p) { return Point3(p + Point3(1e9, 0, 0)); })),
                    core::RunError);
    CHECK(places(mesh) == start);
    std::vector<std::optional<double>> lengths(mesh.complex().vertex_capacity(), 0.1);
    CHECK_NOTHROW(deformer.set_edge_lengths(lengths));
    std::fill(lengths.begin(), lengths.end(), -0.1);
    CHECK_THROWS_AS(deformer.set_edge_lengths(lengths), core::UsageError);
}
