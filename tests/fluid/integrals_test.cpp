// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/integrals.h"

#include <catch2/catch.hpp>

#include "tests/fluid/samples.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::fluid;

TEMPLATE_TEST_CASE_SIG("corrected velocities have the momenta that are wanted, and only a rigid motion more", "[fluid]",
                       ((int D), D), 2, 3) {
    core::Random random(tests::seed(1));
    const auto positions = random_velocities<D>(12, random);
    std::vector<double> masses;
    for (std::size_t i = 0; i < positions.size(); ++i) masses.push_back(random.uniform(0.5, 2));
    const auto start = random_velocities<D>(12, random);
    Motion<D> wanted;
    wanted.momentum = Vector<D>::Constant(3);
    wanted.angular_momentum = Rotation<D>::Constant(-2);
    auto velocities = start;
    correct_motion<D>(positions, masses, wanted, velocities);
    const Motion<D> found = motion_of<D>(positions, masses, velocities);
    CHECK((found.momentum - wanted.momentum).norm() < 1e-12);
    CHECK((found.angular_momentum - wanted.angular_momentum).norm() < 1e-12);
    // A rigid motion keeps all distances to first order.
    for (std::size_t i = 1; i < positions.size(); ++i) {
        const Vector<D> change = (velocities[i] - start[i]) - (velocities[0] - start[0]);
        CHECK(std::abs(change.dot(positions[i] - positions[0])) < 1e-12);
    }
}

TEST_CASE("a single vertex takes the momentum and has no use for a spin", "[fluid]") {
    const std::vector<Vector<3>> positions = {Vector<3>(1, 2, 3)};
    const std::vector<double> masses = {2};
    std::vector<Vector<3>> velocities = {Vector<3>::Zero()};
    Motion<3> wanted;
    wanted.momentum = Vector<3>(4, 0, 0);
    wanted.angular_momentum = Vector<3>(0, 0, 100);
    correct_motion<3>(positions, masses, wanted, velocities);
    CHECK(velocities[0] == Vector<3>(2, 0, 0));
}
