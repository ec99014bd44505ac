// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/complex.h"

#include <algorithm>
#include <iostream>
#include <sstream>

#include "core/errors.h"
#include "core/random.h"
#include "dsc2d/generate/insert_polygon.h"
#include "dsc2d/generate/structured.h"
#include "dsc2d/operations/collapse.h"
#include "tests/dsc2d/support.h"
#include "tests/support/seed.h"

using namespace dsc::dsc2d;
using dsc::tests::require_valid;

namespace {

// What is written to std::cerr as long as this lives.
class CapturedErrors {
public:
    CapturedErrors() : before_(std::cerr.rdbuf(text_.rdbuf())) {}
    ~CapturedErrors() { std::cerr.rdbuf(before_); }
    CapturedErrors(const CapturedErrors&) = delete;
    CapturedErrors& operator=(const CapturedErrors&) = delete;
    std::string text() const { return text_.str(); }

private:
    std::ostringstream text_;
    std::streambuf* before_;
};

}  // namespace

TEST_CASE("labels drive the interface") {
    Complex complex = structured_complex(Domain::torus(Eigen::Matrix2d::Identity()), 4, 4);
    dsc::core::Random random(dsc::tests::seed(7));
    for (int i = 0; i < 500; ++i) {
        const FaceId f(static_cast<std::uint32_t>(random.below(complex.face_capacity())));
        complex.set_label(f, static_cast<int>(random.below(4)));
        require_valid(complex);
    }
}

TEST_CASE("another period of a vertex changes nothing but its coordinates") {
    Eigen::Matrix2d periods;
    periods << 1, 0.3, 0, 1;
    Complex complex = structured_complex(Domain::torus(periods), 3, 5);
    std::vector<Point2> before;
    for (const HalfedgeId h : complex.outgoing(VertexId(4))) before.push_back(complex.vector(h));
    complex.reanchor(VertexId(4), {2, -3});
    require_valid(complex);
    std::size_t i = 0;
    for (const HalfedgeId h : complex.outgoing(VertexId(4))) CHECK(complex.vector(h) == before[i++]);
}

TEST_CASE("compaction keeps the complex and what is attached to it") {
    Complex complex = structured_complex(Domain::box({0, 0}, {1, 1}), 8, 8);
    insert_polygon(complex, dsc::tests::circle({0.5, 0.5}, 0.3, 12), 3);
    dsc::core::Attribute<VertexId, Point2> place(complex.vertex_attributes(), Point2(Point2::Zero()));
    dsc::core::Attribute<FaceId, double> area(complex.face_attributes(), 0.0);
    for (std::uint32_t v = 0; v < complex.vertex_capacity(); ++v)
        for (const HalfedgeId h : complex.outgoing(VertexId(v)))
            if (can_collapse(complex, h, CollapseRule::keep_interface)) {
                collapse(complex, h);
                break;
            }
    for (std::uint32_t v = 0; v < complex.vertex_capacity(); ++v) place[VertexId(v)] = complex.position(VertexId(v));
    for (std::uint32_t f = 0; f < complex.face_capacity(); ++f)
        if (!complex.is_deleted(FaceId(f))) area[FaceId(f)] = complex.area(FaceId(f));
    const double inside = labelled_area(complex, 3);
    const std::uint32_t vertices = complex.vertex_count(), faces = complex.face_count();
    CHECK(complex.garbage_fraction() > 0.3);
    complex.compact();
    require_valid(complex);
    CHECK(complex.garbage_fraction() == 0.0);
    CHECK(complex.vertex_capacity() == vertices);
    CHECK(complex.face_capacity() == faces);
    CHECK(labelled_area(complex, 3) == Approx(inside).epsilon(1e-14));
    for (std::uint32_t v = 0; v < complex.vertex_capacity(); ++v)
        REQUIRE(place[VertexId(v)] == complex.position(VertexId(v)));
    for (std::uint32_t f = 0; f < complex.face_capacity(); ++f)
        REQUIRE(area[FaceId(f)] == Approx(complex.area(FaceId(f))).epsilon(1e-14));
}

TEST_CASE("triangles that make no complex are refused") {
    using dsc::core::InputError;
    const Domain box = Domain::box({0, 0}, {1, 1});
    const std::vector<Point2> points = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
    const LatticeVector zero = LatticeVector::Zero();
    const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        return TriangleInput{{a, b, c}, {zero, zero, zero}, 0};
    };
    CHECK_THROWS_AS(Complex(box, points, std::vector{triangle(0, 2, 1)}), InputError);
    CHECK_THROWS_AS(Complex(box, points, std::vector{triangle(0, 1, 7)}), InputError);
    CHECK_THROWS_AS(Complex(box, points, std::vector{triangle(0, 1, 2)}), InputError);
    CHECK_THROWS_AS(Complex(box, points, std::vector{triangle(0, 1, 2), triangle(0, 1, 3)}), InputError);
    require_valid(Complex(box, points, std::vector{triangle(0, 1, 2), triangle(1, 3, 2)}));
}

TEST_CASE("what is no manifold is refused with its place and without a word on stderr") {
    // A hexagon round vertex 6, and a triangle 6, 7, 8 that lies over it.
    std::vector<Point2> points = dsc::tests::circle({0, 0}, 1, 6);
    points.emplace_back(0, 0);
    points.emplace_back(2, 0.1);
    points.emplace_back(2, 1);
    const Domain box = Domain::box({-1, -1}, {2, 1});
    const LatticeVector zero = LatticeVector::Zero();
    std::vector<TriangleInput> fan;
    for (std::uint32_t i = 0; i < 6; ++i) fan.push_back({{6, i, (i + 1) % 6}, {zero, zero, zero}, 0});
    const TriangleInput other = {{6, 7, 8}, {zero, zero, zero}, 0};
    const auto check_refused = [&](const std::vector<TriangleInput>& triangles, const std::string& place) {
        const CapturedErrors captured;
        CHECK_THROWS_WITH(Complex(box, points, triangles), Catch::Contains(place));
        CHECK(captured.text() == "");
    };
    std::vector<TriangleInput> triangles = fan;
    triangles.push_back(fan[2]);
    std::ranges::rotate(triangles.back().vertices, triangles.back().vertices.begin() + 1);
    check_refused(triangles, "triangle 6: lies on the same side of an edge as triangle 2");
    triangles = fan;
    triangles[5] = {{6, 5, 6}, {zero, zero, zero}, 0};
    check_refused(triangles, "triangle 5: names a vertex twice");
    // The triangle comes before, among, and after those of the whole fan, and beside parts of it.
    for (std::size_t at = 0; at <= fan.size(); ++at) {
        triangles = fan;
        triangles.insert(triangles.begin() + static_cast<std::ptrdiff_t>(at), other);
        check_refused(triangles, "vertex 6: joins triangles");
    }
    triangles = {fan[0], fan[1], fan[3], fan[4], other};
    check_refused(triangles, "vertex 6: joins triangles");
    check_refused(fan, "vertex 7: belongs to no triangle");
    // A fan that is open, or closed, is a manifold in whatever order it comes.
    points.resize(7);
    dsc::core::Random random(dsc::tests::seed(11));
    for (const std::size_t size : {5, 6})
        for (int i = 0; i < 50; ++i) {
            triangles.assign(fan.begin(), fan.begin() + static_cast<std::ptrdiff_t>(size));
            for (std::size_t k = size - 1; k > 0; --k) std::swap(triangles[k], triangles[random.below(k + 1)]);
            require_valid(Complex(box, points, triangles));
        }
}
