// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/flow.h"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <complex>

#include "core/errors.h"
#include "fluid/equilibrium.h"
#include "tests/fluid/samples.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::fluid;

namespace {

template <int D>
FlowParameters<D> water(double tension = 1) {
    return {.fluid = {}, .tensions = {.free_surface = {tension}}};
}

template <int D>
SimplexMesh<D> drop_at_rest(int resolution) {
    SimplexMesh<D> mesh;
    if constexpr (D == 2)
        mesh = disc(resolution);
    else
        mesh = ball(static_cast<std::uint32_t>(resolution));
    mesh.positions = equilibrium<D>(mesh.positions, free_surface(mesh));
    return mesh;
}

// The n-th Fourier coefficient of the radius of the outline.
double mode(const SimplexMesh<2>& mesh, const std::vector<SurfaceElement<2>>& surface, int n) {
    double sum = 0;
    for (const auto& element : surface) {
        const Vector<2> a = mesh.positions[element.vertices[0]], b = mesh.positions[element.vertices[1]];
        const Vector<2> middle = 0.5 * (a + b);
        const double angle = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
        sum += angle * middle.norm() * std::cos(n * std::atan2(middle.y(), middle.x()));
    }
    return sum / std::numbers::pi;
}

struct Oscillation {
    double frequency;
    double decay;
};

// The damped cosine that fits best, by search in its two parameters around those that are expected.
Oscillation fitted(const std::vector<double>& times, const std::vector<double>& values, Oscillation found) {
    const auto error = [&](const Oscillation& guess) {
        Eigen::MatrixXd basis(static_cast<Eigen::Index>(times.size()), 3);
        for (Eigen::Index i = 0; i < basis.rows(); ++i) {
            const double t = times[static_cast<std::size_t>(i)], size = std::exp(-guess.decay * t);
            basis.row(i) << 1, size * std::cos(guess.frequency * t), size * std::sin(guess.frequency * t);
        }
        const Eigen::Map<const Eigen::VectorXd> data(values.data(), basis.rows());
        return (basis * basis.householderQr().solve(data) - data).norm();
    };
    double width = 0.2 * found.frequency;
    for (int round = 0; round < 10; ++round, width /= 2) {
        const Oscillation middle = found;
        for (int i = -4; i <= 4; ++i)
            for (int k = -4; k <= 4; ++k) {
                const Oscillation guess{middle.frequency + i * width / 4, middle.decay + k * width / 4};
                if (error(guess) < error(found)) found = guess;
            }
    }
    return found;
}

// A disc whose outline is that of mode n with 3 % of the radius, for two periods.
Oscillation oscillation(int rings, int n, double viscosity) {
    FlowParameters<2> parameters = water<2>();
    parameters.fluid.phases[0].viscosity = viscosity;
    parameters.fluid.solver.tolerance = 1e-8;
    parameters.compensation = 0;
    Flow<2> flow(parameters);
    SimplexMesh<2> mesh = drop_at_rest<2>(rings);
    const double area = Elements<2>(mesh).total_volume(), radius = std::sqrt(area / std::numbers::pi);
    // The gradient of Re (x + i y)^n / n: a displacement without divergence.
    for (auto& p : mesh.positions) {
        const std::complex<double> power = std::pow(std::complex<double>(p.x(), p.y()) / radius, n - 1);
        p += 0.03 * radius * Vector<2>(power.real(), -power.imag());
    }
    FlowState<2> state = flow.at_rest(mesh);
    const auto surface = free_surface(state.mesh);
    const double frequency = std::sqrt(n * (n * n - 1) / std::pow(radius, 3));
    std::vector<double> times, values;
    double time = 0;
    while (time < 2 * 2 * std::numbers::pi / frequency) {
        times.push_back(time);
        values.push_back(mode(state.mesh, surface, n));
        const double dt = flow.longest_step(state, {});
        flow.step(state, {}, dt);
        time += dt;
    }
    const Oscillation found = fitted(times, values, {frequency, 0.01 * frequency});
    return {found.frequency / frequency, found.decay * radius * radius};
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a drop in free fall falls as its integrator does, and keeps its shape", "[fluid]", ((int D), D),
                       2, 3) {
    FlowParameters<D> parameters = water<D>();
    parameters.fluid.gravity = -9.81 * Vector<D>::Unit(D - 1);
    Flow<D> flow(parameters);
    FlowState<D> state = flow.at_rest(drop_at_rest<D>(3));
    const auto start = state.mesh.positions;
    constexpr double dt = 0.01;
    double fallen = 0, speed = 0;
    for (int i = 0; i < 20; ++i) {
        flow.step(state, {}, dt);
        speed -= 9.81 * dt;
        fallen += speed * dt;
    }
    for (std::size_t i = 0; i < start.size(); ++i)
        CHECK((state.mesh.positions[i] - start[i] - fallen * Vector<D>::Unit(D - 1)).norm() < 1e-9);
}

TEMPLATE_TEST_CASE_SIG("a drop of least surface stays, with Laplace's pressure", "[fluid]", ((int D), D), 2, 3) {
    Flow<D> flow(water<D>(2.5));
    FlowState<D> state = flow.at_rest(drop_at_rest<D>(3));
    const auto start = state.mesh.positions;
    for (int i = 0; i < 50; ++i) flow.step(state, {}, flow.longest_step(state, {}));
    double displacement = 0;
    for (std::size_t i = 0; i < start.size(); ++i)
        displacement = std::max(displacement, (state.mesh.positions[i] - start[i]).norm());
    CHECK(displacement < 1e-9);
    const double area = surface_energy<D>(state.mesh.positions, free_surface(state.mesh));
    const double jump = (D - 1) * 2.5 * area / (D * Elements<D>(state.mesh).total_volume());
    for (const double pressure : state.pressures) CHECK(pressure == Approx(jump).epsilon(1e-6));
}

TEMPLATE_TEST_CASE_SIG("a drop that tumbles keeps its momenta", "[fluid]", ((int D), D), 2, 3) {
    FlowParameters<D> parameters = water<D>();
    parameters.compensation = 0;
    Flow<D> flow(parameters);
    FlowState<D> state = flow.at_rest(drop_at_rest<D>(3));
    for (std::size_t i = 0; i < state.velocities.size(); ++i) {
        const Vector<D>& p = state.mesh.positions[i];
        state.velocities[i] =
            Vector<D>::Unit(0) + 0.5 * Vector<D>::Unit(0) * p[1] + 0.3 * p[0] * p[0] * Vector<D>::Unit(1);
    }
    const auto motion = [&] { return motion_of<D>(state.mesh.positions, state.masses, state.velocities); };
    const Motion<D> before = motion();
    for (int i = 0; i < 100; ++i) flow.step(state, {}, flow.longest_step(state, {}));
    CHECK((motion().momentum - before.momentum).norm() < 1e-12);
    CHECK((motion().angular_momentum - before.angular_momentum).norm() < 1e-11);
}

TEST_CASE("drops in the plane oscillate with Rayleigh's periods, the better the finer", "[fluid]") {
    const double coarse = oscillation(5, 2, 0).frequency, fine = oscillation(10, 2, 0).frequency;
    CHECK(std::abs(1 / fine - 1) < 0.02);
    CHECK(std::abs(1 / fine - 1) < std::abs(1 / coarse - 1) / 3);
}

TEST_CASE("viscosity damps an oscillation in the plane as Lamb says", "[fluid]") {
    constexpr int n = 2;
    constexpr double viscosity = 0.02;
    const double inviscid = oscillation(8, n, 0).decay, viscous = oscillation(8, n, viscosity).decay;
    CHECK(inviscid < 0.15 * 2 * n * (n - 1) * viscosity);
    CHECK(viscous == Approx(2 * n * (n - 1) * viscosity).epsilon(0.15));
}

TEST_CASE("the pressure in a rotating disc grows with the square of the distance", "[fluid]") {
    constexpr double turn = 2, dt = 1e-3;
    Flow<2> flow(water<2>(0));
    FlowState<2> state = flow.at_rest(disc(20));
    const auto rotation = [&](std::size_t i) {
        return Vector<2>(turn * Vector<2>(-state.mesh.positions[i].y(), state.mesh.positions[i].x()));
    };
    for (std::size_t i = 0; i < state.velocities.size(); ++i) state.velocities[i] = rotation(i);
    for (int i = 0; i < 20; ++i) flow.step(state, {}, dt);
    // The pressure is zero at the radius of the disc of the polygon's area.
    const double radius_squared = Elements<2>(state.mesh).total_volume() / std::numbers::pi;
    for (std::size_t j = 0; j < state.mesh.cells.size(); ++j) {
        const double expected = 0.5 * turn * turn * (centroid(state.mesh, j).squaredNorm() - radius_squared);
        CHECK(std::abs(state.pressures[j] - expected) < 0.01 * 0.5 * turn * turn);
    }
    for (std::size_t i = 0; i < state.velocities.size(); ++i)
        CHECK((state.velocities[i] - rotation(i)).norm() < 0.01 * turn);
}

TEST_CASE("a piston that moves for long keeps the volume of the fluid", "[fluid]") {
    FlowParameters<2> parameters = water<2>(0);
    parameters.fluid.gravity = {0, -9.81};
    Flow<2> flow(parameters);
    FlowState<2> state = flow.at_rest(square(6, tests::seed(1)));
    std::vector<WallContact<2>> contacts;
    for (std::uint32_t v = 0; v < state.mesh.positions.size(); ++v) {
        const Vector<2>& p = state.mesh.positions[v];
        if (p.x() == 0) contacts.push_back({v, Vector<2>(-1, 0), -0.2, 0});
        if (p.x() == 1) contacts.push_back({v, Vector<2>(1, 0), 0, 1});
        if (p.y() == 0) contacts.push_back({v, Vector<2>(0, -1), 0, 2});
    }
    double time = 0;
    while (time < 1) {
        const double dt = std::min(flow.longest_step(state, contacts), 1 - time);
        flow.step(state, contacts, dt);
        time += dt;
        CHECK(Elements<2>(state.mesh).total_volume() == Approx(1).epsilon(1e-3));
    }
    for (const auto& contact : contacts) {
        if (contact.wall == 0) CHECK(state.mesh.positions[contact.vertex].x() == Approx(0.2).epsilon(1e-9));
        if (contact.wall == 2) CHECK(state.mesh.positions[contact.vertex].y() == Approx(0).margin(1e-12));
    }
}

TEST_CASE("second order tension is stable far beyond the capillary limit", "[fluid]") {
    FlowParameters<2> parameters = water<2>();
    parameters.fluid.has_second_order_tension = true;
    parameters.capillary_share = 10;
    Flow<2> flow(parameters);
    SimplexMesh<2> mesh = drop_at_rest<2>(6);
    for (auto& p : mesh.positions) p = {1.1 * p.x(), p.y() / 1.1};
    FlowState<2> state = flow.at_rest(mesh);
    double last = flow.energies(state, {}).sum();
    const double first = last;
    for (int i = 0; i < 60; ++i) {
        flow.step(state, {}, flow.longest_step(state, {}));
        last = flow.energies(state, {}).sum();
        REQUIRE(last < first);
    }
    // Nearly at rest again: backward Euler damps what it does not resolve.
    const double radius = std::sqrt(Elements<2>(state.mesh).total_volume() / std::numbers::pi);
    CHECK(last < 2 * std::numbers::pi * radius * 1.01);
}

TEST_CASE("a fluid that is not finite ends the run before anything changes", "[fluid]") {
    Flow<2> flow(water<2>());
    FlowState<2> state = flow.at_rest(disc(3));
    state.velocities[3].x() = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(flow.step(state, {}, 0.01), core::RunError);
    CHECK(state.mesh.positions[0] == Vector<2>::Zero());
    CHECK(state.pressures == std::vector<double>(state.mesh.cells.size(), 0.0));
}
