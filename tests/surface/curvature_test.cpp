// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/curvature.h"

#include <catch2/catch.hpp>

#include "surface/vertex_rings.h"
#include "tests/geometry/surfaces.h"
#include "tests/support/seed.h"
#include "tests/surface/rings.h"

using namespace dsc;
using namespace dsc::surface;

namespace {

struct Errors {
    double speed = 0;
    double direction = 0;
    double gaussian = 0;
};

Errors errors_on_sphere(int levels, double radius) {
    geometry::SurfaceData sphere = tests::icosphere(levels);
    for (Point3& p : sphere.vertices) p *= radius;
    const VertexRings rings(sphere);
    std::vector<RingTriangle> buffer;
    Errors errors;
    for (std::uint32_t v = 0; v < sphere.vertices.size(); ++v) {
        const Curvature c = curvature(rings.ring(v, buffer));
        const Vector3 exact = -2 / radius * sphere.vertices[v].normalized();
        errors.speed = std::max(errors.speed, std::abs(c.vector.norm() * radius / 2 - 1));
        errors.direction = std::max(errors.direction, (c.vector.normalized() - exact.normalized()).norm());
        errors.gaussian = std::max(errors.gaussian, std::abs(c.gaussian * radius * radius - 1));
    }
    return errors;
}

/// A regular triangulation of a cylinder about the z axis, `n` vertices around.
geometry::SurfaceData cylinder(std::uint32_t n, double radius) {
    const double turn = 2 * std::numbers::pi / n;
    return tests::strip(n, 6, [&](std::uint32_t i, std::uint32_t j) {
        return Point3(radius * std::cos(turn * i), radius * std::sin(turn * i), -radius * turn * j);
    });
}

}  // namespace

TEST_CASE("a sphere moves inwards with the speed 2 / r") {
    const Errors coarse = errors_on_sphere(2, 0.3), fine = errors_on_sphere(3, 0.3), finest = errors_on_sphere(4, 0.3);
    CHECK(fine.speed < 0.01);
    // The mixed area is that of the sphere to second order for regular vertices; the twelve of valence 5 keep an error.
    CHECK(finest.speed < 0.0075);
    CHECK(fine.direction < 0.02);
    CHECK(finest.direction < 0.6 * fine.direction);
    CHECK(fine.direction < 0.6 * coarse.direction);
    CHECK(finest.gaussian < 0.015);
}

TEST_CASE("the total curvatures of a sphere converge with second order, and its defects add up to 4 pi") {
    std::array<double, 3> errors{};
    for (int level = 2; level < 5; ++level) {
        const geometry::SurfaceData sphere = tests::icosphere(level);
        const VertexRings rings(sphere);
        std::vector<RingTriangle> buffer;
        double mean = 0, gaussian = 0;
        for (std::uint32_t v = 0; v < sphere.vertices.size(); ++v) {
            const Curvature c = curvature(rings.ring(v, buffer));
            mean += c.vector.norm() * c.area;
            gaussian += c.gaussian * c.area;
        }
        CHECK(gaussian == Approx(4 * std::numbers::pi).epsilon(1e-12));
        errors[static_cast<std::size_t>(level - 2)] = std::abs(mean - 8 * std::numbers::pi);
    }
    CHECK(errors[0] / errors[1] == Approx(4).epsilon(0.05));
    CHECK(errors[1] / errors[2] == Approx(4).epsilon(0.05));
}

TEST_CASE("a regular cylinder moves inwards with the speed 1 / r exactly, and has no Gaussian curvature") {
    for (const std::uint32_t n : {7u, 20u, 40u}) {
        const geometry::SurfaceData surface = cylinder(n, 0.5);
        const VertexRings rings(surface);
        std::vector<RingTriangle> buffer;
        const std::uint32_t inner = 7 * 5 + 3;
        const Curvature c = curvature(rings.ring(inner, buffer));
        const Point3 p = surface.vertices[inner];
        CHECK((c.vector + 2 * Vector3(p.x(), p.y(), 0).normalized()).norm() < 1e-12);
        CHECK(std::abs(c.gaussian) < 1e-10);
        CHECK(c.mean() == Approx(1));
        CHECK(c.max_principal() == Approx(2));
    }
}

TEST_CASE("a plane has no curvature, however it is triangulated") {
    core::Random random(tests::seed(1));
    for (int i = 0; i < 100; ++i) {
        tests::OwnedRing ring = tests::flat(random);
        ring.transform(tests::random_placement(random));
        const Curvature c = curvature(ring.view());
        CHECK(c.vector.norm() < 1e-11 * c.stiffness);
        CHECK(std::abs(c.gaussian * c.area) < 1e-12);
    }
}

TEST_CASE("the curvature is minus the gradient of the area") {
    core::Random random(tests::seed(2));
    for (int i = 0; i < 100; ++i) {
        tests::OwnedRing ring = i % 2 == 0 ? tests::cube_corner(random) : tests::ridge(random, random.uniform(-2, 2));
        if (i % 3 == 0) ring.triangles.pop_back();  // a boundary
        const auto area = [&](const Point3& centre) {
            double sum = 0;
            for (const RingTriangle& t : ring.triangles) sum += 0.5 * (t.a - centre).cross(t.b - centre).norm();
            return sum;
        };
        const Curvature c = curvature(ring.view());
        for (int k = 0; k < 3; ++k) {
            const Vector3 h = 1e-5 * Vector3::Unit(k);
            const double gradient = (area(ring.centre + h) - area(ring.centre - h)) / 2e-5;
            CHECK(c.vector[k] * c.area == Approx(-gradient).margin(1e-7));
        }
    }
}

TEST_CASE("mixed areas cover the surface once") {
    const geometry::SurfaceData torus = tests::torus(24, 0.2);  // has obtuse triangles
    const VertexRings rings(torus);
    std::vector<RingTriangle> buffer;
    double mixed = 0, area = 0;
    for (std::uint32_t v = 0; v < torus.vertices.size(); ++v) mixed += curvature(rings.ring(v, buffer)).area;
    for (const auto& [a, b, c] : torus.triangles) {
        const Point3 &p = torus.vertices[a], &q = torus.vertices[b], &r = torus.vertices[c];
        area += 0.5 * (q - p).cross(r - p).norm();
    }
    CHECK(mixed == Approx(area).epsilon(1e-12));
}

TEST_CASE("explicit steps are stable below the bound of the stiffness") {
    geometry::SurfaceData sphere = tests::icosphere(2);
    core::Random random(tests::seed(3));
    for (Point3& p : sphere.vertices) p *= random.uniform(0.98, 1.02);
    const VertexRings rings(sphere);
    std::vector<RingTriangle> buffer;
    const auto roughness = [&] {
        double least = 2, largest = 0;
        for (const Point3& p : sphere.vertices) {
            least = std::min(least, p.norm());
            largest = std::max(largest, p.norm());
        }
        return largest - least;
    };
    const double before = roughness();
    for (int step = 0; step < 20; ++step) {
        std::vector<Vector3> velocity;
        double stiffness = 0;
        for (std::uint32_t v = 0; v < sphere.vertices.size(); ++v) {
            const Curvature c = curvature(rings.ring(v, buffer));
            velocity.push_back(c.vector);
            stiffness = std::max(stiffness, c.stiffness);
        }
        for (std::size_t v = 0; v < velocity.size(); ++v) sphere.vertices[v] += 0.9 / stiffness * velocity[v];
    }
    CHECK(roughness() < 0.3 * before);
}

TEST_CASE("a ring without area has no curvature") {
    CHECK(curvature({Point3(1, 2, 3), {}}).vector.isZero(0));
    const std::array<RingTriangle, 1> line{{{Point3(1, 0, 0), Point3(2, 0, 0)}}};
    const Curvature c = curvature({Point3::Zero(), line});
    CHECK(c.vector.isZero(0));
    CHECK(c.area == 0);
}
