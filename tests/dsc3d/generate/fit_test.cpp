// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/generate/fit.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/errors.h"
#include "dsc3d/generate/lattice.h"
#include "dsc3d/improve/angle_range.h"
#include "tests/dsc3d/volumes.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;

namespace {

const Point3 ball_centre(0.52, 0.48, 0.5);
constexpr double ball_radius = 0.3;

double sphere(const Point3& p) { return (p - ball_centre).norm() - ball_radius; }

Mesh fitted_box(double spacing) {
    Mesh mesh(lattice({Point3(0, 0, 0), Point3(1, 1, 1)}, spacing));
    fit(mesh, sphere);
    return mesh;
}

}  // namespace

TEST_CASE("the interface of a fitted sphere lies on it, and its volume converges with the square of the spacing") {
    const double exact = 4 * std::numbers::pi / 3 * ball_radius * ball_radius * ball_radius;
    std::vector<double> error;
    for (const double spacing : {0.1, 0.05}) {
        const Mesh mesh = fitted_box(spacing);
        CHECK(validate(mesh).empty());
        const Complex& complex = mesh.complex();
        for (std::uint32_t i = 0; i < complex.vertex_capacity(); ++i) {
            const VertexId v(i);
            if (!complex.is_deleted(v) && complex.is_interface(v)) REQUIRE(std::abs(sphere(mesh.position(v))) < 1e-14);
        }
        CHECK(volume_of_label(mesh, 0) + volume_of_label(mesh, 1) == Approx(1).epsilon(1e-12));
        error.push_back(std::abs(volume_of_label(mesh, 1) - exact));
        CHECK(AngleRange(mesh).min > 8 * std::numbers::pi / 180);
    }
    CHECK(error[0] < 0.05 * exact);
    CHECK(error[1] < error[0] / 3);
}

TEST_CASE("a surface that reaches the boundary, or a function that is not finite, can't be fitted") {
    Mesh mesh(lattice({Point3(0, 0, 0), Point3(1, 1, 1)}, 0.2));
    CHECK_THROWS_AS(fit(mesh, [](const Point3& p) { return p.x() - 0.5; }), core::UsageError);
    CHECK_THROWS_AS(fit(mesh, [](const Point3& p) { return std::sqrt(p.x() - 0.5); }), core::UsageError);
    CHECK_THROWS_AS(fit(mesh, sphere, {.warp = 0.5}), core::UsageError);
}

TEST_CASE("values at the vertices that are linear between them give a plane exactly") {
    Mesh mesh(lattice({Point3(0, 0, 0), Point3(1, 1, 1)}, 0.1));
    // A box whose faces are planes of the function near them; its edges are as the mesh rounds them.
    const auto box = [](const Point3& p) { return (p - Point3(0.5, 0.5, 0.5)).lpNorm<Eigen::Infinity>() - 0.27; };
    std::vector<double> values;
    for (std::uint32_t i = 0; i < mesh.complex().vertex_capacity(); ++i)
        values.push_back(box(mesh.position(VertexId(i))));
    fit(mesh, values);
    CHECK(validate(mesh).empty());
    std::size_t on_faces = 0, all = 0;
    for (std::uint32_t i = 0; i < mesh.complex().vertex_capacity(); ++i) {
        if (mesh.complex().is_deleted(VertexId(i)) || !mesh.complex().is_interface(VertexId(i))) continue;
        ++all;
        on_faces += std::abs(box(mesh.position(VertexId(i)))) < 1e-12 ? 1 : 0;
    }
    CHECK(on_faces > 0.6 * static_cast<double>(all));
}

TEST_CASE("values have to be one for each vertex") {
    Mesh mesh(lattice({Point3(0, 0, 0), Point3(1, 1, 1)}, 0.5));
    CHECK_THROWS_AS(fit(mesh, std::vector<double>(3, 1.0)), core::UsageError);
}
