// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/generate/lattice.h"

#include <catch2/catch.hpp>
#include <numbers>

#include "core/errors.h"
#include "dsc3d/improve/angle_range.h"
#include "dsc3d/mesh.h"

using namespace dsc;
using namespace dsc::dsc3d;

TEST_CASE("a lattice fills its box with tetrahedra of 45 degrees and more") {
    const Point3 low(-1, 2, 0.1), high(0.5, 2.7, 1.3);
    const Mesh mesh(lattice({low, high}, 0.1));
    CHECK(validate(mesh).empty());
    double volume = 0;
    const geometry::TetData data = mesh.data();
    for (const auto& [a, b, c, d] : data.tets) {
        const Point3& p = data.vertices[a];
        volume += (data.vertices[b] - p).dot((data.vertices[c] - p).cross(data.vertices[d] - p)) / 6;
    }
    CHECK(volume == Approx((high - low).prod()).epsilon(1e-12));
    const AngleRange range(mesh);
    CHECK(range.min > 44.9 * std::numbers::pi / 180);
    CHECK(range.max < 120.1 * std::numbers::pi / 180);
    for (const Point3& p : data.vertices) {
        CHECK((p.array() >= low.array()).all());
        CHECK((p.array() <= high.array()).all());
    }
}

TEST_CASE("a lattice says what is wrong with its box or spacing") {
    const Eigen::AlignedBox3d box(Point3(0, 0, 0), Point3(1, 1, 1));
    CHECK_THROWS_AS(lattice(box, 0), core::UsageError);
    CHECK_THROWS_AS(lattice(box, 1e-5), core::UsageError);
    CHECK_THROWS_AS(lattice(Eigen::AlignedBox3d(Point3(0, 0, 0), Point3(1, 0, 1)), 0.1), core::UsageError);
}
