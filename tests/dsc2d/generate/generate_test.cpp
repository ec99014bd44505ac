// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/errors.h"
#include "core/random.h"
#include "dsc2d/generate/insert_polygon.h"
#include "dsc2d/generate/locate.h"
#include "dsc2d/generate/structured.h"
#include "tests/dsc2d/support.h"
#include "tests/support/seed.h"

using namespace dsc::dsc2d;
using dsc::tests::circle;
using dsc::tests::require_valid;

TEST_CASE("structured complexes are valid and fill their domain") {
    Eigen::Matrix2d periods;
    periods << 2.0, 0.9, -0.1, 1.7;
    for (const Domain& domain : {Domain::torus(periods, Point2(3, -4)), Domain::box({-1.1, 0.3}, {0.7, 2.9}),
                                 Domain::cylinder({1.3, 0.2}, {0.1, 0.8})}) {
        for (const int columns : {3, 4, 11}) {
            const Complex complex = structured_complex(domain, columns, 7);
            require_valid(complex);
            CHECK(complex.face_count() == static_cast<std::uint32_t>(14 * columns));
            CHECK(std::abs(total_area(complex) - domain.area()) <= 1e-12 * domain.area());
        }
    }
    CHECK_THROWS_AS(structured_complex(Domain::torus(periods), 2, 3), dsc::core::UsageError);
    CHECK_THROWS_AS(structured_complex(Domain::box({0, 0}, {1, 1}), 0, 3), dsc::core::UsageError);
}

TEST_CASE("points are found where they are") {
    Complex complex = structured_complex(Domain::torus(Eigen::Matrix2d::Identity()), 4, 4);
    dsc::core::Random random(dsc::tests::seed(16));
    for (int i = 0; i < 500; ++i) {
        const Point2 p = complex.domain().snapped(Point2(random.uniform(-5, 5), random.uniform(-5, 5)));
        const auto location = locate(complex, p);
        REQUIRE(location);
        HalfedgeId h = location->halfedge;
        Point2 corner = complex.position(complex.from(h)) + complex.domain().translation(location->cell);
        for (int k = 0; k < 3; ++k, corner += complex.vector(h), h = complex.next(h))
            REQUIRE(dsc::geometry::orientation(corner, corner + complex.vector(h), p) != dsc::geometry::Sign::negative);
    }
    const auto at_vertex = locate(complex, Point2(1.25, -0.5));
    REQUIRE(at_vertex);
    CHECK(at_vertex->zero_sides == 2);
    CHECK(complex.position(complex.from(at_vertex->halfedge)) +
              complex.domain().translation(at_vertex->cell) == Point2(1.25, -0.5));
    CHECK_FALSE(locate(structured_complex(Domain::box({0, 0}, {1, 1}), 2, 2), Point2(1.5, 0.5)));
}

TEST_CASE("a polygon becomes an interface, across the seam too") {
    Complex complex = structured_complex(Domain::torus(Eigen::Matrix2d::Identity()), 5, 5);
    const auto corners = circle({0.95, 0.02}, 0.33, 40);
    const auto front = insert_polygon(complex, corners, 7);
    require_valid(complex);
    REQUIRE(front.size() == 40);
    for (std::size_t i = 0; i < front.size(); ++i) {
        CHECK(complex.interface_degree(front[i]) == 2);
        CHECK((complex.position(front[i]) - corners[i]).norm() < 1e-12);
    }
    CHECK(labelled_area(complex, 7) == Approx(20 * 0.33 * 0.33 * std::sin(2 * std::numbers::pi / 40)));
    CHECK(dsc::tests::component_count(complex, 7) == 1);
    CHECK(dsc::tests::euler_characteristic(complex, 7) == 1);
}

TEST_CASE("sides through vertices and along edges of the complex are taken as they lie") {
    Complex complex = structured_complex(Domain::box({0, 0}, {4, 4}), 4, 4);
    const std::vector<Point2> square = {{1, 1}, {3, 1}, {3, 3}, {1, 3}};
    const auto front = insert_polygon(complex, square, 1);
    require_valid(complex);
    CHECK(front.size() == 8);
    CHECK(labelled_area(complex, 1) == 4.0);
}

TEST_CASE("clockwise, nested and separate polygons") {
    Complex complex = structured_complex(Domain::box({0, 0}, {4, 4}), 4, 4);
    std::vector<Point2> clockwise = circle({1.2, 1.2}, 0.8, 30);
    std::reverse(clockwise.begin(), clockwise.end());
    const std::vector<std::vector<Point2>> polygons = {clockwise, circle({1.25, 1.2}, 0.4, 20), circle({3, 3}, 0.5, 20)};
    insert_polygons(complex, polygons, std::vector<int>{1, 0, 2});
    require_valid(complex);
    CHECK(dsc::tests::euler_characteristic(complex, 1) == 0);
    CHECK(dsc::tests::euler_characteristic(complex, 2) == 1);
    CHECK(dsc::tests::component_count(complex, 0) == 2);
}

TEST_CASE("polygons that can't be an interface are refused, and the complex stays valid") {
    using dsc::core::InputError;
    Complex complex = structured_complex(Domain::box({0, 0}, {4, 4}), 4, 4);
    const auto refused = [&](const std::vector<Point2>& corners) {
        CHECK_THROWS_AS(insert_polygon(complex, corners, 1), InputError);
        require_valid(complex);
    };
    refused({{1, 1}, {2, 2}});
    refused({{0.6, 0.6}, {2.6, 2.7}, {2.6, 0.6}, {0.6, 2.7}});
    refused({{1, 1}, {9, 1}, {2, 3}});
    refused({{0, 1}, {2, 1}, {2, 3}});
    refused({{1.1, 1.1}, {1.1, 1.1}, {2, 3}});
    insert_polygon(complex, circle({2, 2}, 1, 20), 1);
    refused(circle({2.5, 2.5}, 1, 20));
    Complex torus = structured_complex(Domain::torus(Eigen::Matrix2d::Identity()), 4, 4);
    CHECK_THROWS_AS(insert_polygon(torus, circle({0.5, 0.5}, 0.52, 50), 1), InputError);
}
