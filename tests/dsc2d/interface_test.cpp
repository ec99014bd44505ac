// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/interface.h"

#include <algorithm>

#include "dsc2d/generate/insert_polygon.h"
#include "dsc2d/generate/shapes.h"
#include "dsc2d/generate/structured.h"
#include "dsc2d/label_statistics.h"
#include "geometry/triangle.h"
#include "tests/dsc2d/support.h"

using namespace dsc::dsc2d;
using dsc::tests::circle;
using dsc::tests::require_valid;

namespace {

Complex block() {
    Complex complex = structured_complex(Domain::box({0, 0}, {1, 1}), 10, 10);
    insert_regions(complex, labelled_block({0.5, 0.5}, {0.5, 0.4}, 0.05));
    return complex;
}

double length(const InterfaceCurve& curve) {
    double sum = 0;
    for (std::size_t i = 1; i < curve.points.size(); ++i)
        sum += (curve.points[i].place - curve.points[i - 1].place).norm();
    return sum;
}

}  // namespace

TEST_CASE("segments have the object on their left, and add up to the outline") {
    Complex complex = structured_complex(Domain::box({-1, -1}, {1, 1}), 8, 8);
    const auto corners = circle({0.1, 0}, 0.5, 50);
    insert_polygon(complex, corners, 3);
    const Interface interface(complex);
    CHECK(interface.vertices.size() == 50);
    REQUIRE(interface.segments.size() == 50);
    Point2 sum = Point2::Zero();
    for (const InterfaceSegment& s : interface.segments) {
        const Point2 from = complex.position(interface.vertices[s.a]), to = complex.position(interface.vertices[s.b]);
        CHECK(s.vector == to - from);
        CHECK(dsc::geometry::cross(Point2(from - Point2(0.1, 0)), s.vector) > 0);
        sum += s.vector;
    }
    CHECK(sum.norm() < 1e-14);
}

TEST_CASE("curves run between junctions, each with its labels, and are closed elsewhere") {
    const Complex complex = block();
    const auto curves = interface_curves(complex);
    REQUIRE(curves.size() == 6);
    double whole = 0;
    for (const InterfaceCurve& curve : curves) {
        CHECK(curve.left > curve.right);
        CHECK_FALSE(curve.is_closed());
        CHECK(complex.interface_degree(curve.points.front().vertex) == 3);
        CHECK(complex.interface_degree(curve.points.back().vertex) == 3);
        whole += length(curve);
    }
    // The outline, the middle line and the half line.
    CHECK(whole == Approx(1.8 + 0.4 + 0.25));

    Complex disc = structured_complex(Domain::box({-1, -1}, {1, 1}), 8, 8);
    insert_polygon(disc, circle({0, 0}, 0.5, 50), 1);
    const auto one = interface_curves(disc);
    REQUIRE(one.size() == 1);
    CHECK(one[0].is_closed());
    CHECK(one[0].points.size() == 51);
    CHECK(one[0].left == 1);
    CHECK(one[0].right == 0);
}

TEST_CASE("a curve across the seam is in one piece, also when its vertices are known in other periods") {
    Complex complex = structured_complex(Domain::torus(Eigen::Matrix2d::Identity()), 8, 8);
    const auto front = insert_polygon(complex, circle({0.95, 0.5}, 0.2, 40), 1);
    for (std::size_t i = 0; i < front.size(); i += 3) complex.reanchor(front[i], {static_cast<int>(i % 2) + 1, -1});
    require_valid(complex);
    const auto curves = interface_curves(complex);
    REQUIRE(curves.size() == 1);
    CHECK(curves[0].points.front().place == curves[0].points.back().place);
    CHECK(length(curves[0]) == Approx(80 * 0.2 * std::sin(std::numbers::pi / 40)));
}

TEST_CASE("a curve that ends at the wall of the box begins or ends there") {
    Complex complex = structured_complex(Domain::box({0, 0}, {1, 1}), 6, 6);
    for (std::uint32_t i = 0; i < complex.face_capacity(); ++i) {
        const auto corners = complex.corners(FaceId(i));
        if ((corners[0] + corners[1] + corners[2]).x() / 3 < 0.5) complex.set_label(FaceId(i), 1);
    }
    const auto curves = interface_curves(complex);
    REQUIRE(curves.size() == 1);
    CHECK(curves[0].points.size() == 7);
    CHECK(complex.is_boundary(curves[0].points.front().vertex));
    CHECK(complex.is_boundary(curves[0].points.back().vertex));
    // The object on the left: upwards on its right side.
    CHECK(curves[0].points.back().place.y() == 1);
}

TEST_CASE("area, length, components and holes of each label") {
    const auto found = label_statistics(block());
    REQUIRE(found.size() == 4);
    CHECK(found[0].area == Approx(0.8));
    CHECK(found[0].components == 1);
    CHECK(found[0].holes == 1);
    CHECK(found[0].boundary_length == Approx(4));
    CHECK(found[1].area == Approx(0.1));
    CHECK(found[1].interface_length == Approx(1.3));
    CHECK(found[2].area == Approx(0.05));
    CHECK(found[3].area == Approx(0.05));
    for (int label = 1; label < 4; ++label) {
        CHECK(found[static_cast<std::size_t>(label)].label == label);
        CHECK(found[static_cast<std::size_t>(label)].components == 1);
        CHECK(found[static_cast<std::size_t>(label)].holes == 0);
        CHECK(found[static_cast<std::size_t>(label)].boundary_length == 0);
    }
    Complex rings = structured_complex(Domain::box({-2, -2}, {2, 2}), 20, 20);
    insert_regions(rings, ring({-0.9, 0}, 0.6, 0.2, 0.1));
    insert_regions(rings, ring({0.9, 0}, 0.6, 0.2, 0.1));
    const auto two = label_statistics(rings);
    CHECK(two[0].components == 3);
    CHECK(two[0].holes == 2);
    CHECK(two[1].components == 2);
    CHECK(two[1].holes == 2);
}
