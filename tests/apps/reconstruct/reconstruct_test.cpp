// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/reconstruct.h"

#include <catch2/catch.hpp>

#include <map>
#include <set>

#include "core/errors.h"
#include "geometry/surface_intersections.h"
#include "tests/apps/reconstruct/clouds.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::reconstruct;

namespace {

Reconstruction reconstructed(const std::vector<Point3>& points, const ReconstructParameters& parameters = {}) {
    core::Observer observer;
    geometry::PointData data;
    data.points = points;
    return reconstruct::reconstruct(data, parameters, "points", observer);
}

void check_valid(const Reconstruction& result) {
    const geometry::SurfaceCheck check = geometry::check_surface(result.surface);
    CHECK(check.is_closed());
    CHECK(check.is_manifold());
    CHECK(check.is_oriented());
    REQUIRE(check.volume);
    CHECK(*check.volume > 0);
    CHECK(geometry::self_intersections(result.surface).empty());
    CHECK(result.is_invented.size() == result.surface.triangles.size());
}

const Eigen::AlignedBox3d unit_box(Point3(0, 0, 0), Point3(1, 1, 1));

}  // namespace

TEST_CASE("a sphere has its volume, its genus and no sharp edges") {
    core::Random random(tests::seed(1));
    const Reconstruction result = reconstructed(tests::sphere_cloud({5, 6, 7}, 2, 1500, random).points);
    check_valid(result);
    CHECK(result.genus == std::vector<std::int64_t>{0});
    CHECK(*result.check.volume == Approx(4 * std::numbers::pi / 3 * 8).epsilon(0.004));
    CHECK(result.fit.corners == 0);
    for (const Point3& p : result.surface.vertices) CHECK((p - Point3(5, 6, 7)).norm() == Approx(2).epsilon(0.02));
    CHECK(result.residuals.largest < 0.05);
}

TEST_CASE("a torus of 500 points has a hole") {
    core::Random random(tests::seed(1));
    const Reconstruction result = reconstructed(tests::torus_cloud(1, 0.4, 500, random).points);
    check_valid(result);
    CHECK(result.genus == std::vector<std::int64_t>{1});
    CHECK(*result.check.volume == Approx(2 * std::numbers::pi * std::numbers::pi * 0.16).epsilon(0.03));
}

TEST_CASE("a box has its eight corners, its edges, and few triangles on its faces") {
    core::Random random(tests::seed(1));
    const Reconstruction result = reconstructed(tests::box_cloud(unit_box, 3000, random).points);
    check_valid(result);
    CHECK(*result.check.volume == Approx(1).epsilon(0.002));
    CHECK(result.check.area == Approx(6).epsilon(0.003));
    for (int k = 0; k < 8; ++k) {
        const Point3 corner = unit_box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k));
        double nearest = 1;
        for (const Point3& p : result.surface.vertices) nearest = std::min(nearest, (p - corner).norm());
        CHECK(nearest < 0.5 * result.spacing);
    }
    CHECK(result.fit.decimated > 0);
}

TEST_CASE("two balls beside each other stay two, and a cavity is found") {
    core::Random random(tests::seed(1));
    tests::OrientedCloud points = tests::sphere_cloud({0, 0, 0}, 1, 1000, random);
    tests::add(points, tests::sphere_cloud({2.3, 0, 0}, 1, 1000, random));
    const Reconstruction two = reconstructed(points.points);
    check_valid(two);
    CHECK(two.genus == std::vector<std::int64_t>{0, 0});
    CHECK(two.cavities == 0);
    points = tests::sphere_cloud({0, 0, 0}, 1, 1500, random);
    tests::add(points, tests::sphere_cloud({0, 0, 0}, 0.5, 400, random));
    const Reconstruction hollow = reconstructed(points.points);
    check_valid(hollow);
    CHECK(hollow.genus == std::vector<std::int64_t>{0, 0});
    CHECK(hollow.cavities == 1);
    CHECK(*hollow.check.volume == Approx(4 * std::numbers::pi / 3 * (1 - 0.125)).epsilon(0.02));
}

TEST_CASE("a hole in the sampling is bridged, and what bridges it is marked") {
    core::Random random(tests::seed(1));
    std::vector<Point3> points = tests::sphere_cloud({0, 0, 0}, 1, 2500, random).points;
    std::erase_if(points, [](const Point3& p) { return p.z() > 0.9; });
    const Reconstruction result = reconstructed(points);
    check_valid(result);
    CHECK(result.genus == std::vector<std::int64_t>{0});
    // A clamped plate keeps the curvature of its rim, about.
    for (const Point3& p : result.surface.vertices) CHECK(p.norm() == Approx(1).epsilon(0.03));
    std::size_t invented = 0;
    for (std::size_t t = 0; t < result.is_invented.size(); ++t) {
        if (result.is_invented[t] == 0) continue;
        ++invented;
        CHECK(result.surface.vertices[result.surface.triangles[t][0]].z() > 0.7);
    }
    CHECK(invented > 0);
}

TEST_CASE("scans of one side are closed, and what closes them is marked", "[slow]") {
    core::Random random(tests::seed(1));
    std::vector<std::vector<Point3>> scans = {tests::sphere_cloud({0, 0, 0}, 1, 3000, random).points,
                                              tests::torus_cloud(1, 0.4, 4000, random).points};
    for (std::vector<Point3>& points : scans) {
        std::erase_if(points, [](const Point3& p) { return p.z() < 0; });
        const Reconstruction result = reconstructed(points);
        check_valid(result);
        double invented = 0, invented_above = 0;
        for (std::size_t t = 0; t < result.is_invented.size(); ++t) {
            if (result.is_invented[t] == 0) continue;
            const auto& [a, b, c] = result.surface.triangles[t];
            const std::vector<Point3>& p = result.surface.vertices;
            const double area = 0.5 * (p[b] - p[a]).cross(p[c] - p[a]).norm();
            invented += area;
            if ((p[a] + p[b] + p[c]).z() / 3 > 3 * result.spacing) invented_above += area;
        }
        CHECK(invented > 1);
        CHECK(invented_above == 0);
    }
}

TEST_CASE("genus 0 is kept when asked for: films in tunnels, threads between parts, cavities filled") {
    core::Random random(tests::seed(1));
    const Reconstruction torus =
        reconstructed(tests::torus_cloud(1, 0.4, 900, random).points, {.keeps_genus_zero = true});
    check_valid(torus);
    CHECK(torus.genus == std::vector<std::int64_t>{0});
    // The film is one layer of tetrahedra.
    CHECK(*torus.check.volume == Approx(2 * std::numbers::pi * std::numbers::pi * 0.16).epsilon(0.1));
    tests::OrientedCloud points = tests::sphere_cloud({0, 0, 0}, 1, 700, random);
    tests::add(points, tests::sphere_cloud({2.5, 0, 0}, 1, 700, random));
    const Reconstruction two = reconstructed(points.points, {.keeps_genus_zero = true});
    check_valid(two);
    CHECK(two.genus == std::vector<std::int64_t>{0});
    points = tests::sphere_cloud({0, 0, 0}, 1, 1500, random);
    tests::add(points, tests::sphere_cloud({0, 0, 0}, 0.5, 400, random));
    const Reconstruction hollow = reconstructed(points.points, {.keeps_genus_zero = true});
    check_valid(hollow);
    CHECK(hollow.genus == std::vector<std::int64_t>{0});
    CHECK(hollow.cavities == 0);
}

TEST_CASE("noise and strays change little") {
    core::Random random(tests::seed(1));
    tests::OrientedCloud points = tests::sphere_cloud({0, 0, 0}, 1, 3000, random);
    tests::add_noise(points, 0.01, random);
    for (int i = 0; i < 20; ++i)
        points.points.emplace_back(random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2));
    const Reconstruction result = reconstructed(points.points);
    check_valid(result);
    CHECK(result.genus == std::vector<std::int64_t>{0});
    CHECK(result.noise == Approx(0.01).epsilon(0.35));
    CHECK(*result.check.volume == Approx(4 * std::numbers::pi / 3).epsilon(0.01));
}

TEST_CASE("scale and place don't matter, and neither does the number of threads", "[slow]") {
    core::Random random(tests::seed(1));
    const std::vector<Point3> points = tests::torus_cloud(1, 0.4, 900, random).points;
    const Reconstruction result = reconstructed(points, {.threads = 1});
    const Reconstruction again = reconstructed(points, {.threads = 2});
    CHECK(again.surface.vertices == result.surface.vertices);
    CHECK(again.surface.triangles == result.surface.triangles);
    for (const double scale : {1e-6, 1e6}) {
        std::vector<Point3> moved;
        for (const Point3& p : points) moved.push_back(scale * (p + Point3(300, -200, 1000)));
        const Reconstruction other = reconstructed(moved);
        check_valid(other);
        CHECK(other.genus == result.genus);
        CHECK(*other.check.volume / std::pow(scale, 3) == Approx(*result.check.volume).epsilon(0.01));
    }
}

TEST_CASE("the boundary of the tetrahedra is the surface") {
    core::Random random(tests::seed(1));
    const Reconstruction result = reconstructed(tests::box_cloud(unit_box, 1000, random).points, {.makes_tets = true});
    REQUIRE(!result.tets.tets.empty());
    std::set<std::array<double, 9>> surface, boundary;
    const auto key = [](std::array<Point3, 3> corners) {
        std::sort(corners.begin(), corners.end(), [](const Point3& a, const Point3& b) {
            return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
        });
        std::array<double, 9> numbers;
        for (std::size_t i = 0; i < 9; ++i) numbers[i] = corners[i / 3][static_cast<Eigen::Index>(i % 3)];
        return numbers;
    };
    for (const auto& [a, b, c] : result.surface.triangles)
        surface.insert(key({result.surface.vertices[a], result.surface.vertices[b], result.surface.vertices[c]}));
    std::map<std::array<double, 9>, int> faces;
    double volume = 0;
    for (const auto& tet : result.tets.tets) {
        std::array<Point3, 4> p;
        for (std::size_t i = 0; i < 4; ++i) p[i] = result.tets.vertices[tet[i]];
        const double six_volumes = (p[1] - p[0]).dot((p[2] - p[0]).cross(p[3] - p[0]));
        CHECK(six_volumes > 0);
        volume += six_volumes / 6;
        for (std::size_t i = 0; i < 4; ++i) ++faces[key({p[(i + 1) % 4], p[(i + 2) % 4], p[(i + 3) % 4]})];
    }
    for (const auto& [face, count] : faces)
        if (count == 1) boundary.insert(face);
    CHECK(boundary == surface);
    CHECK(volume == Approx(*result.check.volume));
}

TEST_CASE("a wanted edge length is followed") {
    core::Random random(tests::seed(1));
    const std::vector<Point3> points = tests::sphere_cloud({0, 0, 0}, 1, 1500, random).points;
    const Reconstruction coarse = reconstructed(points, {.detail = 0.3});
    const Reconstruction fine = reconstructed(points, {.detail = 0.15});
    check_valid(coarse);
    check_valid(fine);
    CHECK(fine.surface.triangles.size() > 2 * coarse.surface.triangles.size());
    CHECK_THROWS_WITH(reconstructed(points, {.detail = 1e-9}), Catch::Contains("give at least"));
    CHECK_THROWS_WITH(reconstructed(points, {.detail = 10}), Catch::Contains("give at most"));
}

TEST_CASE("parameters of a reconstruction out of their range are refused by name") {
    CHECK_THROWS_WITH(reconstructed({}, {.detail = 0}), Catch::Contains("detail"));
    CHECK_THROWS_WITH(reconstructed({}, {.noise = -1}), Catch::Contains("noise"));
    CHECK_THROWS_WITH(reconstructed({}, {.min_angle = 60}), Catch::Contains("min_angle"));
}
