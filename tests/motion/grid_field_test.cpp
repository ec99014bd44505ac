// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/grid_field.h"

#include <catch2/catch.hpp>
#include <numbers>

#include "core/random.h"
#include "motion/fields.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::motion;

namespace {

/// `field` at time 0 on n points along each side of the unit box.
template <int Dimension>
VelocityField<Dimension> sampled(const VelocityField<Dimension>& field, std::size_t n) {
    VelocityGrid<Dimension> grid;
    grid.spacing.setConstant(1 / static_cast<double>(n - 1));
    std::size_t points = 1;
    for (std::size_t& count : grid.counts) points *= count = n;
    for (std::size_t i = 0; i < points; ++i) {
        Vector<Dimension> x;
        std::size_t rest = i;
        for (int k = 0; k < Dimension; ++k, rest /= n) x[k] = static_cast<double>(rest % n) * grid.spacing[k];
        grid.velocities.push_back(field(x, 0));
    }
    return grid_field(std::move(grid));
}

double error(std::size_t n) {
    const VelocityField<3> exact = enright_deformation({}), grid = sampled<3>(exact, n);
    core::Random random(tests::seed(1));
    double largest = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Vector<3> x(random.uniform(), random.uniform(), random.uniform());
        largest = std::max(largest, (exact(x, 0) - grid(x, 0)).norm());
    }
    return largest;
}

}  // namespace

TEST_CASE("what is linear in each coordinate is exact between the points of a grid") {
    const VelocityField<3> in_space = [](const Vector<3>& p, double) {
        return Vector<3>(1 + p.x() * p.y() * p.z(), p.x() - 2 * p.z(), p.y() * p.z());
    };
    const VelocityField<2> in_plane = [](const Vector<2>& p, double) { return Vector<2>(p.x() * p.y(), 3 - p.y()); };
    const VelocityField<3> grid = sampled<3>(in_space, 5);
    const VelocityField<2> plane = sampled<2>(in_plane, 4);
    core::Random random(tests::seed(2));
    for (int i = 0; i < 200; ++i) {
        const Vector<3> x(random.uniform(), random.uniform(), random.uniform());
        CHECK((grid(x, 0) - in_space(x, 0)).norm() < 1e-14);
        CHECK((plane(x.head<2>(), 0) - in_plane(x.head<2>(), 0)).norm() < 1e-14);
    }
}

TEST_CASE("the error of a smooth field falls with the square of the spacing") {
    CHECK(error(21) / error(41) == Approx(4).epsilon(0.1));
}

TEST_CASE("outside the grid the velocity is that of the nearest place on it") {
    const VelocityField<3> grid = sampled<3>(enright_deformation({}), 9);
    core::Random random(tests::seed(3));
    for (int i = 0; i < 100; ++i) {
        const Vector<3> x(random.uniform(-1, 2), random.uniform(-1, 2), random.uniform(-1, 2));
        CHECK(grid(x, 0) == grid(x.cwiseMax(0).cwiseMin(1), 5));
    }
    CHECK(std::isnan(grid({NAN, 0, 0}, 0).x()));
}

TEST_CASE("a grid of one point is constant, one layer does not depend on its coordinate") {
    VelocityGrid<2> grid{.counts = {1, 2}, .velocities = {{0, 0}, {1, 2}}};
    CHECK(grid_field<2>(grid)({77, 0.25}, 0) == Vector<2>(0.25, 0.5));
}

TEST_CASE("grids that are not valid are refused by name") {
    VelocityGrid<2> grid{.counts = {2, 2}, .velocities = {{0, 0}, {1, 2}}};
    CHECK_THROWS_WITH(grid_field<2>(grid), Catch::StartsWith("velocities"));
    grid.counts = {0, 2};
    CHECK_THROWS_WITH(grid_field<2>(grid), Catch::StartsWith("counts"));
    grid.spacing = {0, 1};
    CHECK_THROWS_AS(grid_field<2>(grid), core::UsageError);
}
