// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/facets.h"

#include <catch2/catch.hpp>

#include "tests/fluid/samples.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::fluid;

TEMPLATE_TEST_CASE_SIG("facets point out of their cells and close the surface of the fluid", "[fluid]", ((int D), D), 2,
                       3) {
    const auto mesh = [] {
        if constexpr (D == 2)
            return square(4, tests::seed(1));
        else
            return cube(0.4);
    }();
    const auto all = facets(mesh);
    std::size_t inner = 0;
    Vector<D> sum = Vector<D>::Zero();
    double volume = 0;
    for (const auto& facet : all) {
        const Vector<D> area = area_vector<D>(mesh.positions, facet.vertices);
        CHECK(area.dot(mesh.positions[facet.vertices[0]] - centroid(mesh, facet.cell)) > 0);
        if (facet.opposite) {
            ++inner;
            CHECK(area.dot(centroid(mesh, *facet.opposite) - mesh.positions[facet.vertices[0]]) > 0);
        } else {
            sum += area;
            volume += area.dot(mesh.positions[facet.vertices[0]]) / D;
        }
    }
    CHECK(2 * inner + (all.size() - inner) == (D + 1) * mesh.cells.size());
    CHECK(sum.norm() < 1e-13);
    CHECK(volume == Approx(1).epsilon(1e-12));  // divergence theorem
}
