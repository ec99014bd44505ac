// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/improve/improve.h"

#include <bit>
#include <limits>
#include <numbers>

#include "core/errors.h"
#include "dsc3d/improve/angle_range.h"
#include "dsc3d/improve/schedule.h"
#include "tests/dsc3d/samples.h"
#include "tests/dsc3d/support.h"
#include "tests/support/seed.h"

using namespace dsc::dsc3d;
using namespace dsc::tests;
using dsc::core::Random;
using dsc::geometry::QualityMeasure;

namespace {

TetData sample(std::uint32_t n, int labels, std::uint64_t with_seed) {
    Random random(with_seed);
    const Cells cells = {n, n, n};
    TetData data = box(cells);
    if (labels > 1) label_slabs(data, cells, labels);
    shake_inside(data, 0.45, random);
    turn(data);
    return data;
}

TetData shaken(TetData data, std::uint64_t with_seed) {
    Random random(seed(with_seed));
    shake_inside(data, 0.4, random);
    return data;
}

// An icosahedron with a centre and one more vertex inside, and its image in the plane of a face, which has none.
TetData twins(std::uint64_t with_seed) {
    TetData data = ball(0);
    Random random(with_seed);
    shake_all(data, 0.03, random);
    const std::vector<std::array<std::uint32_t, 4>> star = data.tets;  // [centre, a triangle of the surface]
    const auto& [centre, a, b, c] = star.front();
    const Point3 on_mirror = data.vertices[a];
    const Point3 normal = (data.vertices[b] - on_mirror).cross(data.vertices[c] - on_mirror).normalized();
    std::map<std::uint32_t, std::uint32_t> image = {{a, a}, {b, b}, {c, c}};
    for (std::uint32_t v = 0; v < centre; ++v) {
        if (!image.try_emplace(v, static_cast<std::uint32_t>(data.vertices.size())).second) continue;
        const Point3 p = data.vertices[v];
        data.vertices.push_back(p - 2 * normal.dot(p - on_mirror) * normal);
    }
    std::uint32_t tip = 0;
    while (tip == a || tip == b || tip == c) ++tip;
    for (const auto& [inside, x, y, z] : star)
        if (x != tip && y != tip && z != tip)
            data.tets.push_back({image.at(tip), image.at(x), image.at(z), image.at(y)});
    const auto split = data.tets[10];
    const auto middle = static_cast<std::uint32_t>(data.vertices.size());
    data.vertices.push_back(Point3::Zero());
    for (const std::uint32_t v : split) data.vertices.back() += 0.25 * data.vertices[v];
    for (std::size_t k = 0; k < 4; ++k) {
        auto part = split;
        part[k] = middle;
        (k == 0 ? data.tets[10] : data.tets.emplace_back()) = part;
    }
    return data;
}

// Corners and centres of n^3 cells; four tetrahedra around each segment between two centres, and no others: all alike.
TetData bcc_lattice(int n) {
    TetData data;
    std::map<std::array<int, 3>, std::uint32_t> numbers;
    const auto number = [&](const std::array<int, 3>& place) {
        const auto [entry, is_new] = numbers.try_emplace(place, static_cast<std::uint32_t>(data.vertices.size()));
        if (is_new) data.vertices.emplace_back(place[0], place[1], place[2]);
        return entry->second;
    };
    const auto add_around = [&](const std::array<int, 3>& centre, std::size_t axis) {
        std::array<int, 3> next = centre;
        next[axis] += 2;
        std::array<std::uint32_t, 4> ring;
        constexpr std::array<std::array<int, 2>, 4> turns = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
        for (std::size_t i = 0; i < 4; ++i) {
            std::array<int, 3> corner = centre;
            corner[axis] += 1;
            corner[(axis + 1) % 3] += turns[i][0];
            corner[(axis + 2) % 3] += turns[i][1];
            ring[i] = number(corner);
        }
        for (std::size_t i = 0; i < 4; ++i)
            data.tets.push_back({number(centre), number(next), ring[i], ring[(i + 1) % 4]});
    };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            for (int k = 0; k < n; ++k)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    if (std::array{i, j, k}[axis] + 1 < n) add_around({2 * i + 1, 2 * j + 1, 2 * k + 1}, axis);
    return data;
}

double worst_quality(const Mesh& mesh, QualityMeasure measure) {
    double worst = std::numeric_limits<double>::infinity();
    for (const TetId t : tets(mesh.complex())) {
        const TetVertices& v = mesh.complex().vertices(t);
        worst = std::min(worst, dsc::geometry::quality(measure, mesh.position(v[0]), mesh.position(v[1]),
                                                       mesh.position(v[2]), mesh.position(v[3])));
    }
    return worst;
}

// improve(), but with a small budget for the search of the schedule best, which takes half a minute by default.
ImproveReport improve_briefly(Mesh& mesh, const ImproveParameters& parameters, dsc::core::Observer& observer) {
    if (parameters.schedule == Schedule::thesis) return improve(mesh, parameters, observer);
    const StopCondition stop(observer, parameters.time_limit);
    ImproveRun run(mesh, parameters, observer, stop);
    if (run.goes_on("improving")) BestSchedule({.budget = 20'000}).run(run);
    return run.report;
}

// One run, with what is promised of every run.
struct Run {
    Mesh mesh;
    ImproveReport report;

    Run(const TetData& data, const ImproveParameters& parameters) : mesh(data) {
        const double before = worst_quality(mesh, parameters.measure);
        const auto volumes_before = volumes(mesh);
        const auto areas_before = surface_areas(mesh);
        dsc::core::Observer silent;
        report = improve_briefly(mesh, parameters, silent);
        require_valid(mesh);
        CHECK(worst_quality(mesh, parameters.measure) >= before - 1e-12);
        require_same(volumes_before, volumes(mesh), 1e-12);
        require_same(areas_before, surface_areas(mesh), 1e-12);
    }
    double worst(QualityMeasure measure) const { return worst_quality(mesh, measure); }
};

bool have_same_bits(const TetData& a, const TetData& b) {
    if (a.tets != b.tets || a.labels != b.labels || a.vertices.size() != b.vertices.size()) return false;
    for (std::size_t i = 0; i < a.vertices.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            if (std::bit_cast<std::uint64_t>(a.vertices[i][axis]) != std::bit_cast<std::uint64_t>(b.vertices[i][axis]))
                return false;
    return true;
}

// The triangles of the surface, by the places of their corners.
std::set<std::vector<std::array<double, 3>>> surface_triangles(const Mesh& mesh) {
    std::set<std::vector<std::array<double, 3>>> triangles;
    for (const FaceId f : faces(mesh.complex())) {
        if (!mesh.complex().is_surface(f)) continue;
        std::vector<std::array<double, 3>> corners;
        for (const VertexId v : mesh.complex().vertices(f))
            corners.push_back({mesh.position(v).x(), mesh.position(v).y(), mesh.position(v).z()});
        std::sort(corners.begin(), corners.end());
        triangles.insert(corners);
    }
    return triangles;
}

class CancelAfter final : public dsc::core::Observer {
public:
    explicit CancelAfter(int questions) : left_(questions) {}
    bool is_cancelled() const override { return left_ <= 0 || --left_ <= 0; }
    bool has_cancelled() const { return left_ <= 0; }

private:
    mutable int left_;
};

}  // namespace

TEST_CASE("improvement makes a shaken box much better, by every measure, and keeps its regions") {
    for (const int labels : {1, 2}) {
        const TetData data = sample(4, labels, seed(1));
        for (const QualityMeasure measure : quality_measures) {
            const Run run(data, {.measure = measure});
            INFO("measure " << static_cast<int>(measure) << ", labels " << labels);
            CHECK(run.report.end == ImproveEnd::converged);
            CHECK(run.report.rounds > 3);
            CHECK(run.report.smoothings > 0);
            CHECK(run.worst(measure) > 3 * worst_quality(Mesh(data), measure));
        }
    }
}

TEST_CASE("a mesh that is good is not thinned out at the cost of its worst tetrahedron") {
    TetData data = bcc_lattice(4);
    Random random(seed(7));
    for (Point3& p : data.vertices)
        for (int axis = 0; axis < 3; ++axis) p[axis] += random.uniform(-0.05, 0.05);
    for (const QualityMeasure measure : quality_measures) {
        const double before = worst_quality(Mesh(data), measure);
        CHECK(before > 0.6);
        CHECK(Run(data, {.measure = measure}).worst(measure) >= before);
    }
}

TEST_CASE("a surface stays within its tolerance, also where coordinates are coarser than that") {
    for (const double tolerance : {0.0, 1e-9}) {
        for (const double offset : {0.0, 0x1p26, 0x1p33, 0x1p40}) {
            // Its sides across z are oblique, and their vertices in one plane to the last bit.
            TetData data = shaken(box({4, 4, 4}), 6);
            for (Point3& p : data.vertices) {
                const Point3 on_grid = (64 * p).array().round();
                p = Point3(2 * on_grid.x() - on_grid.y() + offset, on_grid.x() + 2 * on_grid.y() + offset, on_grid.z());
            }
            Mesh mesh(data);
            dsc::core::Observer silent;
            improve(mesh, {.max_boundary_change = tolerance}, silent);
            require_valid(mesh);
            // In the box's coordinates, with an error that is far below the tolerance.
            const double side = 5 * 256, diagonal = std::sqrt(2.0) * side;
            for (const VertexId v : vertices(mesh.complex())) {
                if (!mesh.complex().is_surface(v)) continue;
                const Point3 p = mesh.position(v) - Point3(offset, offset, 0);
                double off = std::numeric_limits<double>::infinity();
                for (const double along : {2 * p.x() + p.y(), 2 * p.y() - p.x()})
                    off = std::min({off, std::abs(along) / std::sqrt(5), std::abs(along - side) / std::sqrt(5)});
                off = std::min({off, std::abs(p.z()), std::abs(p.z() - 256)});
                CHECK(off <= 0.5 * tolerance * diagonal + 1e-15 * diagonal);
            }
        }
    }
}

TEST_CASE("a mesh of any size is improved in the same way") {
    const TetData data = sample(3, 2, seed(8));
    for (const QualityMeasure measure : quality_measures) {
        const double at_one = Run(data, {.measure = measure}).worst(measure);
        for (const double unit : {0x1p-200, 0x1p-40, 0x1p40, 0x1p200}) {
            TetData scaled = data;
            for (Point3& p : scaled.vertices) p *= unit;
            Mesh mesh(scaled);
            dsc::core::Observer silent;
            improve(mesh, {.measure = measure}, silent);
            CHECK(validate(mesh).empty());
            CHECK(worst_quality(mesh, measure) == at_one);
        }
    }
}

TEST_CASE("one poor star in a mesh that is fine is improved, though it moves no mean") {
    Mesh mesh(sample(10, 1, seed(6)));
    constexpr auto measure = QualityMeasure::minimum_biased_sine;
    dsc::core::Observer silent;
    improve(mesh, {.uses_thinning = false}, silent);
    const double reached = worst_quality(mesh, measure);
    // The first vertex inside that can be moved until its star is poor, but not inverted.
    double poor = reached;
    for (const VertexId v : vertices(mesh.complex())) {
        if (mesh.complex().is_surface(v)) continue;
        const TetVertices& corners = mesh.complex().vertices(mesh.complex().tet(v));
        const Point3 before = mesh.position(v), there = mesh.position(corners[0] == v ? corners[1] : corners[0]);
        mesh.set_position(v, before + 0.8 * (there - before));
        poor = worst_quality(mesh, measure);
        if (poor > 0.01 && poor < 0.5 * reached) break;
        mesh.set_position(v, before);
    }
    REQUIRE(validate(mesh).empty());
    REQUIRE(poor < 0.5 * reached);
    improve(mesh, {.uses_thinning = false}, silent);
    require_valid(mesh);
    CHECK(worst_quality(mesh, measure) > 0.75 * reached);  // hill climbing may end on another hill
}

TEST_CASE("vertices keep their numbers through a run in spatial order, which is as good") {
    const TetData data = sample(5, 2, seed(7));
    const ImproveParameters parameters = {.keeps_vertices = true};
    const auto run = [&](Mesh& mesh, std::uint32_t many_vertices) {
        dsc::core::Attribute<VertexId, std::uint32_t> number(mesh.complex().vertex_attributes());
        for (const VertexId v : vertices(mesh.complex())) number[v] = v.index();
        dsc::core::Observer silent;
        const StopCondition stop(silent, {});
        ImproveRun improvement(mesh, parameters, silent, stop);
        ThesisSchedule({.many_vertices = many_vertices}).run(improvement);
        for (const VertexId v : vertices(mesh.complex())) REQUIRE(number[v] == v.index());
        require_valid(mesh);
    };
    Mesh mesh(data), other(data);
    run(mesh, 1);
    run(other, 1'000'000);
    REQUIRE(mesh.complex().vertex_capacity() == data.vertices.size());
    for (const VertexId v : vertices(mesh.complex())) {
        // A vertex of the surface stays on it, and none gets further than to the other side of its star.
        REQUIRE(mesh.complex().is_boundary(v) == other.complex().is_boundary(v));
        REQUIRE(mesh.complex().is_interface(v) == other.complex().is_interface(v));
        REQUIRE((mesh.position(v) - data.vertices[v.index()]).norm() < 1.5);  // spacing is 1
    }
    CHECK(worst_quality(mesh, parameters.measure) > 0.7 * worst_quality(other, parameters.measure));
}

TEST_CASE("what is switched off is not done") {
    const TetData data = sample(4, 2, seed(2));
    const Mesh input(data);
    SECTION("retriangulation") {
        const Run run(data, {.uses_multi_face_retriangulation = false});
        CHECK(run.report.multi_face_retriangulations == 0);
    }
    SECTION("thinning") {
        const Run run(data, {.uses_thinning = false});
        CHECK(run.report.collapses == 0);
        CHECK(run.mesh.complex().vertex_count() == input.complex().vertex_count());
    }
    SECTION("removal of vertices") {
        for (const Schedule schedule : {Schedule::thesis, Schedule::best}) {
            const Run run(sample(2, 1, seed(2)), {.schedule = schedule, .keeps_vertices = true});
            CHECK(run.report.collapses == 0);
            CHECK(run.mesh.complex().vertex_count() == 27);
            CHECK(run.mesh.complex().vertex_capacity() == 27);  // with their handles
        }
    }
    SECTION("changes of the surface") {
        const Run run(data, {.changes_boundary = false});
        CHECK(surface_triangles(run.mesh) == surface_triangles(input));
        CHECK(surface_triangles(Run(data, {}).mesh) != surface_triangles(input));
    }
}

TEST_CASE("a vertex comes from elsewhere to where a mesh has none, unless all have to stay") {
    constexpr auto measure = QualityMeasure::minimum_biased_sine;
    for (int trial = 0; trial < 3; ++trial) {
        const TetData data = twins(seed(9) + static_cast<std::uint64_t>(trial));
        const auto run = [&](bool keeps_vertices) {
            return Run(data, {.schedule = Schedule::best,
                              .uses_thinning = false,
                              .keeps_vertices = keeps_vertices,
                              .changes_boundary = false});
        };
        const Run stays = run(true), comes = run(false);
        CHECK(comes.mesh.complex().vertex_count() == data.vertices.size());
        CHECK(surface_triangles(comes.mesh) == surface_triangles(Mesh(data)));
        CHECK(stays.worst(measure) < 0.6);
        CHECK(comes.worst(measure) > 0.85);  // a star around a centre in each
    }
}

TEST_CASE("the same input gives the same bits, whatever the number of threads") {
    for (const Schedule schedule : {Schedule::thesis, Schedule::best}) {
        const TetData data = sample(schedule == Schedule::thesis ? 5 : 2, 1, seed(3));
        ImproveParameters parameters = {.schedule = schedule, .threads = 1};
        const TetData first = Run(data, parameters).mesh.data();
        const TetData again = Run(data, parameters).mesh.data();
        parameters.threads = 2;
        const TetData parallel = Run(data, parameters).mesh.data();
        CHECK(have_same_bits(first, again));
        CHECK(have_same_bits(first, parallel));
        CHECK_FALSE(have_same_bits(first, data));
    }
}

TEST_CASE("the schedule best is at least as good as the thesis's") {
    const TetData data = sample(2, 1, seed(4));
    for (const QualityMeasure measure : {QualityMeasure::minimum_sine, QualityMeasure::volume_length}) {
        const Run thesis(data, {.measure = measure});
        const Run best(data, {.measure = measure, .schedule = Schedule::best});
        CHECK(best.worst(measure) >= thesis.worst(measure) - 1e-9);
    }
}

TEST_CASE("improvement stops as soon as the target angle is reached") {
    const TetData data = sample(4, 1, seed(6));
    const AngleRange at_first{Mesh(data)};
    const double reachable = 8 * std::numbers::pi / 180;
    REQUIRE(at_first.min < reachable);
    const Run all(data, {});
    REQUIRE(AngleRange(all.mesh).min > reachable);
    const Run early(data, {.target_angle = 8});
    CHECK(early.report.end == ImproveEnd::reached_target_angle);
    CHECK(AngleRange(early.mesh).min >= reachable);
    CHECK(AngleRange(early.mesh).max <= std::numbers::pi - reachable);
    CHECK(early.report.smoothings < all.report.smoothings);

    const double have = std::min(at_first.min, std::numbers::pi - at_first.max) * 180 / std::numbers::pi;
    const Run at_once(data, {.target_angle = 0.5 * have});
    CHECK(at_once.report.end == ImproveEnd::reached_target_angle);
    CHECK(have_same_bits(at_once.mesh.data(), Mesh(data).data()));
}

TEST_CASE("a run that is cancelled, whenever, leaves a valid mesh that is no worse") {
    const TetData data = sample(3, 2, seed(7));
    for (const Schedule schedule : {Schedule::thesis, Schedule::best}) {
        for (const int questions : {1, 2, 5, 12, 30}) {
            Mesh mesh(data);
            const double before = worst_quality(mesh, QualityMeasure::minimum_biased_sine);
            const auto volumes_before = volumes(mesh);
            CancelAfter observer(questions);
            const ImproveReport report = improve_briefly(mesh, {.schedule = schedule}, observer);
            require_valid(mesh);
            require_same(volumes_before, volumes(mesh), 1e-12);
            CHECK(worst_quality(mesh, QualityMeasure::minimum_biased_sine) >= before - 1e-12);
            CHECK(report.end == (observer.has_cancelled() ? ImproveEnd::cancelled : ImproveEnd::converged));
            if (questions <= 5) CHECK(observer.has_cancelled());
        }
    }
}

TEST_CASE("a run that is out of time says so") {
    const TetData data = sample(6, 1, seed(8));
    for (const Schedule schedule : {Schedule::thesis, Schedule::best})
        CHECK(Run(data, {.schedule = schedule, .time_limit = 1e-3}).report.end == ImproveEnd::reached_time_limit);
}

TEST_CASE("parameters out of range are refused by name") {
    const auto complaint = [](const ImproveParameters& parameters) -> std::string {
        try {
            parameters.validate();
        } catch (const dsc::core::UsageError& error) {
            return error.what();
        }
        return "";
    };
    CHECK(complaint({}).empty());
    const auto names = [&](const char* field, const ImproveParameters& parameters) {
        return complaint(parameters).find(field) != std::string::npos;
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {-1e-9, 0.02, nan}) CHECK(names("max_boundary_change", {.max_boundary_change = bad}));
    for (const double bad : {0.0, 181.0, nan}) CHECK(names("feature_angle", {.feature_angle = bad}));
    for (const double bad : {0.0, -1.0, nan}) CHECK(names("time_limit", {.time_limit = bad}));
    for (const double bad : {0.0, 71.0, nan}) CHECK(names("target_angle", {.target_angle = bad}));
    CHECK(names("threads", {.threads = -1}));
    Mesh mesh(box({1, 1, 1}));
    dsc::core::Observer silent;
    CHECK_THROWS_AS(improve(mesh, {.feature_angle = 0}, silent), dsc::core::UsageError);
}
