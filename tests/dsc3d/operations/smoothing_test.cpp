// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/smoothing.h"

#include "tests/dsc3d/samples.h"
#include "tests/dsc3d/support.h"
#include "tests/support/seed.h"

using namespace dsc::dsc3d;
using namespace dsc::tests;
using dsc::core::Random;
using dsc::geometry::QualityMeasure;
using Eigen::Vector3d;

namespace {

// The worst quality of the star of v with v at x.
double quality_at(const RatedMesh& mesh, VertexId v, std::span<const TetId> star, const Point3& x) {
    double worst = std::numeric_limits<double>::infinity();
    for (const TetId t : star) {
        std::array<Point3, 4> p;
        for (std::size_t i = 0; i < 4; ++i) {
            const VertexId u = mesh.complex().vertices(t)[i];
            p[i] = u == v ? x : mesh.position(u);
        }
        worst = std::min(worst, dsc::geometry::quality(mesh.measure(), p[0], p[1], p[2], p[3]));
    }
    return worst;
}

// The directions in which v may move.
std::vector<Vector3d> directions(const RatedMesh& mesh, VertexId v) {
    std::vector<Vector3d> basis;
    for (int axis = 0; axis < 3; ++axis) {
        Vector3d d = mesh.surface().allowed(v, Vector3d::Unit(axis));
        for (const Vector3d& b : basis) d -= b.dot(d) * b;
        if (d.norm() > 0.1) basis.push_back(d.normalized());
    }
    return basis;
}

// The best of the grid around `middle` with `steps` points to either side, then of ever finer ones around the best.
double best_of_grids(const RatedMesh& mesh, VertexId v, std::span<const TetId> star, Point3 middle, double reach) {
    const std::vector<Vector3d> basis = directions(mesh, v);
    const int steps = basis.size() == 3 ? 6 : 30;
    double best = quality_at(mesh, v, star, middle);
    for (int level = 0; level < 5; ++level, reach /= 3) {
        const Point3 centre = middle;
        const auto try_at = [&](const Point3& x) {
            const double quality = quality_at(mesh, v, star, x);
            if (quality > best) best = quality, middle = x;
        };
        const int second = basis.size() > 1 ? steps : 0, third = basis.size() > 2 ? steps : 0;
        for (int i = -steps; i <= steps; ++i) {
            for (int j = -second; j <= second; ++j) {
                for (int k = -third; k <= third; ++k) {
                    Point3 x = centre + reach * i / steps * basis[0];
                    if (second != 0) x += reach * j / steps * basis[1];
                    if (third != 0) x += reach * k / steps * basis[2];
                    try_at(x);
                }
            }
        }
    }
    return best;
}

// A box of which every vertex that may is moved: inside at random, on the surface along it.
TetData shaken_box(double reach, Random& random) {
    TetData data = box({2, 2, 2});
    for (std::size_t v = 0; v < data.vertices.size(); ++v) {
        const Point3 before = data.vertices[v];
        for (double& x : data.vertices[v])
            if (x == 1) x += random.uniform(-reach, reach);
        for (std::size_t t = 0; t < data.tets.size(); ++t)
            if (!is_positive(data, t)) data.vertices[v] = before;
    }
    return data;
}

}  // namespace

TEST_CASE("smoothing finds places as good as those of a fine grid around them, and nearly always of the whole star",
          "[slow]") {
    // Fine gains, and as many steps as that takes, so that the place is what is judged and not the patience.
    const SmoothingParameters patient = {.max_steps = 200, .least_gain = 1e-5};
    std::map<VertexMotion, int> count;
    int good = 0, all = 0;
    for (const QualityMeasure measure : quality_measures) {
        Random random(seed(1));
        for (int trial = 0; trial < 8; ++trial) {
            TetData data = shaken_box(0.4, random);
            if (trial % 2 == 1) turn(data);
            Mesh mesh(data);
            RatedMesh rated(mesh, measure, {});
            for (const VertexId v : vertices(mesh.complex())) {
                const VertexMotion motion = rated.surface().motion(v);
                if (motion == VertexMotion::fixed) continue;
                const auto walked = rated.walker().star(v);
                const std::vector<TetId> star(walked.begin(), walked.end());
                if (rated.worst_quality(star) < 0.02) continue;
                double found = 0;
                const Point3 place = Smoothing(patient).best_place(rated, v, star, &found);
                REQUIRE(found == Approx(quality_at(rated, v, star, place)).epsilon(1e-9));
                const double best = best_of_grids(rated, v, star, mesh.position(v), 0.9);
                INFO("measure " << static_cast<int>(measure) << ", trial " << trial << ", vertex " << v.index()
                                << ", from " << rated.worst_quality(star));
                REQUIRE(found >= 0.995 * best_of_grids(rated, v, star, place, 0.03));
                good += found >= 0.99 * best ? 1 : 0;
                ++count[motion], ++all;
            }
        }
    }
    for (const VertexMotion motion : {VertexMotion::free, VertexMotion::plane, VertexMotion::line})
        CHECK(count[motion] > 20);
    // The worst quality of a star can have several local maxima: now and then a better one is behind a valley.
    CHECK(good > 0.95 * all);
}

TEST_CASE("smoothing never makes a star worse, moves the surface along itself, and leaves fixed vertices alone") {
    for (const QualityMeasure measure : quality_measures) {
        Random random(seed(2));
        for (int trial = 0; trial < 20; ++trial) {
            TetData data = shaken_box(0.45, random);
            turn(data);
            Mesh mesh(data);
            RatedMesh rated(mesh, measure, {});
            const auto volumes_before = volumes(mesh);
            const auto areas_before = surface_areas(mesh);
            Smoothing smoothing;
            int moved = 0;
            for (const VertexId v : vertices(mesh.complex())) {
                const auto walked = rated.walker().star(v);
                const std::vector<TetId> star(walked.begin(), walked.end());
                const double before = rated.worst_quality(star);
                const Point3 place = mesh.position(v);
                const bool is_moved = smoothing.smooth(rated, v);
                moved += is_moved ? 1 : 0;
                REQUIRE(is_moved == (mesh.position(v) != place));
                if (is_moved) REQUIRE(rated.worst_quality(star) > before);
                if (!is_moved) REQUIRE(rated.worst_quality(star) == before);
                if (rated.surface().motion(v) == VertexMotion::fixed) REQUIRE_FALSE(is_moved);
                for (const TetId t : star) REQUIRE(rated.quality(t) == rated.rate(mesh.complex().vertices(t)));
            }
            CHECK(moved > 5);
            require_valid(mesh);
            require_same(volumes_before, volumes(mesh), 1e-14);
            require_same(areas_before, surface_areas(mesh), 1e-14);
        }
    }
}

TEST_CASE("a vertex in the best place stays there") {
    // The middle of an icosahedron.
    for (const QualityMeasure measure : quality_measures) {
        Mesh mesh(ball(0));
        RatedMesh rated(mesh, measure, {});
        CHECK_FALSE(Smoothing().smooth(rated, VertexId(12)));
        mesh.set_position(VertexId(12), Point3(0.3, -0.2, 0.25));
        RatedMesh displaced(mesh, measure, {});
        const SmoothingParameters patient = {.max_steps = 200, .least_gain = 1e-6};
        Smoothing smoothing(patient);
        while (smoothing.smooth(displaced, VertexId(12))) continue;
        CHECK(mesh.position(VertexId(12)).norm() < 1e-2);
    }
}
