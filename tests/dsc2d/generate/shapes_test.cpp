// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/generate/shapes.h"

#include <array>
#include <catch2/catch.hpp>
#include <numbers>
#include <set>

#include "core/errors.h"
#include "dsc2d/generate/complex_around.h"
#include "dsc2d/label_statistics.h"
#include "geometry/polygon_check.h"
#include "geometry/triangle.h"
#include "tests/dsc2d/support.h"

using namespace dsc::dsc2d;
using dsc::geometry::first_meeting;
using dsc::tests::require_valid;
using std::numbers::pi;

namespace {

const Point2 centre(0.3, -0.2);

double area(const Region& region) { return dsc::geometry::signed_area(region.outline); }

// Simple outlines, counterclockwise, with sides about as long as asked for.
void check_outlines(const std::vector<Region>& regions, double edge_length) {
    for (const Region& region : regions) {
        CHECK_FALSE(first_meeting(std::array{region.outline}));
        CHECK(area(region) > 0);
        for (std::size_t i = 0; i < region.outline.size(); ++i) {
            const double length = (region.outline[(i + 1) % region.outline.size()] - region.outline[i]).norm();
            REQUIRE(length < 1.5 * edge_length);
            REQUIRE(length > 0.66 * edge_length);
        }
    }
}

}  // namespace

TEST_CASE("shapes have the area of their formulas, to the second power of the edge length") {
    for (const double h : {0.02, 0.01, 0.005}) {
        const double tolerance = 4 * h * h;
        check_outlines(disc(centre, 0.3, h), h);
        CHECK(area(disc(centre, 0.3, h)[0]) == Approx(pi * 0.09).margin(tolerance));
        const auto discs = two_discs(centre, 0.2, 0.05, h);
        check_outlines(discs, h);
        REQUIRE(discs.size() == 2);
        CHECK_FALSE(first_meeting(std::array{discs[0].outline, discs[1].outline}));
        CHECK(area(discs[1]) == Approx(pi * 0.04).margin(tolerance));
        const auto rings = ring(centre, 0.3, 0.1, h);
        check_outlines(rings, h);
        CHECK(area(rings[0]) - area(rings[1]) == Approx(pi * (0.16 - 0.04)).margin(tolerance));
        check_outlines(rectangle(centre, {0.4, 0.3}, h), h);
        CHECK(area(rectangle(centre, {0.4, 0.3}, h)[0]) == Approx(0.12).epsilon(1e-12));
        const auto zalesak = slotted_disc(centre, 0.3, 0.1, 0.5, h);
        check_outlines(zalesak, h);
        // The disc without the slot, whose lower end is the arc between its sides.
        const double half = std::asin(0.05 / 0.3), segment = 0.09 * (half - std::sin(half) * std::cos(half));
        const double slot = 0.1 * (0.2 + 0.3 * std::cos(half)) + segment;
        CHECK(area(zalesak[0]) == Approx(pi * 0.09 - slot).margin(tolerance));
        const auto block = labelled_block(centre, {0.4, 0.2}, h);
        check_outlines(block, h);
        CHECK(area(block[0]) == Approx(0.04).epsilon(1e-12));
        CHECK(area(block[1]) == Approx(0.02).epsilon(1e-12));
    }
}

TEST_CASE("the neck of a dumbbell is as wide as asked for, and its outline has no corner") {
    const auto regions = dumbbell(centre, {.half_distance = 0.5, .disc_radius = 0.3, .neck = 0.1}, 0.01);
    check_outlines(regions, 0.01);
    const std::vector<Point2>& outline = regions[0].outline;
    double neck = 1;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point2 a = outline[(i + 1) % outline.size()] - outline[i];
        const Point2 b = outline[(i + 2) % outline.size()] - outline[(i + 1) % outline.size()];
        CHECK(dsc::geometry::angle_between(a, b) < 0.06);
        neck = std::min(neck, std::abs(outline[i].y() - centre.y()) +
                                  10 * std::max(0.0, std::abs(outline[i].x() - centre.x()) - 0.2));
    }
    CHECK(neck == Approx(0.1).epsilon(0.01));
}

TEST_CASE("regular polygons have equal sides; corners stay where sides are divided") {
    const auto corners = regular_polygon(centre, 2, 5, true);
    CHECK((corners[0] - (centre + Point2(0, 2))).norm() < 1e-15);
    for (int i = 0; i < 5; ++i) {
        const double side =
            (corners[static_cast<std::size_t>((i + 1) % 5)] - corners[static_cast<std::size_t>(i)]).norm();
        CHECK(side == Approx(4 * std::sin(pi / 5)));
    }
    const auto fine = divided(corners, 0.1);
    for (const Point2& corner : corners) CHECK(std::ranges::count(fine, corner) == 1);
    CHECK(dsc::geometry::signed_area(fine) == Approx(dsc::geometry::signed_area(corners)));
    CHECK(divided(corners, 10) == corners);
}

TEST_CASE("lengths that don't fit together are refused by the name of the shape") {
    using dsc::core::UsageError;
    CHECK_THROWS_AS(disc(centre, 0.3, 0), UsageError);
    CHECK_THROWS_AS(disc(centre, 0.3, 1e-12), UsageError);
    CHECK_THROWS_AS(two_discs(centre, 0.3, 0, 0.1), UsageError);
    CHECK_THROWS_AS(ring(centre, 0.3, 0.3, 0.1), UsageError);
    CHECK_THROWS_AS(rectangle(centre, {0.3, 0}, 0.1), UsageError);
    CHECK_THROWS_AS(dumbbell(centre, {.half_distance = 0.3, .disc_radius = 0.3}, 0.1), UsageError);
    CHECK_THROWS_AS(dumbbell(centre, {.neck = 0.3}, 0.1), UsageError);
    CHECK_THROWS_AS(slotted_disc(centre, 0.3, 0.6, 0.3, 0.1), UsageError);
    CHECK_THROWS_AS(slotted_disc(centre, 0.3, 0.1, 0.6, 0.1), UsageError);
    CHECK_THROWS_WITH(regular_polygon(centre, 1, 2), Catch::Contains("polygon"));
}

TEST_CASE("the mesh around shapes is valid, keeps their sides and has good angles") {
    const auto smallest_angle = [](const Complex& complex) {
        double smallest = pi;
        for (std::uint32_t i = 0; i < complex.face_capacity(); ++i) {
            const auto [a, b, c] = complex.corners(FaceId(i));
            smallest = std::min(smallest, dsc::geometry::min_angle(a, b, c));
        }
        return smallest * 180 / pi;
    };
    const Domain box = Domain::box({0, 0}, {1, 1}), torus = Domain::torus(Eigen::Matrix2d::Identity());
    const Point2 middle(0.5, 0.5);
    const double h = 0.02;
    for (const auto& regions : {disc(middle, 0.3, h), two_discs(middle, 0.15, h, h), ring(middle, 0.3, 0.1, h),
                                rectangle(middle, {0.5, 0.5}, h), labelled_block(middle, {0.5, 0.5}, h)}) {
        // The parts of a block share their inner sides.
        std::set<std::array<double, 4>> sides;
        for (const Region& region : regions)
            for (std::size_t i = 0; i < region.outline.size(); ++i) {
                const Point2 a = region.outline[i], b = region.outline[(i + 1) % region.outline.size()];
                const std::array<double, 4> there = {a.x(), a.y(), b.x(), b.y()}, back = {b.x(), b.y(), a.x(), a.y()};
                sides.insert(std::min(there, back));
            }
        for (const Domain& domain : {box, torus}) {
            const Complex complex = complex_around(domain, regions, h);
            require_valid(complex);
            CHECK(smallest_angle(complex) > 20);
            std::size_t interface_edges = 0;
            for (std::uint32_t e = 0; e < complex.edge_capacity(); ++e)
                interface_edges += complex.is_interface(EdgeId(e)) ? 1 : 0;
            CHECK(interface_edges == sides.size());
            CHECK(labelled_area(complex, 1) <= area(regions[0]) * regions.size() + 1e-12);
        }
    }
    Eigen::Matrix2d periods = Eigen::Matrix2d::Identity();
    const Complex across = complex_around(Domain::torus(periods), disc({0.98, 0.03}, 0.3, h), h);
    require_valid(across);
    CHECK(labelled_area(across, 1) == Approx(area(disc({0.98, 0.03}, 0.3, h)[0])).epsilon(1e-12));
}

TEST_CASE("regions may touch or lie in one another, but not cross") {
    Complex complex = complex_around(Domain::box({0, 0}, {1, 1}), {}, 0.1);
    const std::vector<Point2> left = {{0.2, 0.2}, {0.5, 0.2}, {0.5, 0.8}, {0.2, 0.8}};
    const std::vector<Point2> right = {{0.5, 0.2}, {0.8, 0.2}, {0.8, 0.8}, {0.5, 0.8}};
    const std::vector<Point2> inside = {{0.6, 0.4}, {0.7, 0.4}, {0.65, 0.6}};
    insert_regions(complex, std::vector<Region>{{left, 1}, {right, 2}, {inside, 0}});
    require_valid(complex);
    CHECK(labelled_area(complex, 1) == Approx(0.18));
    CHECK(labelled_area(complex, 2) == Approx(0.17));
    CHECK(label_statistics(complex)[0].components == 2);
    const std::vector<Point2> crossing = {{0.3, 0.3}, {0.7, 0.3}, {0.7, 0.35}};
    CHECK_THROWS_AS(insert_regions(complex, std::vector<Region>{{crossing, 3}}), dsc::core::InputError);
}
