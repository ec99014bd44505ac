// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/generate/graded_points.h"

#include <catch2/catch.hpp>
#include <limits>

#include "core/errors.h"
#include "dsc3d/generate/shapes.h"

using namespace dsc;
using namespace dsc::dsc3d;

namespace {

const Eigen::AlignedBox3d graded_box(Point3(-0.1, 0, 0.1), Point3(1, 1.3, 1));
const Point3 finest_point(0.4, 0.7, 0.6);
const geometry::SurfaceData fine_ball = icosphere(finest_point, 0.2, 8);

std::vector<Point3> all_points(const GradedPoints& points) {
    std::vector<Point3> all = points.on_box;
    all.insert(all.end(), points.inside.begin(), points.inside.end());
    return all;
}

}  // namespace

TEST_CASE("sizes are the surface's own on it, and grow with the distance") {
    const Sizing sizing(fine_ball, 0.5);
    const Sizing::Answer on = sizing.at(fine_ball.vertices[17]);
    CHECK(on.distance == Approx(0).margin(1e-15));
    CHECK(on.edge_length == on.surface_edge_length);
    CHECK(on.edge_length == Approx(0.03).epsilon(0.15));
    const Sizing::Answer far = sizing.at(finest_point + Point3(0, 0, 0.4));
    CHECK(far.distance == Approx(0.2).epsilon(0.01));
    CHECK(far.edge_length == Approx(far.surface_edge_length + 0.5 * (far.distance - far.surface_edge_length)));
}

TEST_CASE("graded points keep their distances from the surface and from each other and leave no gaps") {
    const Sizing sizing(fine_ball, 1);
    const GradedPointsParameters parameters;
    core::Observer observer;
    const GradedPoints points = graded_points(graded_box, sizing, observer);
    for (const Point3& p : points.inside) {
        REQUIRE((p.array() > graded_box.min().array()).all());
        REQUIRE((p.array() < graded_box.max().array()).all());
        const Sizing::Answer at = sizing.at(p);
        REQUIRE(at.distance >= parameters.clearance * at.surface_edge_length);
    }
    for (const Point3& p : points.on_box) {
        const int sides = static_cast<int>((p.array() == graded_box.min().array()).count() +
                                           (p.array() == graded_box.max().array()).count());
        REQUIRE(sides >= 1);
    }
    for (int corner = 0; corner < 8; ++corner)
        CHECK(graded_box.isApprox(
            Eigen::AlignedBox3d(graded_box).extend(points.on_box[static_cast<std::size_t>(corner)])));

    const std::vector<Point3> all = all_points(points);
    const auto nearest = [&](const Point3& p) {
        double distance = std::numeric_limits<double>::infinity();
        for (const Point3& q : all)
            if (&q != &p) distance = std::min(distance, (q - p).norm());
        return distance;
    };
    // Of two points the later one kept its distance; its radius differs from that of the other one by growth.
    for (const Point3& p : all) REQUIRE(nearest(p) > 0.4 * parameters.separation * sizing.at(p).edge_length);
    for (double x = -0.05; x < 1; x += 0.1)
        for (double y = 0.05; y < 1.3; y += 0.1)
            for (double z = 0.15; z < 1; z += 0.1) {
                const Point3 p(x, y, z);
                REQUIRE(std::min(nearest(p), sizing.at(p).distance) < 1.3 * sizing.at(p).edge_length);
            }
}

TEST_CASE("a surface too fine for its box is refused") {
    core::Observer observer;
    CHECK_THROWS_AS(
        graded_points({Point3(-100, -100, -0.001), Point3(100, 100, 0.001)}, Sizing(fine_ball, 0), observer),
        core::UsageError);
    const Point3 far = Point3::Constant(1e90);
    CHECK_THROWS_AS(graded_points({-far, far}, Sizing(fine_ball, 1), observer), core::UsageError);
}

TEST_CASE("a box that is large for its surface takes few more points, and a long search can be stopped") {
    core::Observer observer;
    const GradedPoints points =
        graded_points({Point3::Constant(-1e6), Point3::Constant(1e6)}, Sizing(fine_ball, 1), observer);
    CHECK(all_points(points).size() <
          30 * all_points(graded_points(graded_box, Sizing(fine_ball, 1), observer)).size());
    class Cancelled final : public core::Observer {
        bool is_cancelled() const override { return true; }
    } cancelled;
    CHECK_THROWS_AS(graded_points(graded_box, Sizing(fine_ball, 0.1), cancelled), core::Cancelled);
}
