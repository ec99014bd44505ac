// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/null_space_smoothing.h"

#include <catch2/catch.hpp>

#include "core/errors.h"
#include "surface/triangle.h"
#include "surface/vertex_rings.h"
#include "tests/geometry/surfaces.h"
#include "tests/support/seed.h"
#include "tests/surface/rings.h"

using namespace dsc;
using namespace dsc::surface;

namespace {

constexpr SmoothingParameters always{.good_angle = 60};

Vector3 displacement(const OneRing& ring, const SmoothingParameters& parameters = {}) {
    const VertexQuadric quadric = vertex_quadric(ring);
    const VertexFeature feature = vertex_feature(ring, quadric, parameters.feature_angle);
    return null_space_displacement(ring, quadric, feature, parameters);
}

/// A cube of n^2 squares a face, edge length 1.
geometry::SurfaceData fine_cube(int n) {
    geometry::SurfaceData cube;
    std::map<std::array<int, 3>, std::uint32_t> numbers;
    const auto vertex = [&](const std::array<int, 3>& place) {
        const auto [entry, is_new] = numbers.try_emplace(place, static_cast<std::uint32_t>(cube.vertices.size()));
        if (is_new) cube.vertices.push_back(Point3(place[0], place[1], place[2]) / n);
        return entry->second;
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (int side = 0; side < 2; ++side) {
            for (int i = 0; i < n; ++i) {
                for (int j = 0; j < n; ++j) {
                    const auto at = [&](int di, int dj) {
                        std::array<int, 3> place{};
                        place[axis] = side * n, place[(axis + 1) % 3] = i + di, place[(axis + 2) % 3] = j + dj;
                        return vertex(place);
                    };
                    const std::uint32_t a = at(0, 0), b = at(1, 0), c = at(1, 1), d = at(0, 1);
                    if (side == 1) {
                        cube.triangles.insert(cube.triangles.end(), {{a, b, c}, {a, c, d}});
                    } else {
                        cube.triangles.insert(cube.triangles.end(), {{a, c, b}, {a, d, c}});
                    }
                }
            }
        }
    }
    return cube;
}

}  // namespace

TEST_CASE("corners stay, vertices of a ridge slide along it, flat ones in their plane") {
    core::Random random(tests::seed(1));
    double largest = 0;
    for (int i = 0; i < 200; ++i) {
        CHECK(displacement(tests::cube_corner(random).view()).isZero(0));

        const Vector3 on_ridge = displacement(tests::ridge(random, random.uniform(0.8, 3)).view());
        CHECK(on_ridge.head<2>().norm() < 1e-15);
        largest = std::max(largest, std::abs(on_ridge.z()));

        const Vector3 in_plane = displacement(tests::flat(random).view());
        CHECK(std::abs(in_plane.y()) < 1e-16);
        largest = std::max(largest, in_plane.norm());
    }
    CHECK(largest > 0.1);  // flatness leaves all freedom
}

TEST_CASE("smoothing a fine cube keeps its shape and raises its angles") {
    geometry::SurfaceData cube = fine_cube(6);
    core::Random random(tests::seed(2));
    // Every vertex is moved at random where it can be moved, by less than would turn a triangle over.
    for (Point3& p : cube.vertices) {
        for (double& x : p) {
            if (x > 0.01 && x < 0.99) x += random.uniform(-0.04, 0.04);
        }
    }
    const geometry::SurfaceData start = cube;
    const VertexRings rings(cube);
    std::vector<RingTriangle> buffer;
    const auto worst = [&] {
        double least = 4;
        for (const auto& [a, b, c] : cube.triangles) {
            least = std::min(least, min_angle(cube.vertices[a], cube.vertices[b], cube.vertices[c]));
        }
        return least;
    };
    const double before = worst();
    for (int sweep = 0; sweep < 10; ++sweep) {
        for (std::uint32_t v = 0; v < cube.vertices.size(); ++v) {
            if (const auto place = smoothed_position(rings.ring(v, buffer), always)) cube.vertices[v] = *place;
        }
    }
    CHECK(worst() > before);
    CHECK(worst() > radians(30));
    CHECK(std::abs(tests::volume(cube) - 1) < 1e-14);
    for (std::size_t v = 0; v < cube.vertices.size(); ++v) {
        for (int k = 0; k < 3; ++k) {
            if (start.vertices[v][k] == 0) REQUIRE(std::abs(cube.vertices[v][k]) < 1e-15);
            if (start.vertices[v][k] == 1) REQUIRE(std::abs(cube.vertices[v][k] - 1) < 1e-15);
        }
    }
}

TEST_CASE("smoothing a ball keeps its volume, and its shape within the freedom") {
    geometry::SurfaceData ball = tests::icosphere(3);
    core::Random random(tests::seed(3));
    for (Point3& p : ball.vertices) {
        p += 0.05 * Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        p.normalize();
    }
    const VertexRings rings(ball);
    std::vector<RingTriangle> buffer;
    const double before = tests::volume(ball);
    std::size_t moves = 0;
    for (std::uint32_t v = 0; v < ball.vertices.size(); ++v) {
        if (const auto place = smoothed_position(rings.ring(v, buffer), always)) {
            ball.vertices[v] = *place;
            ++moves;
        }
    }
    CHECK(moves > 100);
    CHECK(tests::volume(ball) == Approx(before).epsilon(1e-14));
    // Edges are shorter than 0.3; the old triangles themselves lie below the sphere by up to an eighth of their square.
    for (const Point3& p : ball.vertices) CHECK(std::abs(p.norm() - 1) < 0.02 * 0.3 + 0.3 * 0.3 / 8);
}

TEST_CASE("without freedom a curved ring stays, and a good ring stays anyway") {
    const geometry::SurfaceData ball = tests::icosphere(2);
    const VertexRings rings(ball);
    std::vector<RingTriangle> buffer;
    for (std::uint32_t v = 0; v < ball.vertices.size(); ++v) {
        const OneRing ring = rings.ring(v, buffer);
        CHECK_FALSE(smoothed_position(ring, {}).has_value());
        const OneRing moved{ring.centre + Vector3(0.03, -0.02, 0.04), ring.triangles};
        CHECK(displacement(moved, {.freedom = 0}).norm() < 1e-15);
    }
}

TEST_CASE("the surface moves by no more than the freedom") {
    core::Random random(tests::seed(4));
    int limited = 0;
    for (int i = 0; i < 300; ++i) {
        const double bend = random.uniform(0.05, 0.4);  // below the feature angle
        const tests::OwnedRing ring = tests::ridge(random, bend);
        const Vector3 step = displacement(ring.view());
        double edges = 0;
        for (const RingTriangle& t : ring.triangles) edges += (t.a.norm() + t.b.norm()) / 2;
        const double limit = 0.02 * edges / static_cast<double>(ring.triangles.size());
        // Height over the two half-planes.
        const double height = step.y() + std::abs(step.x()) * std::tan(bend / 2);
        CHECK(std::abs(height) * std::cos(bend / 2) <= limit * (1 + 1e-9));
        limited += std::abs(height) * std::cos(bend / 2) > limit * (1 - 1e-9);
    }
    CHECK(limited > 10);
}

TEST_CASE("smoothing parameters out of their range are refused by name") {
    CHECK_THROWS_WITH(SmoothingParameters{.feature_angle = 0}.validate(), Catch::StartsWith("feature_angle"));
    CHECK_THROWS_WITH(SmoothingParameters{.freedom = -1}.validate(), Catch::StartsWith("freedom"));
    CHECK_THROWS_AS(SmoothingParameters{.good_angle = 61}.validate(), core::UsageError);
    CHECK_NOTHROW(SmoothingParameters{}.validate());
}
