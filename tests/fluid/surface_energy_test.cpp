// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/surface_energy.h"

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include "fluid/equilibrium.h"
#include "tests/fluid/samples.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::fluid;

namespace {

template <int D>
SimplexMesh<D> energy_sample() {
    if constexpr (D == 2)
        return square(3, tests::seed(1));
    else
        return cube(0.5);
}

// Shaken, so that nothing is flat.
template <int D>
SimplexMesh<D> shaken() {
    SimplexMesh<D> mesh = energy_sample<D>();
    core::Random random(tests::seed(1));
    const auto ways = random_velocities<D>(mesh.positions.size(), random);
    for (std::size_t i = 0; i < ways.size(); ++i) mesh.positions[i] += 0.03 * ways[i];
    return mesh;
}

template <int D>
Eigen::MatrixXd hessian(const SimplexMesh<D>& mesh, const std::vector<SurfaceElement<D>>& surface, HessianPart part) {
    std::vector<Eigen::Triplet<double, int>> entries;
    add_surface_energy_hessian<D>(mesh.positions, surface, part, 1, entries);
    const auto size = static_cast<Eigen::Index>(mesh.positions.size()) * D;
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("gradient and Hessian of the surface energy are its derivatives", "[fluid]", ((int D), D), 2,
                       3) {
    const SimplexMesh<D> mesh = shaken<D>();
    const auto surface = free_surface(mesh, 1.7);
    core::Random random(tests::seed(2));
    const auto way = random_velocities<D>(mesh.positions.size(), random);
    constexpr double step = 1e-5;
    const auto at = [&](double t) {
        auto places = mesh.positions;
        for (std::size_t i = 0; i < way.size(); ++i) places[i] += t * way[i];
        return places;
    };
    const Eigen::VectorXd gradient = surface_energy_gradient<D>(mesh.positions, surface);
    const double slope = (surface_energy<D>(at(step), surface) - surface_energy<D>(at(-step), surface)) / (2 * step);
    CHECK(slope == Approx(gradient.dot(flat(way))).epsilon(1e-6).margin(1e-8));
    const Eigen::VectorXd change =
        (surface_energy_gradient<D>(at(step), surface) - surface_energy_gradient<D>(at(-step), surface)) / (2 * step);
    CHECK((change - hessian(mesh, surface, HessianPart::whole) * flat(way)).norm() < 1e-5 * change.norm());
}

TEMPLATE_TEST_CASE_SIG("tension pushes and turns nothing as a whole", "[fluid]", ((int D), D), 2, 3) {
    const SimplexMesh<D> mesh = shaken<D>();
    const Eigen::VectorXd gradient = surface_energy_gradient<D>(mesh.positions, free_surface(mesh));
    Vector<D> force = Vector<D>::Zero();
    Rotation<D> torque = Rotation<D>::Zero();
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vector<D> at = gradient.segment<D>(D * static_cast<Eigen::Index>(i));
        force += at;
        torque += moment<D>(mesh.positions[i], at);
    }
    CHECK(force.norm() < 1e-13);
    CHECK(torque.norm() < 1e-13);
}

TEMPLATE_TEST_CASE_SIG("the positive part of the Hessian is positive and no less than the whole", "[fluid]",
                       ((int D), D), 2, 3) {
    const SimplexMesh<D> mesh = shaken<D>();
    const auto surface = free_surface(mesh);
    const Eigen::MatrixXd positive = hessian(mesh, surface, HessianPart::positive);
    const Eigen::MatrixXd rest = positive - hessian(mesh, surface, HessianPart::whole);
    const double size = positive.norm();
    CHECK(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(positive).eigenvalues().minCoeff() > -1e-12 * size);
    CHECK(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(rest).eigenvalues().minCoeff() > -1e-12 * size);
}

TEST_CASE("the polygon of least length for its area is regular", "[fluid]") {
    SimplexMesh<2> mesh = disc(4);
    const auto surface = free_surface(mesh);
    core::Random random(tests::seed(1));
    for (auto& p : mesh.positions) p += Vector<2>(random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01));
    const double area = Elements<2>(mesh).total_volume();
    mesh.positions = equilibrium<2>(mesh.positions, surface);
    CHECK(Elements<2>(mesh).total_volume() == Approx(area).epsilon(1e-12));
    // n sides of length l: area n l^2 / (4 tan(pi / n)).
    const double side = std::sqrt(4 * area * std::tan(std::numbers::pi / 24) / 24);
    for (const auto& element : surface)
        CHECK((mesh.positions[element.vertices[1]] - mesh.positions[element.vertices[0]]).norm() ==
              Approx(side).epsilon(1e-9));
}

TEST_CASE("at least area for its volume, pressure times the normals balances tension", "[fluid]") {
    SimplexMesh<3> mesh = ball(3);
    const auto surface = free_surface(mesh);
    const double volume = Elements<3>(mesh).total_volume(), before = surface_energy<3>(mesh.positions, surface);
    mesh.positions = equilibrium<3>(mesh.positions, surface);
    CHECK(Elements<3>(mesh).total_volume() == Approx(volume).epsilon(1e-12));
    const double area = surface_energy<3>(mesh.positions, surface);
    CHECK(area < before);
    // Scaling changes A by 2 A and V by 3 V, so that the multiplier is 2 A / (3 V).
    Eigen::VectorXd balance = surface_energy_gradient<3>(mesh.positions, surface);
    for (const auto& element : surface)
        for (const std::uint32_t v : element.vertices)
            balance.segment<3>(3 * static_cast<Eigen::Index>(v)) -=
                2 * area / (3 * volume) * area_vector<3>(mesh.positions, element.vertices) / 3;
    CHECK(balance.norm() < 1e-10);
}
