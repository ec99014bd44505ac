// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/interpolation.h"

#include <catch2/catch.hpp>

#include "tests/fluid/samples.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::fluid;

TEMPLATE_TEST_CASE_SIG("affine fields are interpolated exactly", "[fluid]", ((int D), D), 2, 3) {
    const auto mesh = [] {
        if constexpr (D == 2)
            return square(5, tests::seed(1));
        else
            return cube(0.3);
    }();
    core::Random random(tests::seed(2));
    const auto field = [](const Vector<D>& p) { return Vector<D>(3 * Vector<D>::Ones() - 2 * p.reverse()); };
    std::vector<Vector<D>> values;
    for (const auto& p : mesh.positions) values.push_back(field(p));
    const Interpolation<D> interpolation(mesh);
    for (int i = 0; i < 200; ++i) {
        Vector<D> place;
        for (int k = 0; k < D; ++k) place[k] = random.uniform();
        CHECK((interpolation.value_at(place, values) - field(place)).norm() < 1e-12);
    }
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        CHECK((interpolation.value_at(mesh.positions[v], values) - values[v]).norm() < 1e-12);
}

TEMPLATE_TEST_CASE_SIG("outside of the fluid the value is that of the nearest place of its surface", "[fluid]",
                       ((int D), D), 2, 3) {
    const auto mesh = [] {
        if constexpr (D == 2)
            return square(4, tests::seed(1));
        else
            return cube(0.3);
    }();
    core::Random random(tests::seed(2));
    const Interpolation<D> interpolation(mesh);
    for (int i = 0; i < 100; ++i) {
        Vector<D> place;
        for (int k = 0; k < D; ++k) place[k] = random.uniform(-1, 2);
        const Vector<D> nearest = place.cwiseMax(0.0).cwiseMin(1.0);  // of the unit box
        CHECK((interpolation.value_at(place, mesh.positions) - nearest).norm() < 1e-12);
    }
}
