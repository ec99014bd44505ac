// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/elements.h"

#include <catch2/catch.hpp>
#include <numeric>

#include "tests/fluid/samples.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::fluid;

TEST_CASE("masses of the vertices sum to that of the fluid", "[fluid]") {
    const std::vector<double> densities = {2.5};
    const SimplexMesh<2> plane = disc(6);
    const auto masses2 = lumped_masses<2>(plane, Elements<2>(plane), densities);
    const double area = 0.5 * 36 * std::sin(2 * std::numbers::pi / 36);  // of a regular polygon with 36 corners
    CHECK(std::accumulate(masses2.begin(), masses2.end(), 0.0) == Approx(2.5 * area).epsilon(1e-12));
    const SimplexMesh<3> space = cube(0.3);
    const auto masses3 = lumped_masses<3>(space, Elements<3>(space), densities);
    CHECK(std::accumulate(masses3.begin(), masses3.end(), 0.0) == Approx(2.5).epsilon(1e-12));
}

TEMPLATE_TEST_CASE_SIG("the divergence is exact for affine velocities", "[fluid]", ((int D), D), 2, 3) {
    const auto mesh = [] {
        if constexpr (D == 2)
            return square(5, tests::seed(1));
        else
            return cube(0.3);
    }();
    core::Random random(tests::seed(1));
    Eigen::Matrix<double, D, D> gradient;
    for (int i = 0; i < D * D; ++i) gradient(i / D, i % D) = random.uniform(-1, 1);
    std::vector<Vector<D>> velocities;
    for (const auto& p : mesh.positions) velocities.push_back(gradient * p + Vector<D>::Ones());
    const Eigen::VectorXd rates = growth_rates(mesh, velocities);
    const Elements<D> elements(mesh);
    for (std::size_t j = 0; j < mesh.cells.size(); ++j)
        CHECK(rates[static_cast<Eigen::Index>(j)] ==
              Approx(gradient.trace() * elements.volumes[j]).epsilon(1e-12).margin(1e-15));
}

TEMPLATE_TEST_CASE_SIG("D u is the change of volume, cell by cell", "[fluid]", ((int D), D), 2, 3) {
    auto mesh = [] {
        if constexpr (D == 2)
            return square(5, tests::seed(1));
        else
            return cube(0.4);
    }();
    core::Random random(tests::seed(1));
    const auto velocities = random_velocities<D>(mesh.positions.size(), random);
    const Eigen::VectorXd rates = growth_rates(mesh, velocities);
    constexpr double dt = 1e-6;
    auto volumes_at = [&](double t) {
        auto moved = mesh;
        for (std::size_t i = 0; i < velocities.size(); ++i) moved.positions[i] += t * velocities[i];
        return Elements<D>(moved).volumes;
    };
    const auto before = volumes_at(-dt), after = volumes_at(dt);
    for (std::size_t j = 0; j < before.size(); ++j)
        CHECK((after[j] - before[j]) / (2 * dt) == Approx(rates[static_cast<Eigen::Index>(j)]).margin(1e-8));
}
