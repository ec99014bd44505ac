// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/implicit_curvature.h"

#include <catch2/catch.hpp>

#include "surface/curvature.h"
#include "surface/vertex_rings.h"
#include "tests/geometry/surfaces.h"

using namespace dsc;
using namespace dsc::surface;

namespace {

double mean_radius(const std::vector<Point3>& vertices) {
    double sum = 0;
    for (const Point3& p : vertices) sum += p.norm();
    return sum / static_cast<double>(vertices.size());
}

double radius_after(geometry::SurfaceData sphere, double time, int steps) {
    for (int i = 0; i < steps; ++i) sphere.vertices = implicit_curvature_step(sphere, time / steps);
    return mean_radius(sphere.vertices);
}

}  // namespace

TEST_CASE("the implicit flow of a sphere follows sqrt(r0^2 - 4 t), with first order in the step") {
    const geometry::SurfaceData sphere = tests::icosphere(3);
    const double time = 0.15, exact = std::sqrt(1 - 4 * time);
    const double rough = radius_after(sphere, time, 10) - exact, fine = radius_after(sphere, time, 20) - exact;
    CHECK(std::abs(fine) < 0.02);
    CHECK(rough / fine == Approx(2).epsilon(0.15));
}

TEST_CASE("one implicit step of a sphere is that of its equation, however large") {
    const geometry::SurfaceData sphere = tests::icosphere(4);
    for (const double dt : {1e-3, 0.1, 10.0, 1e4}) {
        const std::vector<Point3> after = implicit_curvature_step(sphere, dt);
        CHECK(mean_radius(after) == Approx(1 / (1 + 2 * dt)).epsilon(0.003));
    }
}

TEST_CASE("small implicit steps are explicit steps") {
    const geometry::SurfaceData torus = tests::torus(16, 0.4);
    const VertexRings rings(torus);
    std::vector<RingTriangle> buffer;
    const double dt = 1e-9;
    const std::vector<Point3> after = implicit_curvature_step(torus, dt);
    for (std::uint32_t v = 0; v < after.size(); ++v) {
        const Vector3 velocity = curvature(rings.ring(v, buffer)).vector;
        REQUIRE(((after[v] - torus.vertices[v]) / dt - velocity).norm() < 1e-5 * velocity.norm() + 1e-6);
    }
}

TEST_CASE("fixed vertices and those of no triangle stay, and what is between fixed ones becomes flat") {
    geometry::SurfaceData box = tests::box();
    box.vertices.push_back(Point3(0.5, 0.5, 2));  // over the top, whose triangles are replaced by a pyramid
    box.vertices.push_back(Point3(7, 7, 7));
    box.triangles[2] = {4, 5, 8};
    box.triangles[3] = {5, 7, 8};
    box.triangles.push_back({7, 6, 8});
    box.triangles.push_back({6, 4, 8});
    std::vector<std::uint8_t> is_fixed(box.vertices.size(), 1);
    is_fixed[8] = is_fixed[9] = 0;
    const std::vector<Point3> after = implicit_curvature_step(box, 1e9, is_fixed);
    for (std::size_t v = 0; v < 8; ++v) CHECK(after[v] == box.vertices[v]);
    CHECK(after[9] == box.vertices[9]);
    CHECK((after[8] - Point3(0.5, 0.5, 1)).norm() < 1e-6);
}
