// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/generate/delaunay.h"

#include <catch2/catch.hpp>

#include <Eigen/Dense>

#include "core/errors.h"
#include "core/random.h"
#include "dsc3d/mesh.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::dsc3d;

namespace {

double volume(const geometry::TetData& data) {
    double sum = 0;
    for (const auto& [a, b, c, d] : data.tets) {
        const Point3& p = data.vertices[a];
        sum += (data.vertices[b] - p).dot((data.vertices[c] - p).cross(data.vertices[d] - p)) / 6;
    }
    return sum;
}

std::vector<Point3> corners_and(std::size_t count, std::uint64_t seed) {
    std::vector<Point3> points;
    for (int k = 0; k < 8; ++k) points.emplace_back(k & 1, k >> 1 & 1, k >> 2);
    core::Random random(seed);
    for (std::size_t i = 0; i < count; ++i) points.emplace_back(random.uniform(), random.uniform(), random.uniform());
    return points;
}

}  // namespace

TEST_CASE("a Delaunay mesh fills the hull, and no point is inside the circumsphere of a tetrahedron") {
    const std::vector<Point3> points = corners_and(120, tests::seed(1));
    const geometry::TetData data = delaunay(points);
    CHECK(data.vertices == points);
    CHECK(validate(Mesh(data)).empty());
    CHECK(volume(data) == Approx(1));
    for (const auto& [a, b, c, d] : data.tets) {
        Eigen::Matrix3d rows;
        rows << (points[b] - points[a]).transpose(), (points[c] - points[a]).transpose(),
            (points[d] - points[a]).transpose();
        const Eigen::Vector3d right = 0.5 * rows.rowwise().squaredNorm();
        const Eigen::Vector3d centre = rows.fullPivLu().solve(right);
        const double radius = centre.norm();
        for (const Point3& p : points) CHECK((p - points[a] - centre).norm() > radius * (1 - 1e-6) - 1e-9);
    }
}

TEST_CASE("cospherical points make no flat tetrahedra") {
    std::vector<Point3> points;
    for (int i = 0; i < 125; ++i) points.emplace_back(i % 5, i / 5 % 5, i / 25);
    const geometry::TetData data = delaunay(points);
    CHECK(validate(Mesh(data)).empty());
    CHECK(volume(data) == Approx(64));
}

TEST_CASE("points in a plane have no tetrahedra") {
    const std::vector<Point3> points{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
    CHECK_THROWS_AS(delaunay(points), core::UsageError);
}
