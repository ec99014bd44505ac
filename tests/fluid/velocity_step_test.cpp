// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/velocity_step.h"

#include <catch2/catch.hpp>
#include <numeric>

#include "core/errors.h"
#include "fluid/viscosity.h"
#include "tests/fluid/samples.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::fluid;

namespace {

template <int D>
SimplexMesh<D> sample() {
    if constexpr (D == 2)
        return square(5, tests::seed(1));
    else
        return cube(0.35);
}

template <int D>
struct Sample {
    SimplexMesh<D> mesh;
    Elements<D> elements{mesh};
    std::vector<Facet<D>> all_facets = facets(mesh);
    std::vector<double> masses = lumped_masses<D>(mesh, elements, std::vector<double>{1.0});
    std::vector<double> pressures = std::vector<double>(mesh.cells.size(), 0.0);

    VelocityStep<D> step(double dt) const {
        return {.mesh = mesh, .elements = elements, .facets = all_facets, .dt = dt};
    }
};

// What holds the vertices on the sides of the unit box, all but the one at the top.
template <int D>
std::vector<WallContact<D>> tank(const SimplexMesh<D>& mesh) {
    std::vector<WallContact<D>> contacts;
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
        for (int k = 0; k < D; ++k) {
            if (mesh.positions[v][k] == 0) contacts.push_back({v, -Vector<D>::Unit(k), 0, 2 * k});
            if (mesh.positions[v][k] == 1 && k < D - 1) contacts.push_back({v, Vector<D>::Unit(k), 0, 2 * k + 1});
        }
    return contacts;
}

double fastest(const auto& velocities) {
    double most = 0;
    for (const auto& u : velocities) most = std::max(most, u.norm());
    return most;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("without stabilization velocities are free of divergence in every cell", "[fluid]", ((int D), D),
                       2, 3) {
    Sample<D> fluid{sample<D>()};
    core::Random random(tests::seed(3));
    auto velocities = random_velocities<D>(fluid.mesh.positions.size(), random);
    const double before = fastest(velocities);
    VelocitySolver<D> solver({.stabilization = 0, .solver = {.tolerance = 1e-12}});
    REQUIRE(solver.advance(fluid.step(0.01), fluid.masses, velocities, fluid.pressures).is_converged);
    const Eigen::VectorXd rates = growth_rates(fluid.mesh, velocities);
    for (std::size_t j = 0; j < fluid.mesh.cells.size(); ++j) {
        const double volume = fluid.elements.volumes[j];
        CHECK(std::abs(rates[static_cast<Eigen::Index>(j)]) * std::pow(volume, 1.0 / D) / (volume * before) < 1e-9);
    }
    CHECK(fastest(velocities) > 0.1 * before);  // rigid and affine motions remain at least
}

TEMPLATE_TEST_CASE_SIG("what stabilization lets through does not change the volume or the momentum", "[fluid]",
                       ((int D), D), 2, 3) {
    Sample<D> fluid{sample<D>()};
    core::Random random(tests::seed(3));
    auto velocities = random_velocities<D>(fluid.mesh.positions.size(), random);
    const Motion<D> before = motion_of<D>(fluid.mesh.positions, fluid.masses, velocities);
    VelocitySolver<D> solver({.stabilization = 0.5});
    VelocityStep<D> step = fluid.step(0.01);
    const auto surface = free_surface(fluid.mesh);
    step.surface = surface;
    REQUIRE(solver.advance(step, fluid.masses, velocities, fluid.pressures).is_converged);
    const Eigen::VectorXd rates = growth_rates(fluid.mesh, velocities);
    CHECK(rates.cwiseAbs().maxCoeff() > 1e-6);
    CHECK(std::abs(rates.sum()) < 1e-10);
    const Motion<D> after = motion_of<D>(fluid.mesh.positions, fluid.masses, velocities);
    CHECK((after.momentum - before.momentum).norm() < 1e-12);
    CHECK((after.angular_momentum - before.angular_momentum).norm() < 1e-12);
}

TEST_CASE("Cholesky and conjugate gradients agree", "[fluid]") {
    Sample<2> fluid{sample<2>()};
    core::Random random(tests::seed(3));
    const auto start = random_velocities<2>(fluid.mesh.positions.size(), random);
    auto direct = start, iterated = start;
    auto pressures = fluid.pressures;
    VelocitySolver<2> cholesky({.solver = {.solver = PressureSolver::cholesky}}), gradients({});
    REQUIRE(cholesky.advance(fluid.step(0.01), fluid.masses, direct, pressures).is_converged);
    REQUIRE(gradients.advance(fluid.step(0.01), fluid.masses, iterated, fluid.pressures).is_converged);
    CHECK((flat(direct) - flat(iterated)).norm() < 1e-8);
}

// Triangles of the same direction at two clamped sides: each has one corner that is free, and its two divergences are
// the two components there, so that nothing can move, from corner to corner. See 6.4.
TEST_CASE("elements lock without stabilization, and don't with it", "[fluid]") {
    Sample<2> fluid{regular_square(8)};
    std::vector<WallContact<2>> clamps;
    for (std::uint32_t v = 0; v < fluid.mesh.positions.size(); ++v) {
        if (fluid.mesh.positions[v].minCoeff() > 0) continue;
        clamps.push_back({v, Vector<2>::UnitX(), 0});
        clamps.push_back({v, Vector<2>::UnitY(), 0});
    }
    std::vector<Vector<2>> pull;
    for (const auto& p : fluid.mesh.positions) pull.push_back({p.y() * p.y(), 0});
    VelocityStep<2> step = fluid.step(0.1);
    step.contacts = clamps;
    step.accelerations = pull;
    const auto speed = [&](double stabilization) {
        std::vector<Vector<2>> velocities(fluid.mesh.positions.size(), Vector<2>::Zero());
        auto pressures = fluid.pressures;
        VelocitySolver<2> solver({.stabilization = stabilization, .solver = {.tolerance = 1e-12}});
        REQUIRE(solver.advance(step, fluid.masses, velocities, pressures).is_converged);
        return fastest(velocities);
    };
    CHECK(speed(0) < 1e-9);
    CHECK(speed(FluidParameters<2>().stabilization) > 0.01);  // the pull alone would give 0.1
}

TEMPLATE_TEST_CASE_SIG("water in a tank stays at rest under its hydrostatic pressure", "[fluid]", ((int D), D), 2, 3) {
    Sample<D> fluid{sample<D>()};
    const auto contacts = tank(fluid.mesh);
    std::vector<Vector<D>> velocities(fluid.mesh.positions.size(), Vector<D>::Zero());
    VelocitySolver<D> solver({.gravity = -9.81 * Vector<D>::Unit(D - 1), .solver = {.tolerance = 1e-12}});
    VelocityStep<D> step = fluid.step(0.01);
    step.contacts = contacts;
    REQUIRE(solver.advance(step, fluid.masses, velocities, fluid.pressures).is_converged);
    CHECK(fastest(velocities) < 1e-10);
    for (std::size_t j = 0; j < fluid.mesh.cells.size(); ++j)
        CHECK(fluid.pressures[j] == Approx(9.81 * (1 - centroid(fluid.mesh, j)[D - 1])).epsilon(1e-7).margin(1e-7));
}

TEST_CASE("a piston drives the fluid with its own speed", "[fluid]") {
    Sample<2> fluid{square(5, tests::seed(1))};
    auto contacts = tank(fluid.mesh);
    for (auto& contact : contacts)
        if (contact.normal == -Vector<2>::UnitX()) contact.speed = -0.5;  // inwards, on the left
    std::vector<Vector<2>> velocities(fluid.mesh.positions.size(), Vector<2>::Zero());
    VelocityStep<2> step = fluid.step(0.01);
    step.contacts = contacts;
    VelocitySolver<2> solver({});
    REQUIRE(solver.advance(step, fluid.masses, velocities, fluid.pressures).is_converged);
    for (const auto& contact : contacts)
        CHECK(velocities[contact.vertex].dot(contact.normal) == Approx(contact.speed).margin(1e-14));
    CHECK(std::abs(growth_rates(fluid.mesh, velocities).sum()) < 1e-10);  // what is pushed in goes out at the top
}

TEMPLATE_TEST_CASE_SIG("viscosity dissipates 2 mu |strain rate|^2, and nothing in rigid motion", "[fluid]",
                       ((int D), D), 2, 3) {
    const SimplexMesh<D> mesh = sample<D>();
    std::vector<Eigen::Triplet<double, int>> entries;
    add_viscosity_matrix<D>(mesh, Elements<D>(mesh), std::vector<double>{0.7}, 1, entries);
    Eigen::SparseMatrix<double> matrix(D * static_cast<int>(mesh.positions.size()),
                                       D * static_cast<int>(mesh.positions.size()));
    matrix.setFromTriplets(entries.begin(), entries.end());
    core::Random random(tests::seed(3));
    Eigen::Matrix<double, D, D> gradient;
    for (int i = 0; i < D * D; ++i) gradient(i / D, i % D) = random.uniform(-1, 1);
    const auto dissipation = [&](const Eigen::Matrix<double, D, D>& g) {
        std::vector<Vector<D>> velocities;
        for (const auto& p : mesh.positions) velocities.push_back(g * p + Vector<D>::Ones());
        return flat(velocities).dot(matrix * flat(velocities));
    };
    const Eigen::Matrix<double, D, D> strain = 0.5 * (gradient + gradient.transpose());
    CHECK(dissipation(gradient) == Approx(2 * 0.7 * strain.squaredNorm()).epsilon(1e-12));
    CHECK(std::abs(dissipation(gradient - gradient.transpose())) < 1e-13);
}

TEST_CASE("parameters of fluids that can't be are refused by name", "[fluid]") {
    using Parameters = FluidParameters<3>;
    CHECK_THROWS_WITH(VelocitySolver<3>(Parameters{.phases = {{.density = 0}}}), Catch::Contains("density"));
    CHECK_THROWS_WITH(VelocitySolver<3>(Parameters{.phases = {{.viscosity = -1}}}), Catch::Contains("viscosity"));
    CHECK_THROWS_WITH(VelocitySolver<3>(Parameters{.phases = {}}), Catch::Contains("phases"));
    CHECK_THROWS_WITH(VelocitySolver<3>(Parameters{.stabilization = -1}), Catch::Contains("stabilization"));
    CHECK_THROWS_WITH(VelocitySolver<3>(Parameters{.solver = {.tolerance = 0}}), Catch::Contains("tolerance"));
}
